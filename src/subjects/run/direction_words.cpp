#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/story.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::captions {

namespace {

/// "0.00008": degrees with one digit.
std::string one_digit(double degrees) {
  const int decimals = degrees > 0.0 ? static_cast<int>(std::ceil(-std::log10(degrees))) : 0;
  return fixed(degrees, std::max(decimals, 0));
}

/// In space nothing is exactly perpendicular: each way has its error.
void rules_in_space(const Story& story, const DirectionRules::Built& towards,
                    const DirectionRules::Built& perpendicular, FrameText& text) {
  constexpr double kClearly = 4.0;
  const bool differ = towards.degrees_off > kClearly * perpendicular.degrees_off;
  if (!differ || !story.knows.phase_is(gjk::Phase::direction)) return;
  text.caption = fmt::format("d = {} − P should be perpendicular to {}, but it is {}° off.",
                             story.q, story.edge_words(), one_digit(towards.degrees_off));
  text.detail = fmt::format(
      "P is rounded in the digits of {0} and {1}; {2} − P is short, so little of it is right. "
      "cross(e, cross(e, {0} − {2})) with e = {1} − {0} is {3}° off.",
      story.words.vertex(0), story.words.vertex(1), story.q, one_digit(perpendicular.degrees_off));
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
  if (story.run.lesson.dimension == 3) return rules_in_space(story, *towards, *perpendicular, text);
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
                    one_digit(towards->degrees_off),
                    seen ? "which only the stretched view shows" : "too little to see", edge);
  } else if (story.knows.phase_is(gjk::Phase::stop) && story.knows.has_ended) {
    text.detail = fmt::format(
        "The distance is {}. Being {}° off, d did no harm here. Larger errors can find a wrong "
        "vertex.",
        story.numbers(story.trace.result.distance), one_digit(towards->degrees_off));
  }
}

}  // namespace gjkscope::captions
