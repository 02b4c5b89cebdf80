#pragma once
// The Minkowski difference of two convex polygons, as a sum: Y - X = Y + (-X) (Larsen 1998,
// "Minkowski Sums"). The outline of a sum has the edges of both polygons, sorted by angle, so two
// walks that start at the lowest vertices and always take the edge that turns less make it: O(m +
// n) instead of all m n sums and their hull.
//
//   lowest   the lowest vertex of Y and that of -X make the lowest corner
//   edge     the edge that turns less is next; parallel ones are one edge
//   inside   the shapes overlap where O lies on the inner side of each edge
//
// Turns and sides are decided exactly. Corners are rounded once.

#include <vector>

#include "outlines/nearest.hpp"

namespace minkowski_sum {

using models::Point;
using models::Ring;

enum class Phase : std::uint8_t { lowest, edge, inside };
enum class Source : std::uint8_t { y, x, both };
enum class OriginSide : std::uint8_t { outside, on_edge, inside };

/// The difference of a vertex of Y and a vertex of X, by their numbers in the rings.
struct Corner {
  int y = 0;
  int x = 0;
  friend bool operator==(const Corner&, const Corner&) = default;
};

struct State {
  Corner at;
  int edges_of_y = 0;  ///< Taken by now.
  int edges_of_x = 0;
};

struct Step {
  Phase phase = Phase::lowest;
  Source source = Source::both;  ///< The shape that an edge comes from.
  State before;
  State after;
};

/// The ring of -X is that of X: turned by half a circle, it has the same order.
struct Merge {
  Ring x;
  Ring y;
  std::vector<Step> steps;
  std::vector<Corner> corners;  ///< Counter-clockwise; each edge leads to the next.
  std::vector<Source> edges;    ///< As many.
  OriginSide origin = OriginSide::outside;
  int separating = -1;  ///< When O is outside: an edge that has it on its outer side.

  [[nodiscard]] Point at(const Corner& corner) const {
    return y.points[corner.y] - x.points[corner.x];
  }
};

namespace detail {

/// The ring's lowest vertex, or its highest; of two, the one that a walk around the ring comes to
/// first.
[[nodiscard]] inline int extreme(const Ring& ring, bool lowest) {
  const auto comes_first = [&](const Point& a, const Point& b) {
    if (a.y() != b.y()) return lowest ? a.y() < b.y() : a.y() > b.y();
    return lowest ? a.x() < b.x() : a.x() > b.x();
  };
  int found = 0;
  for (int i = 1; i < ring.size(); ++i) {
    if (comes_first(ring.points[i], ring.points[found])) found = i;
  }
  return found;
}

/// Exactly: 1 where the next edge of Y turns less than that of -X, -1 where it turns more.
[[nodiscard]] inline int which_turns_less(const Merge& merge, const Corner& at) {
  const auto quarter = [](const Point& a) { return Point(-a.y(), a.x()); };
  // The edge of -X from -a to -b is a - b.
  return models::dot_sign(quarter(merge.y.points[at.y]),
                          quarter(merge.y.points[merge.y.next(at.y)]),
                          merge.x.points[merge.x.next(at.x)], merge.x.points[at.x]);
}

/// Exactly: 1 where O lies on the inner side of the edge from `corner`, 0 on its line.
[[nodiscard]] inline int side_of_origin(const Merge& merge, const Corner& corner, Source source) {
  const Point& y = merge.y.points[corner.y];
  const Point& x = merge.x.points[corner.x];
  if (source == Source::x) return models::turn(x, merge.x.points[merge.x.next(corner.x)], y);
  return models::turn(y, merge.y.points[merge.y.next(corner.y)], x);
}

}  // namespace detail

/// Needs two convex rings.
[[nodiscard]] inline Merge merge(Ring x, Ring y) {
  Merge out{std::move(x), std::move(y), {}, {}, {}};
  State state{{detail::extreme(out.y, true), detail::extreme(out.x, false)}};
  out.steps.push_back({Phase::lowest, Source::both, state, state});
  while (state.edges_of_y < out.y.size() || state.edges_of_x < out.x.size()) {
    int less = detail::which_turns_less(out, state.at);
    if (state.edges_of_y == out.y.size()) less = -1;
    if (state.edges_of_x == out.x.size()) less = 1;
    const Source source = less > 0 ? Source::y : less < 0 ? Source::x : Source::both;
    Step step{Phase::edge, source, state, state};
    out.corners.push_back(state.at);
    out.edges.push_back(source);
    if (source != Source::x) {
      state.at.y = out.y.next(state.at.y);
      ++state.edges_of_y;
    }
    if (source != Source::y) {
      state.at.x = out.x.next(state.at.x);
      ++state.edges_of_x;
    }
    step.after = state;
    out.steps.push_back(step);
  }
  out.origin = OriginSide::inside;
  for (std::size_t i = 0; i < out.corners.size(); ++i) {
    const int side = detail::side_of_origin(out, out.corners[i], out.edges[i]);
    if (side == 0 && out.origin == OriginSide::inside) out.origin = OriginSide::on_edge;
    if (side >= 0) continue;
    out.origin = OriginSide::outside;
    if (out.separating < 0) out.separating = static_cast<int>(i);
  }
  out.steps.push_back({Phase::inside, Source::both, state, state});
  return out;
}

}  // namespace minkowski_sum
