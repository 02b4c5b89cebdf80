#include "lesson/save.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/decimal.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/problem.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

constexpr int kWidth = 120;  // characters of a line that can be broken
constexpr std::string_view kIndent = "    ";

/// What stands between the quotes.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string as_text(std::string_view text) { return '"' + escaped(text) + '"'; }

std::vector<std::string> as_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> out;
  for (const std::string& text : texts) out.push_back(as_text(text));
  return out;
}

template <class E>
std::vector<std::string> names_as_texts(const std::vector<E>& values) {
  std::vector<std::string> out;
  for (const E value : values) out.push_back(as_text(name_of(value)));
  return out;
}

std::string in_brackets(const Vector2d& point) {
  return fmt::format("[{}, {}]", decimal(point.x()), decimal(point.y()));
}

std::vector<std::string> texts_of(const std::vector<double>& numbers) {
  std::vector<std::string> out;
  for (const double number : numbers) out.push_back(decimal(number));
  return out;
}

std::vector<std::string> in_brackets(const std::vector<Vector2d>& points) {
  std::vector<std::string> out;
  for (const Vector2d& point : points) out.push_back(in_brackets(point));
  return out;
}

/// 0.0 and -0.0 differ.
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Where a line of TOML's long texts may begin. Parsers skip what they take for a blank: ' ' and,
/// some of them, Unicode's, which are in the ranges left out here.
bool may_begin_line(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte > ' ' && byte < 0x80) || (byte >= 0xC3 && byte < 0xE0);
}

/// On one line where it fits, else filled lines that each end with a backslash.
std::string long_text(std::string_view text, std::string_view key) {
  std::string short_form = as_text(text);
  const int short_width =
      character_count(key) + character_count(" = ") + character_count(short_form);
  if (short_width <= kWidth || !may_begin_line(text.front())) return short_form;
  std::string out = "\"\"\"";
  int width = kWidth;
  while (!text.empty()) {
    std::size_t end = 1;  // of a word and the blanks behind it
    while (end < text.size() && !(text[end - 1] == ' ' && may_begin_line(text[end]))) ++end;
    const std::string word = escaped(text.substr(0, end));
    text.remove_prefix(end);
    width += character_count(word);
    if (width >= kWidth) {
      out += fmt::format("\\\n{}", kIndent);
      width = character_count(kIndent) + character_count(word);
    }
    out += word;
  }
  return out + "\"\"\"";
}

/// The text of a file, key by key.
class TomlText {
 public:
  /// The table that the next keys belong to; without any it is not written.
  void table(std::string_view header) { header_ = header; }

  void key(std::string_view name, std::string_view value) {
    if (!header_.empty()) {
      text_ += fmt::format("\n{}\n", header_);
      header_.clear();
    }
    text_ += fmt::format("{} = {}\n", name, value);
  }

  /// The table that was begun, though it has no keys.
  void write_empty() {
    if (!header_.empty()) text_ += fmt::format("\n{}\n", header_);
    header_.clear();
  }

  /// On one line where it fits.
  void list(std::string_view name, const std::vector<std::string>& entries) {
    const std::string one_line = fmt::format("[{}]", fmt::join(entries, ", "));
    if (character_count(name) + character_count(" = ") + character_count(one_line) <= kWidth) {
      key(name, one_line);
      return;
    }
    std::string lines = "[";
    int width = kWidth;
    for (const std::string& entry : entries) {
      width += character_count(" ,") + character_count(entry);
      if (width > kWidth) {
        lines += fmt::format("\n{}", kIndent);
        width = character_count(kIndent) + character_count(entry) + 1;
      } else {
        lines += ' ';
      }
      lines += entry + ",";
    }
    key(name, lines + "\n]");
  }

  template <class E>
  void choice(std::string_view name, E value, E otherwise) {
    if (value != otherwise) key(name, as_text(name_of(value)));
  }
  void number(std::string_view name, double value, double otherwise) {
    if (!same_bits(value, otherwise)) key(name, decimal(value));
  }
  void whole_number(std::string_view name, int value, int otherwise) {
    if (value != otherwise) key(name, std::to_string(value));
  }
  void text(std::string_view name, std::string_view value, std::string_view otherwise) {
    if (value != otherwise) key(name, as_text(value));
  }

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::string header_;
};

