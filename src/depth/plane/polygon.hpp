#pragma once
// The expanding polygon: the loop's part in the plane.

#include "depth/state.hpp"

namespace depth {

/// A corner of the polygon, linked to its neighbours. One that the polygon has outgrown stays where
/// it is, so that indices keep their meaning.
template <class R>
struct Corner {
  static constexpr int kOutgrown = -1;
  gjk::SupportPoint<R, 2> point;
  int previous = kOutgrown;
  int next = kOutgrown;
};

/// From one corner to the next.
template <class R>
struct Edge {
  int from = 0;
  int to = 0;
  R distance_sq = R(0);  ///< The squared distance of O from the segment.
};

/// Points of Z, counter-clockwise around O. A point is a polygon, too, with an edge from itself to
/// itself, and a segment is one of two edges.
template <class R>
struct Polygon {
  std::vector<Corner<R>> corners;
  int count = 0;  ///< Corners that are not outgrown.
  int first = 0;  ///< One of them: the latest.
  /// A heap, the nearest edge in front. Edges that are gone stay until they come to the front.
  std::vector<Edge<R>> edges;

  [[nodiscard]] const Vec<R, 2>& at(int corner) const { return corners[corner].point.w; }
};

template <class R>
struct State<R, 2> : Progress<R, 2> {
  Polygon<R> polygon;
  Edge<R> edge;  ///< The nearest one. Its normal n is as long.
};

template <class R>
struct Record<R, 2> : Notes<R> {
  std::vector<Edge<R>> edges;  ///< The polygon whose nearest edge was looked for.
};

/// Squared distance of O from the segment ab. Its nearest point is the foot of the perpendicular,
/// where that lies between a and b:
///
///   |cross(a, b - a)|^2 / |b - a|^2
template <class R>
[[nodiscard]] R segment_distance_sq(const Vec<R, 2>& a, const Vec<R, 2>& b) {
  const Vec<R, 2> edge = b - a;
  if (!(gjk::dot(a, edge) < R(0))) return gjk::dot(a, a);
  if (!(R(0) < gjk::dot(b, edge))) return gjk::dot(b, b);
  const R area = gjk::cross(a, edge);
  return area * R(area / gjk::dot(edge, edge));
}

/// `use(from, to)` of every edge, counter-clockwise.
template <class R, class Use>
void for_each_edge(const Polygon<R>& polygon, const Use& use) {
  int corner = polygon.first;
  do {
    use(corner, polygon.corners[corner].next);
    corner = polygon.corners[corner].next;
  } while (corner != polygon.first);
}

/// Every edge, counter-clockwise: for pictures.
template <class R>
[[nodiscard]] std::vector<Edge<R>> edges_in_order(const Polygon<R>& polygon) {
  std::vector<Edge<R>> edges;
  for_each_edge(polygon, [&](int from, int to) {
    edges.push_back({from, to, segment_distance_sq<R>(polygon.at(from), polygon.at(to))});
  });
  return edges;
}

namespace detail {

/// The order of the heap: is a farther than b?
template <class R>
[[nodiscard]] bool is_farther(const Edge<R>& a, const Edge<R>& b) {
  if (b.distance_sq < a.distance_sq) return true;
  return b.distance_sq == a.distance_sq && b.from < a.from;
}

template <class R>
void add_edge(Polygon<R>& polygon, int from, int to) {
  polygon.edges.push_back({from, to, segment_distance_sq<R>(polygon.at(from), polygon.at(to))});
  std::push_heap(polygon.edges.begin(), polygon.edges.end(), is_farther<R>);
}

/// The nearest edge, which leaves the heap: it ends the run, or it is replaced.
template <class R>
[[nodiscard]] Edge<R> take_nearest(Polygon<R>& polygon) {
  for (;;) {
    std::pop_heap(polygon.edges.begin(), polygon.edges.end(), is_farther<R>);
    Edge<R> edge = polygon.edges.back();
    polygon.edges.pop_back();
    if (polygon.corners[edge.from].next == edge.to) return edge;
  }
}

/// The first polygon: 1 to 3 points, in the order in which they are counter-clockwise.
template <class R, class S>
void start_with(std::vector<gjk::SupportPoint<R, 2>> points, const gjk::Query<S, 2>&,
                const gjk::Prepared<R, 2>&, State<R, 2>& state) {
  if (points.size() == 3) {
    const Vec<R, 2> in = points[1].w - points[0].w;
    const Vec<R, 2> out = points[2].w - points[1].w;
    if (gjk::cross(in, out) < R(0)) std::swap(points[1], points[2]);
  }
  Polygon<R>& polygon = state.polygon;
  const int count = static_cast<int>(points.size());
  polygon.count = count;
  for (int i = 0; i < count; ++i)
    polygon.corners.push_back({points[i], (i + count - 1) % count, (i + 1) % count});
  for (int i = 0; i < count; ++i) add_edge(polygon, i, polygon.corners[i].next);
}

/// Corner i of the nearest edge.
template <class R>
[[nodiscard]] const gjk::SupportPoint<R, 2>& nearest_corner(const State<R, 2>& state, int i) {
  return state.polygon.corners[i == 0 ? state.edge.from : state.edge.to].point;
}

/// A point has no normal: any direction will do.
template <class R, class Rec>
void find_nearest(State<R, 2>& state, Rec& record) {
  if constexpr (Rec::kOn) record.edges = edges_in_order(state.polygon);
  state.edge = take_nearest(state.polygon);
  const Vec<R, 2> edge = nearest_corner(state, 1).w - nearest_corner(state, 0).w;
  state.n = gjk::perpendicular<R, 2>({edge});
  if (gjk::is_zero(edge)) state.n = Vec<R, 2>::Unit(0);
}

/// Puts the support point between the ends of the edge. Ends that are corners no more, because the
/// polygon does not turn left there, are outgrown, and so are their neighbours in turn.
template <class R, class Rec>
void expand(State<R, 2>& state, Rec& record) {
  Polygon<R>& polygon = state.polygon;
  const int added = static_cast<int>(polygon.corners.size());
  polygon.corners.push_back({state.support, state.edge.from, state.edge.to});
  polygon.first = added;
  ++polygon.count;
  const auto link = [&](int from, int to) {
    polygon.corners[from].next = to;
    polygon.corners[to].previous = from;
  };
  link(state.edge.from, added);
  link(added, state.edge.to);

  const auto is_corner = [&](int i) {
    const Corner<R>& corner = polygon.corners[i];
    const Vec<R, 2> in = corner.point.w - polygon.at(corner.previous);
    const Vec<R, 2> out = polygon.at(corner.next) - corner.point.w;
    return R(0) < gjk::cross(in, out);
  };
  for (int Corner<R>::*const side : {&Corner<R>::previous, &Corner<R>::next}) {
    for (;;) {
      const int neighbour = polygon.corners[added].*side;
      if (polygon.count <= 3 || is_corner(neighbour)) break;
      Corner<R>& outgrown = polygon.corners[neighbour];
      link(outgrown.previous, outgrown.next);
      outgrown.previous = Corner<R>::kOutgrown;
      outgrown.next = Corner<R>::kOutgrown;
      --polygon.count;
      if constexpr (Rec::kOn) record.outgrown.push_back(neighbour);
    }
  }
  add_edge(polygon, polygon.corners[added].previous, added);
  add_edge(polygon, added, polygon.corners[added].next);
}

}  // namespace detail
}  // namespace depth
