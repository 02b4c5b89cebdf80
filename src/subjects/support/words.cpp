#include <fmt/format.h>

#include "picture/story.hpp"
#include "subjects/support/slab.hpp"
#include "subjects/support/subject.hpp"
#include "subjects/support/touched_points.hpp"

namespace gjkscope::captions {

void touched_points(const Story& story, FrameText& text) {
  const std::size_t all = story.positioned.x().world.size() * story.positioned.y().world.size();
  text.detail += fmt::format(" GJK computed {} of {} differences.",
                             story.effects.get<TouchedPoints>(story.frame).size(),
                             grouped(static_cast<double>(all)));
}

void slab(const Story& story, FrameText& text) {
  const Lesson& lesson = story.run.lesson;
  const auto& [lower, upper] = story.run.bounds(story.frame);
  const std::string low = story.numbers(lower);
  const std::string high = story.numbers(upper);
  const std::string lines = lesson.dimension == 3 ? "planes" : "lines";
  const BestSupport::Value& widest = story.effects.get<BestSupport>(story.frame);
  if (story.knows.phase_is(gjk::Phase::closest)) {
    text.caption = fmt::format(
        "The closest points of this simplex are {} apart, so the distance is at most that.",
        story.distance());
    text.detail =
        widest
            ? fmt::format("The slab is {} wide, so the distance lies between {} and {}.",
                          story.numbers(widest->width), low, high)
            : fmt::format("Thus {} is an upper bound. Is any other pair of points closer?", high);
    return;
  }
  const std::string k = lesson.y().vertex_names[story.state.support.pair.y];
  const std::string c = lesson.x().vertex_names[story.state.support.pair.x];
  if (story.knows.phase_is(gjk::Phase::support)) {
    const double gap = -story.state.support_value / story.state.d.norm();
    if (!(gap > 0.0)) {
      text.caption =
          fmt::format("The {} through {} and {} leave no gap: this d does not separate the shapes.",
                      lines, k, c);
      text.detail = fmt::format("The distance still lies between {} and {}.", low, high);
    } else if (is_found_by(*widest, story.state)) {
      text.caption = fmt::format(
          "{} is {}'s farthest vertex along d, {} is {}'s along −d: the slab between is empty and "
          "{} "
          "wide.",
          k, lesson.y().name, c, lesson.x().name, story.numbers(gap));
      text.detail = fmt::format(
          "Every way from {} to {} crosses the slab, so the distance is at least {}. It is at most "
          "{}.",
          lesson.x().name, lesson.y().name, low, high);
    } else {
      text.caption =
          fmt::format("The {} through {} and {}{} are {} apart: an earlier slab is wider.", lines,
                      k, c, lesson.dimension == 3 ? ", not drawn," : "", story.numbers(gap));
      text.detail = fmt::format("The distance lies between {} and {}.", low, high);
    }
    return;
  }
  if (!story.knows.has_ended) {
    text.caption =
        fmt::format("The bounds still differ by {}, so {} joins the simplex.",
                    story.numbers(upper - lower), story.run.pair_name(story.state.support.pair));
    text.detail = fmt::format(
        "{}. The slab may get wider and the closest points closer, until the bounds meet.",
        difference_as_written(high, low, story.numbers(upper - lower)));
    return;
  }
  text.caption =
      widest ? fmt::format("Stop: the empty slab is as wide as the closest points are apart, {}.",
                           story.numbers(story.trace.result.distance))
             : fmt::format("Stop: no slab separates {} from {}.", lesson.x().name, lesson.y().name);
  text.detail = widest ? fmt::format(
                             "Closest: {}. No pair of points can be closer than the slab is wide: "
                             "the slab proves the answer.",
                             story.closest_features())
                       : "The distance is 0.";
}

}  // namespace gjkscope::captions