void write_shape(TomlText& out, const LessonShape& shape, std::string_view key) {
  out.table(fmt::format("[shapes.{}]", key));
  out.text("name", shape.name, key);
  if (shape.vertex_names != default_vertex_names(shape, key))
    out.list("names", as_texts(shape.vertex_names));
  out.list("vertices", in_brackets(shape.vertices));
  std::vector<std::string> outlines;
  for (const int count : shape.outlines) outlines.push_back(std::to_string(count));
  if (!outlines.empty()) out.list("outlines", outlines);
  if (!same_bits(shape.translate.x(), 0.0) || !same_bits(shape.translate.y(), 0.0))
    out.key("translate", in_brackets(shape.translate));
  out.number("rotate", shape.rotate_degrees, 0.0);
  out.number("radius", shape.radius, 0.0);
}

void write_start(TomlText& out, const Lesson& lesson) {
  const gjk::Options& options = lesson.options;
  if (options.start.count == 0) {
    out.key("start", as_text("centre-to-centre"));
    return;
  }
  if (options.start.count == 1 && options.start.pairs[0] == gjk::VertexPair{}) return;
  std::vector<std::string> names;
  for (int i = 0; i < options.start.count; ++i) {
    const gjk::VertexPair pair = options.start.pairs[i];
    std::string name = lesson.y().vertex_names[pair.y];
    if (lesson.x().vertices.size() > 1) name += "-" + lesson.x().vertex_names[pair.x];
    names.push_back(as_text(name));
  }
  out.list("start", names);
}

void write_query(TomlText& out, const Lesson& lesson) {
  const Lesson defaults;
  const gjk::Options& options = lesson.options;
  out.table("[query]");
  out.choice("scalar", lesson.scalar, defaults.scalar);
  if (lesson.beside) out.key("beside", as_text(name_of(*lesson.beside)));
  out.choice("direction", options.direction_rule, defaults.options.direction_rule);
  out.choice("regions", options.region_order, defaults.options.region_order);
  if (!options.stop_on_repeated_support || !options.stop_on_no_progress) {
    std::vector<gjk::StopReason> tests;
    if (options.stop_on_repeated_support) tests.push_back(gjk::StopReason::repeated_support);
    if (options.stop_on_no_progress) tests.push_back(gjk::StopReason::no_progress);
    out.list("stop", names_as_texts(tests));
  }
  out.number("tolerance", options.tolerance, defaults.options.tolerance);
  out.whole_number("cap", options.iteration_cap, defaults.options.iteration_cap);
  write_start(out, lesson);
  if (lesson.warm_start) out.key("warm", "true");
  out.choice("volumes", lesson.volumes, defaults.volumes);
  out.number("tile", lesson.tile, defaults.tile);
}

void write_steps(TomlText& out, const Lesson& lesson) {
  out.table("[steps]");
  out.text("granularity", lesson.act, Lesson().act);
  if (lesson.until) out.key("until", as_text(name_of(*lesson.until)));
  if (!lesson.phases.empty()) out.list("phases", names_as_texts(lesson.phases));
}

void write_motion(TomlText& out, const LessonMotion& motion) {
  if (!motion.points.empty()) out.list("points", in_brackets(motion.points));
  if (!motion.turns.empty()) out.list("turns", texts_of(motion.turns));
}

void write_path(TomlText& out, const LessonPath& path) {
  out.table("[path]");
  write_motion(out, path.x());
  out.whole_number("frames", path.frames, 0);
  if (path.seconds) out.key("seconds", decimal(*path.seconds));
  out.table("[path.Y]");
  write_motion(out, path.y());
}

void write_growth(TomlText& out, const LessonGrowth& growth) {
  const LessonGrowth defaults;
  out.table("[growth]");
  std::vector<std::string> sizes;
  for (const int size : growth.vertices) sizes.push_back(std::to_string(size));
  out.list("vertices", sizes);
  out.whole_number("runs", growth.runs, defaults.runs);
  out.whole_number("seed", growth.seed, defaults.seed);
  out.number("tolerance", growth.tolerance, defaults.tolerance);
  if (!growth.times) return;
  out.table("[growth.times]");
  out.text("machine", growth.times->machine, "");
  for (const auto& [name, member] : kGrowthTimes) out.list(name, texts_of((*growth.times).*member));
}

