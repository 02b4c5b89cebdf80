#include "golden/golden_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <libdeflate.h>

#include <regex>
#include <sstream>
#include <vector>

#include "frames/frame.hpp"
#include "lesson/names.hpp"
#include "run/trace_json.hpp"
#include "run/trace_text.hpp"

namespace gjkscope::golden {
namespace {

std::string placement(const std::string& name, const Placement& at) {
  // In the plane two numbers, as ever.
  std::string out = fmt::format("{} at [{}, {}", name, at.translate.x(), at.translate.y());
  out += at.translate.z() == 0.0 ? "]" : fmt::format(", {}]", at.translate.z());
  if (at.rotate_degrees != 0.0) out += fmt::format(" turned by {}", at.rotate_degrees);
  return out;
}

std::string run_line(const LessonRun& run, const PositionedRun& positioned) {
  std::vector<std::string> supports;
  for (const WideStep& step : positioned.trace.steps) {
    if (step.phase == gjk::Phase::support)
      supports.push_back(run.pair_name(step.after.support.pair));
  }
  const WideResult& result = positioned.trace.result;
  return fmt::format("  {}, {}: supports {}; {}; {}; distance {}\n",
                     placement(run.lesson.x().name, positioned.x().placement),
                     placement(run.lesson.y().name, positioned.y().placement),
                     supports.empty() ? "none" : fmt::format("{}", fmt::join(supports, " ")),
                     name_of(result.stop), name_of(result.verdict), result.distance);
}

/// A long search repeats itself, so only its first iterations and its result are kept.
std::string without_repetition(const std::string& text) {
  constexpr int kKept = 20;
  constexpr int kLong = 40;
  constexpr std::string_view kHeading = ", iteration ";
  const std::size_t last = text.rfind(kHeading);
  if (last == std::string::npos) return text;
  const int count = std::stoi(text.substr(last + kHeading.size()));
  if (count <= kLong) return text;
  const std::size_t from =
      text.rfind('\n', text.find(fmt::format("{}{}\n", kHeading, kKept + 1))) + 1;
  return fmt::format("{}iterations {} to {} are left out; checksums.txt covers them\n{}",
                     text.substr(0, from), kKept + 1, count,
                     text.substr(text.find("\n\n", last) + 1));
}

std::string pixel(double value) {
  const std::string text = fmt::format("{:.1f}", value);
  return text == "-0.0" ? "0.0" : text;
}
std::string point(const Point& p) { return fmt::format("{},{}", pixel(p.x()), pixel(p.y())); }
std::string points(const std::vector<Point>& list) {
  std::vector<std::string> texts;
  for (const Point& p : list) texts.push_back(point(p));
  return fmt::format("{}", fmt::join(texts, " "));
}

struct ShapeText {
  std::string operator()(const Polygon& shape) const { return "polygon " + points(shape.points); }
  std::string operator()(const Polyline& shape) const {
    return fmt::format("{} {}", shape.closed ? "outline" : "line", points(shape.points));
  }
  std::string operator()(const Arrow& shape) const {
    return fmt::format("arrow {} {}", point(shape.from), point(shape.to));
  }
  std::string operator()(const Disk& shape) const {
    return fmt::format("disk {} radius {}", point(shape.center), pixel(shape.radius));
  }
  std::string operator()(const Cross& shape) const {
    return fmt::format("cross {} radius {}", point(shape.center), pixel(shape.radius));
  }
  std::string operator()(const Box& shape) const {
    return fmt::format("box {} {} corner {}", point(shape.rect.min), point(shape.rect.max),
                       pixel(shape.corner));
  }
  std::string operator()(const Text& shape) const {
    constexpr std::array<std::string_view, 3> kAligns = {"left", "center", "right"};
    return fmt::format("text {} {} size {} \"{}\"", point(shape.at),
                       kAligns[static_cast<std::size_t>(shape.align)], shape.style.size,
                       shape.text);
  }
};

}  // namespace

std::string trace(const LessonRun& run) {
  LessonRun first = run;
  first.runs.resize(1);
  std::string out = without_repetition(trace_text(traced(first)));
  if (run.runs.size() > 1) out += "\nfurther runs\n";
  for (std::size_t i = 1; i < run.runs.size(); ++i) out += run_line(run, run.runs[i]);
  return out;
}

std::string checksums(const LessonRun& run) {
  EffectGraph effects(run);
  std::string words;
  const std::vector<FrameText> texts = lesson_texts(run, effects);
  for (const FrameText& text : texts) {
    for (const std::string* part : {&text.caption, &text.detail, &text.prose, &text.position})
      words += *part + '\n';
    for (const auto& [name, value] : text.values) words += name + ' ' + value + '\n';
  }
  const auto crc = [](const std::string& bytes) {
    return libdeflate_crc32(0, bytes.data(), bytes.size());
  };
  return fmt::format("{}: {} frames, traces {:08x}, words {:08x}\n", run.lesson.id, texts.size(),
                     crc(trace_json(traced(run))), crc(words));
}

std::string marks(const Picture& picture) {
  std::string out;
  for (const Mark& mark : picture.marks) {
    out += fmt::format("{}: {}", mark.role, std::visit(ShapeText{}, mark.shape));
    if (mark.clip >= 0) out += fmt::format(" in view {}", mark.clip + 1);
    out += '\n';
  }
  return out;
}

std::string without_places_of_words(const std::string& marks) {
  static const std::regex text(R"(: text -?[0-9.]+,-?[0-9.]+)");
  static const std::regex follower(
      R"(((^|\n)(leader|view-title\.box|legend\.box|label\.halo|chart\.[a-z.]+|plot\.[a-z.]+): )"
      R"([a-z]+)[-0-9., ]+)");
  static const std::regex timeline(R"(\ntimeline\.[^\n]*)");
  static const std::regex line_of_prose(R"("\nprose: text left size [0-9]+ ")");
  std::string out = std::regex_replace(marks, text, ": text");
  out = std::regex_replace(out, follower, "$1 ");
  out = std::regex_replace(out, timeline, "");
  return std::regex_replace(out, line_of_prose, " ");
}

Difference first_difference(const std::string& expected, const std::string& got) {
  std::istringstream a(expected);
  std::istringstream b(got);
  std::string heading;
  std::string label;
  for (int number = 1;; ++number) {
    std::string line_a;
    std::string line_b;
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (!more_a && !more_b) return {};
    // A trace has headings ("iteration 2"), and the phase in the first column of their lines.
    if (more_a && !line_a.empty() && line_a[0] != ' ') {
      heading = line_a;
      label.clear();
    } else if (line_a.size() > 2 && line_a[2] != ' ') {
      label = line_a.substr(2, line_a.find("  ", 2) - 2);
    }
    if (more_a == more_b && line_a == line_b) continue;
    std::string where = fmt::format("line {}", number);
    if (heading.find(':') == std::string::npos && !heading.empty()) {
      where = heading + (label.empty() ? "" : ", " + label);
    }
    return {where, more_a ? line_a : "(nothing)", more_b ? line_b : "(nothing)"};
  }
}

}  // namespace gjkscope::golden
