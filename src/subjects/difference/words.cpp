#include <fmt/format.h>

#include "picture/story.hpp"
#include "subjects/difference/minkowski.hpp"
#include "subjects/difference/subject.hpp"
#include "subjects/difference/tour.hpp"

namespace gjkscope::captions {
namespace {

void first_pair(const Story& story, FrameText& text) {
  const Eigen::Vector2d a = in_plane(story.positioned.x().world[0]);
  const Eigen::Vector2d b = in_plane(story.positioned.y().world[0]);
  text.caption =
      fmt::format("{} = {} − {} = {}.", story.run.pair_name({0, 0}), story.numbers.point(b),
                  story.numbers.point(a), story.numbers.point(b - a));
  text.detail =
      fmt::format("It is the arrow from {} to {}, moved so that it starts at O = (0, 0).",
                  story.run.lesson.x().vertex_names[0], story.run.lesson.y().vertex_names[0]);
}

void hull(const Story& story, FrameText& text, int all) {
  const std::size_t corners = story.effects.get<MinkowskiHull>(story.frame).size();
  text.caption =
      fmt::format("The Minkowski difference Z = {} − {} is the convex hull of the {} points.",
                  story.run.lesson.y().name, story.run.lesson.x().name, all);
  text.detail =
      fmt::format("{} of the points are its vertices; the other {} lie inside or on edges.",
                  corners, static_cast<std::size_t>(all) - corners);
}

void edges(const Story& story, FrameText& text) {
  const MinkowskiHull::Value& hull = story.effects.get<MinkowskiHull>(story.frame);
  const std::size_t edges = hull.size();
  std::size_t of_y = 0;
  std::size_t of_x = 0;
  for (std::size_t i = 0; i < edges; ++i) {
    const gjk::VertexPair a = hull[i].pair;
    const gjk::VertexPair b = hull[(i + 1) % edges].pair;
    of_y += a.y != b.y ? 1 : 0;
    of_x += a.x != b.x ? 1 : 0;
  }
  const std::string& x = story.run.lesson.x().name;
  const std::string& y = story.run.lesson.y().name;
  text.caption =
      fmt::format("Each edge of Z is an edge of {} or of −{}, moved: {} + {}{}.", y, x, of_y, of_x,
                  of_y + of_x == edges ? fmt::format(" = {} edges", edges)
                                       : std::string(", and parallel edges join"));
  text.detail =
      "Thus Z could be built from both lists of edges, sorted by angle. GJK does not need Z.";
}

}  // namespace

void pairs(const Story& story, FrameText& text) {
  const int per_x = static_cast<int>(story.positioned.y().world.size());
  const int all = static_cast<int>(story.positioned.x().world.size()) * per_x;
  const std::string& x = story.run.lesson.x().name;
  const std::string& y = story.run.lesson.y().name;
  const auto [part, made] = *build_frame(story.run, story.frame);
  switch (part) {
    case BuildPart::start:
      text.caption = fmt::format(
          "Subtract every vertex of {} from every vertex of {}: {} × {} = {} differences.", x, y,
          per_x, all / per_x, all);
      text.detail = fmt::format("Start with {}.", story.run.pair_name({0, 0}));
      return;
    case BuildPart::pair:
      return first_pair(story, text);
    case BuildPart::copy: {
      const std::string& of_x = story.run.lesson.x().vertex_names[(made - 1) / per_x];
      text.caption = fmt::format(
          "{0} − {1}: subtract {1} from each vertex of {0}. The result is {0}, moved by −{1}.", y,
          of_x);
      text.detail = made < all ? fmt::format("{} of {} differences are there.", made, all)
                               : fmt::format("Now all {} differences are there.", all);
      return;
    }
    case BuildPart::mirror:
      text.caption = fmt::format(
          "{1} − {0} is also {1} + (−{0}). Reflect {0} in O: each vertex x becomes −x.", x, y);
      text.detail = fmt::format("−{0} is {0}, turned by 180°.", x);
      return;
    case BuildPart::slide:
      text.caption = fmt::format(
          "Move −{0} so that its O stands on a vertex of {1}. The copies, one for each vertex of "
          "{1}, "
          "have the same {2} differences as vertices.",
          x, y, all);
      text.detail =
          fmt::format("As its O goes through all points of {1}, −{0} covers all of Z.", x, y);
      return;
    case BuildPart::hull:
      return hull(story, text, all);
    case BuildPart::edges:
      return edges(story, text);
    case BuildPart::any:
      text.caption =
          fmt::format("Take any points x of {} and y of {}: the arrow y − x ends in Z.", x, y);
      text.detail = fmt::format(
          "And every point of Z is such a difference: Z holds all arrows from {} to {}.", x, y);
      return;
    case BuildPart::shortest:
      if (!(story.trace.result.distance > 0.0)) {
        text.caption =
            fmt::format("O lies in Z: some x equals some y, so {} and {} overlap.", x, y);
        return;
      }
      text.caption = fmt::format(
          "Thus the shortest arrow ends at the point of Z closest to O: both "
          "lengths are {}.",
          story.numbers(story.trace.result.distance));
      text.detail = fmt::format("That is property 1: distance({}, {}) = distance(O, Z).", x, y);
      return;
  }
}

}  // namespace gjkscope::captions