void write_study(TomlText& out, const LessonStudy& study) {
  out.table("[study]");
  out.text("results", study.results, "");
  out.text("family", study.family, "");
  for (const StudyMark& mark : study.marks) {
    out.table("[[study.marks]]");
    out.text("configuration", mark.configuration, "");
    out.text("beside", mark.beside, "");
    out.text("about", mark.about, "");
    out.text("note", mark.note, "");
  }
}

std::string camera_keys(const Camera& camera) {
  const std::string stretch =
      camera.stretch == 1.0 ? std::string() : ", stretch = " + decimal(camera.stretch);
  return fmt::format("center = {}, height = {}{}", in_brackets(camera.center),
                     decimal(camera.height), stretch);
}

/// A plot is called like the act that fills it.
void write_view(TomlText& out, const LessonView& view, const std::string& act) {
  out.table("[[views]]");
  out.key("show", as_text(view.kind == ViewKind::plot ? act : name_of(view.kind)));
  out.text("title", view.title, "");
  if (view.camera) out.key("camera", fmt::format("{{ {} }}", camera_keys(*view.camera)));
  if (view.close_up) {
    out.key("close-up", fmt::format("{{ {}, corner = {} }}", camera_keys(view.close_up->camera),
                                    as_text(name_of(view.close_up->corner))));
  }
  if (!view.effects.empty()) out.list("effects", as_texts(view.effects));
}

void write_expect(TomlText& out, const Expectation& expect) {
  out.table("[expect]");
  if (expect.stop) out.key("stop", as_text(*expect.stop));
  if (expect.supports) out.list("supports", as_texts(*expect.supports));
  if (expect.distance) out.key("distance", decimal(*expect.distance));
  if (!expect.answers.empty()) {
    std::vector<std::string> answers;
    for (const auto& [name, value] : expect.answers)
      answers.push_back(fmt::format("{} = {}", name, decimal(value)));
    out.key("answer", fmt::format("{{ {} }}", fmt::join(answers, ", ")));
  }
  out.write_empty();
}

}  // namespace

std::string lesson_toml(const Lesson& lesson) {
  TomlText out;
  out.text("title", lesson.title, "");
  out.key("chapter", std::to_string(lesson.chapter));
  out.key("order", std::to_string(lesson.order));
  out.text("source", lesson.source, "");
  if (!lesson.prose.empty()) out.key("prose", long_text(lesson.prose, "prose"));
  for (std::size_t i = 0; i < lesson.bodies.size(); ++i)
    write_shape(out, lesson.bodies[i], kBodyKeys[i]);
  write_query(out, lesson);
  write_steps(out, lesson);
  if (lesson.path_of_shapes) write_path(out, *lesson.path_of_shapes);
  if (lesson.time) {
    out.table("[time]");
    out.key("seconds", decimal(lesson.time->seconds));
    if (lesson.time->frames > 0) out.key("frames", std::to_string(lesson.time->frames));
    std::vector<std::string> lists;
    for (const std::vector<double>& moments : lesson.time->moments)
      lists.push_back(fmt::format("[{}]", fmt::join(texts_of(moments), ", ")));
    if (!lists.empty()) out.list("moments", lists);
  }
  if (lesson.growth) write_growth(out, *lesson.growth);
  if (lesson.study) write_study(out, *lesson.study);
  for (const LessonView& view : lesson.views) write_view(out, view, lesson.act);
  out.table("[panel]");
  if (!lesson.panel.empty()) out.list("blocks", as_texts(lesson.panel));
  out.text("listing", lesson.listing, "");
  for (const LessonQuestion& question : lesson.questions) {
    out.table("[[questions]]");
    out.key("ask", as_text(question.ask));
    if (question.at) out.key("at", std::to_string(*question.at));
  }
  write_expect(out, lesson.expect);
  return out.take();
}

Lesson with_absolute_results(Lesson lesson) {
  if (lesson.study) {
    lesson.study->results =
        std::filesystem::absolute(std::filesystem::path(lesson.path).parent_path() /
                                  lesson.study->results)
            .string();
  }
  return lesson;
}

}  // namespace gjkscope
