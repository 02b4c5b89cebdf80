#include <fmt/format.h>

#include <algorithm>

#include "picture/story.hpp"
#include "subjects/shape_hull/shape_hull.hpp"
#include "subjects/shape_hull/subject.hpp"

namespace gjkscope::captions {

void shape_hull(const Story& story, FrameText& text) {
  if (!story.run.tour->follows_run || !story.shows(ShapeHull::kName)) return;
  const ShapeHull::Value& hulls = story.effects.get<ShapeHull>(story.frame);
  if (!story.run.point_query() || hulls.y.inside.empty()) return;
  const std::string inside = story.run.lesson.y().vertex_names[hulls.y.inside[0]];
  if (story.knows.phase_is(gjk::Phase::support)) {
    const auto& scan = story.run.step(story.frame).record.scan_y;
    const auto entry = std::find_if(scan.begin(), scan.end(), [&](const auto& seen) {
      return seen.index == hulls.y.inside[0];
    });
    if (entry == scan.end()) return;
    text.detail =
        fmt::format("{0} can never win: it lies inside the hull. Here dot(d, {0}) is only {1}.",
                    inside, story.numbers(entry->value));
  } else if (story.knows.phase_is(gjk::Phase::stop) && story.knows.has_ended) {
    text.detail = fmt::format(
        "The hull is {} away, but the polygon itself is {} away (thin line). For the polygon the "
        "answer is wrong: GJK never sees {}.",
        story.numbers(story.trace.result.distance), story.numbers(hulls.outline_distance), inside);
  }
}

}  // namespace gjkscope::captions
