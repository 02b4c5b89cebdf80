#include "effects/direction_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "picture/captions/story.hpp"

namespace gjkscope::captions {

using fmt::format;

void direction_rules(const Story& story, FrameText& text) {
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
    text.caption = format("d = {0} − P should be perpendicular to {1}, but dot(d, {2}) = {3}.",
                          story.q, story.edge_words(), edge, value);
    text.detail = format("d = cross({}, z) has a dot product of exactly 0 with the edge.", edge);
  } else if (story.knows.phase_is(gjk::Phase::stop) && story.knows.has_ended) {
    text.detail = format(
        "The distance is {}. Among more vertices a d as wrong as this can pick the wrong one.",
        story.numbers(story.trace.result.distance));
  }
}

}  // namespace gjkscope::captions
