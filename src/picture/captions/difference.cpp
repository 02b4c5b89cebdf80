#include <fmt/format.h>

#include "effects/minkowski.hpp"
#include "picture/captions/story.hpp"

namespace gjkscope::captions {

using Eigen::Vector2d;
using fmt::format;

void pairs(const Story& story, FrameText& text) {
  const int per_x = static_cast<int>(story.positioned.y().world.size());
  const int all = static_cast<int>(story.positioned.x().world.size()) * per_x;
  const std::string& x = story.run.lesson.x().name;
  const std::string& y = story.run.lesson.y().name;
  if (*story.frame.pairs == 0) {
    text.caption =
        format("Subtract every vertex of {} from every vertex of {}: {} × {} = {} differences.", x,
               y, per_x, all / per_x, all);
    text.detail =
        "Each difference is an arrow from a vertex of X to a vertex of Y, moved so that it starts "
        "at "
        "O = (0, 0).";
  } else if (*story.frame.pairs <= all) {
    const gjk::VertexPair pair{(*story.frame.pairs - 1) / per_x, (*story.frame.pairs - 1) % per_x};
    const Vector2d a = story.positioned.x().world[pair.x];
    const Vector2d b = story.positioned.y().world[pair.y];
    text.caption = format("{} = {} − {} = {}.", story.run.pair_name(pair), story.numbers.point(b),
                          story.numbers.point(a), story.numbers.point(b - a));
    text.detail = format("Point {} of {}: the arrow from {} to {}, moved so that it starts at O.",
                         *story.frame.pairs, all, story.run.lesson.x().vertex_names[pair.x],
                         story.run.lesson.y().vertex_names[pair.y]);
  } else {
    const std::size_t corners = story.effects.get<MinkowskiHull>(story.frame).size();
    text.caption = format(
        "The convex hull of the {} points is the Minkowski difference Z = {} − {}. {} of them are "
        "its "
        "vertices.",
        all, y, x, corners);
    text.detail =
        story.trace.result.distance > 0.0
            ? format(
                  "O lies {} outside Z, and {} and {} are {} apart: the two distances are equal.",
                  story.numbers(story.trace.result.distance), x, y,
                  story.numbers(story.trace.result.distance))
            : format("O lies inside: {} and {} overlap.", x, y);
  }
}

}  // namespace gjkscope::captions
