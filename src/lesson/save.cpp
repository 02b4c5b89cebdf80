#include "lesson/save.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/decimal.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/settings_kind.hpp"
#include "lesson/stop_tests.hpp"
#include "lesson/toml_patch.hpp"

namespace gjkscope {
namespace {

template <class E>
std::vector<std::string> names_as_texts(const std::vector<E>& values) {
  std::vector<std::string> out;
  for (const E value : values) out.push_back(as_text(name_of(value)));
  return out;
}

void write_shape(TomlText& out, const LessonShape& shape, std::string_view key, int dimension) {
  out.table(fmt::format("[shapes.{}]", key));
  out.text("name", shape.name, key);
  if (shape.vertex_names != default_vertex_names(shape, key))
    out.list("names", as_texts(shape.vertex_names));
  out.list("vertices", shape.vertices, dimension);
  if (!shape.outlines.empty()) out.list("outlines", shape.outlines);
  const bool is_moved = std::any_of(shape.translate.begin(), shape.translate.end(),
                                    [](double by) { return !same_bits(by, 0.0); });
  if (is_moved) out.key("translate", in_brackets(shape.translate, dimension));
  out.number("rotate", shape.rotate_degrees, 0.0);
  if (shape.axis != LessonShape().axis) out.key("axis", in_brackets(shape.axis, dimension));
  out.number("radius", shape.radius, 0.0);
}

void write_start(TomlText& out, const Lesson& lesson) {
  const gjk::Options& options = lesson.options;
  if (options.start.count == 0) {
    out.key("start", as_text("center-to-center"));
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
  out.choice("direction", options.direction_rule, defaults.options.direction_rule);
  out.choice("regions", options.region_order, defaults.options.region_order);
  if (!options.stop_on_repeated_support || !options.stop_on_no_progress)
    write_stop_tests(out, {options.stop_on_repeated_support, options.stop_on_no_progress});
  out.number("tolerance", options.tolerance, defaults.options.tolerance);
  out.whole_number("cap", options.iteration_cap, defaults.options.iteration_cap);
  write_start(out, lesson);
  if (lesson.warm_start) out.key("warm", "true");
}

void write_steps(TomlText& out, const Lesson& lesson) {
  out.table("[steps]");
  out.text("tour", lesson.tour, Lesson().tour);
  if (lesson.until) out.key("until", as_text(name_of(*lesson.until)));
  if (!lesson.phases.empty()) out.list("phases", names_as_texts(lesson.phases));
}

void write_motion(TomlText& out, const LessonMotion& motion, int dimension) {
  if (!motion.points.empty()) out.list("points", motion.points, dimension);
  if (!motion.turns.empty()) out.list("turns", motion.turns);
}

void write_path(TomlText& out, const LessonPath& path, int dimension) {
  out.table("[path]");
  write_motion(out, path.x(), dimension);
  out.whole_number("frames", path.frames, 0);
  if (path.seconds) out.key("seconds", decimal(*path.seconds));
  out.table("[path.Y]");
  write_motion(out, path.y(), dimension);
}

std::string camera_keys(const Camera& camera, int dimension) {
  const std::string stretch =
      camera.stretch == 1.0 ? std::string() : ", stretch = " + decimal(camera.stretch);
  return fmt::format("center = {}, height = {}{}", in_brackets(camera.center, dimension),
                     decimal(camera.height), stretch);
}

/// A plot is called like the tour that fills it.
void write_view(TomlText& out, const LessonView& view, const Lesson& lesson) {
  out.table("[[views]]");
  out.key("show", as_text(view.kind == ViewKind::plot ? lesson.tour : name_of(view.kind)));
  out.text("title", view.title, "");
  if (view.camera)
    out.key("camera", fmt::format("{{ {} }}", camera_keys(*view.camera, lesson.dimension)));
  if (view.eye) {
    out.key("eye", fmt::format("{{ azimuth = {}, elevation = {} }}", decimal(view.eye->azimuth),
                               decimal(view.eye->elevation)));
  }
  if (view.close_up) {
    out.key("close-up", fmt::format("{{ {}, corner = {} }}",
                                    camera_keys(view.close_up->camera, lesson.dimension),
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
  out.write_header();
}

}  // namespace

std::string lesson_toml(const Lesson& lesson) {
  TomlText out;
  out.text("title", lesson.title, "");
  out.key("chapter", std::to_string(lesson.chapter));
  out.key("order", std::to_string(lesson.order));
  out.text("source", lesson.source, "");
  if (!lesson.prose.empty()) out.long_text("prose", lesson.prose);
  if (!lesson.opening.empty()) out.long_text("opening", lesson.opening);
  if (!lesson.next.empty()) out.long_text("next", lesson.next);
  out.text("in_space", lesson.in_space, "");
  for (std::size_t i = 0; i < lesson.bodies.size(); ++i)
    write_shape(out, lesson.bodies[i], kBodyKeys[i], lesson.dimension);
  write_query(out, lesson);
  write_steps(out, lesson);
  if (lesson.path_of_shapes) write_path(out, *lesson.path_of_shapes, lesson.dimension);
  if (const SettingsKind* kind = lesson.settings.kind()) kind->write(lesson.settings, out);
  for (const LessonView& view : lesson.views) write_view(out, view, lesson);
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

std::optional<std::string> lesson_toml_kept(std::string_view original, const Lesson& lesson,
                                            const std::filesystem::path& file,
                                            const Vocabulary& vocabulary, const FileReader& read) {
  const LoadedLesson before = parse_lesson(original, file, vocabulary, read);
  if (!before.lesson) return std::nullopt;
  const std::string wanted = lesson_toml(lesson);
  std::string patched = patched_toml(original, lesson_toml(*before.lesson), wanted);
  const LoadedLesson after = parse_lesson(patched, file, vocabulary, read);
  const LoadedLesson meant = parse_lesson(wanted, file, vocabulary, read);
  if (!after.lesson || !meant.lesson || lesson_toml(*after.lesson) != lesson_toml(*meant.lesson))
    return std::nullopt;
  return patched;
}

Lesson with_absolute_file(Lesson lesson) {
  if (std::optional<NamedFile>& file = lesson.settings.file) {
    const std::filesystem::path folder = std::filesystem::path(lesson.path).parent_path();
    file->path = std::filesystem::absolute(folder / file->path).string();
  }
  return lesson;
}

}  // namespace gjkscope
