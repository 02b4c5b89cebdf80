#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/story.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::captions {

namespace {

/// "0.00008": the degrees by which a direction misses being perpendicular to the simplex, with one
/// digit.
std::string off_by(const Story& story, const Eigen::Vector3d& d) {
  const Eigen::Vector3d edge =
      story.state.simplex.vertices[1].w - story.state.simplex.vertices[0].w;
  const double degrees =
      std::asin(std::abs(d.dot(edge)) / (d.norm() * edge.norm())) * 180.0 / std::numbers::pi;
  const int decimals = degrees > 0.0 ? static_cast<int>(std::ceil(-std::log10(degrees))) : 0;
  return fixed(degrees, std::max(decimals, 0));
}

}  // namespace

void direction_rules(const Story& story, FrameText& text) {
  if (!story.run.lesson.has_block(blocks::kDirectionRules.name)) return;
  const DirectionRules::Value& rules = story.effects.get<DirectionRules>(story.frame);
  const auto built = [&](gjk::DirectionRule rule) {
    return std::find_if(rules.begin(), rules.end(), [&](const auto& b) { return b.rule == rule; });
  };
  const auto towards = built(gjk::DirectionRule::towards_origin);
  const auto perpendicular = built(gjk::DirectionRule::perpendicular);
  if (towards == rules.end() || perpendicular == rules.end()) return;
  if (towards->dot_with_edge == 0.0 || perpendicular->dot_with_edge != 0.0) return;
  const std::string edge = story.words.vertex(1) + " − " + story.words.vertex(0);
  const std::string value = story.numbers(towards->dot_with_edge);
  if (story.knows.phase_is(gjk::Phase::direction)) {
    text.caption =
        fmt::format("d = {0} − P should be perpendicular to {1}, but dot(d, {2}) = {3}, not 0.",
                    story.q, story.edge_words(), edge, value);
    const bool seen = std::any_of(
        story.run.lesson.views.begin(), story.run.lesson.views.end(),
        [](const LessonView& view) { return view.camera && view.camera->stretch != 1.0; });
    text.detail =
        fmt::format("That is {}° off, {}. With d = cross({}, z) the dot product is exactly 0.",
                    off_by(story, towards->d),
                    seen ? "which only the stretched view shows" : "too little to see", edge);
  } else if (story.knows.phase_is(gjk::Phase::stop) && story.knows.has_ended) {
    text.detail = fmt::format(
        "The distance is {}. Being {}° off, d did no harm here. Larger errors can find a wrong "
        "vertex.",
        story.numbers(story.trace.result.distance), off_by(story, towards->d));
  }
}

}  // namespace gjkscope::captions
