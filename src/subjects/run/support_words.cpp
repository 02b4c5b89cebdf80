#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/story.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::captions {
namespace {

/// The vertices of a shape behind its support point.
std::string behind(const LessonShape& shape, int support) {
  return fmt::format("All of {} lies behind the dashed line through {}", shape.name,
                     shape.vertex_names[support]);
}

/// "the largest of 5", and which vertices lie as far.
std::string rank(const std::vector<Eigen::Vector3d>& vertices, const LessonShape& shape,
                 int support, const Eigen::Vector3d& d) {
  std::vector<std::string> equal;
  const double largest = d.dot(vertices[support]);
  constexpr double kSame = 1e-12;  // of the size of the products: far less than frames show
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) {
    const Eigen::Vector3d& vertex = vertices[i];
    if (i == support || std::abs(d.dot(vertex) - largest) > kSame * d.norm() * vertex.norm())
      continue;
    equal.push_back(shape.vertex_names[i] + "'s");
  }
  const std::string rank = fmt::format("the largest of {}", vertices.size());
  return equal.empty() ? rank : fmt::format("{}, as large as {}", rank, and_list(std::move(equal)));
}

/// As the scan has computed it.
double value_of(const std::vector<gjk::ScanEntry<double>>& scan, int vertex) {
  return std::find_if(scan.begin(), scan.end(),
                      [&](const auto& entry) { return entry.index == vertex; })
      ->value;
}

}  // namespace

void support_in_parts(const Story& story, FrameText& text) {
  const Lesson& lesson = story.run.lesson;
  const gjk::VertexPair pair = story.state.support.pair;
  const std::string& k = lesson.y().vertex_names[pair.y];
  const std::string& c = lesson.x().vertex_names[pair.x];
  const std::string name = story.run.pair_name(pair);
  const std::size_t of_x = lesson.x().vertices.size();
  const std::size_t of_y = lesson.y().vertices.size();
  const WideRecord& record = story.run.step(story.frame).record;
  const double along_y = value_of(record.scan_y, pair.y);
  const double along_x = value_of(record.scan_x, pair.x);
  const WideState& next = story.trace.steps[static_cast<std::size_t>(story.frame.step) + 1].after;
  switch (*support_part(story.run, story.frame)) {
    case SupportPart::direction: {
      const WideStep& before = story.trace.steps[story.frame.step - 1];
      text.caption = fmt::format("d = {} {}. Which point of Z lies farthest along d?",
                                 story.numbers.point(story.state.d),
                                 before.record.direction.from_normal
                                     ? "points from P towards O; its length does not matter"
                                     : "leads from P to O");
      text.detail = fmt::format(
          "dot(d, y − x) = dot(d, y) + dot(−d, x): search {} along d and {} along −d, separately.",
          lesson.y().name, lesson.x().name);
      return;
    }
    case SupportPart::of_y:
      text.caption =
          fmt::format("{} is the support point of {} along d: dot(d, {}) = {} is {}.", k,
                      lesson.y().name, k, story.numbers(along_y),
                      rank(story.positioned.y().world, lesson.y(), pair.y, story.state.d));
      text.detail = fmt::format("{}. The support point of Z is one of the ringed points {} − x.",
                                behind(lesson.y(), pair.y), k);
      return;
    case SupportPart::of_x:
      text.caption =
          fmt::format("{} is the support point of {} along −d: dot(−d, {}) = {} is {}.", c,
                      lesson.x().name, c, story.numbers(along_x),
                      rank(story.positioned.x().world, lesson.x(), pair.x, -story.state.d));
      text.detail =
          fmt::format("{}. Thus the support point of Z is {}.", behind(lesson.x(), pair.x), name);
      return;
    default: {
      const std::string total = story.numbers(story.state.support_value);
      text.caption = fmt::format("{} is the support point of Z: dot(d, {}) = {} {} {} = {}{}.",
                                 name, name, story.numbers(along_y), along_x < 0.0 ? "−" : "+",
                                 story.numbers(std::abs(along_x)), total,
                                 adds_up({story.numbers(along_y), story.numbers(along_x)}, total)
                                     ? ""
                                     : " up to rounding");
      text.detail =
          next.stop == gjk::StopReason::repeated_support
              ? fmt::format(
                    "{} is already in the simplex, so GJK stops. The distance is {}, between {}.",
                    name, story.numbers(story.trace.result.distance), story.closest_features())
              : fmt::format(
                    "None of the {} differences lies beyond its line. {} + {} dot products found "
                    "it.",
                    grouped(static_cast<double>(of_x * of_y)), of_y, of_x);
    }
  }
}

}  // namespace gjkscope::captions
