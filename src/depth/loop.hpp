#pragma once
// The expanding polygon (van den Bergen 2001, "Proximity queries and penetration depth computation
// on 3D game objects", there in space).
//
//   start with GJK's last simplex, which has O inside
//   loop
//     nearest    take the edge that is nearest to O, and its outward normal n
//     support    find the support point of Z = Y - X in direction n
//     stop       decide whether the edge lies on the boundary of Z
//     expand     put the support point between the ends of the edge
//
// All corners are points of Z, so the polygon lies in Z: the nearest edge bounds the depth from
// below. All of Z lies on this side of the line through the support point, normal to n: that line
// bounds the depth from above. They meet in the edge of Z that is nearest to O.
//
// A step costs what a support point does, and O(log n) for the heap of n edges.

#include "depth/state.hpp"
#include "gjk/proof/result.hpp"

namespace depth {
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

/// The normal of the edge ab on the side away from O. A point has none: any direction will do.
template <class R>
[[nodiscard]] Vec<R, 2> outward_normal(const Vec<R, 2>& a, const Vec<R, 2>& b) {
  const Vec<R, 2> normal = gjk::perpendicular<R, 2>({Vec<R, 2>(b - a)});
  return gjk::is_zero(normal) ? Vec<R, 2>(R(1), R(0)) : normal;
}

template <class R, class Rec>
void find_nearest_edge(State<R>& state, Rec& record) {
  Polygon<R>& polygon = state.polygon;
  if constexpr (Rec::kOn) record.edges = edges_in_order(polygon);
  state.edge = take_nearest(polygon);
  state.n = outward_normal(polygon.at(state.edge.from), polygon.at(state.edge.to));
  state.phase = Phase::support;
}

template <class R, class S, class Rec>
void find_support(State<R>& state, const gjk::Query<S, 2>& query,
                  const gjk::Prepared<R, 2>& prepared, Rec& record) {
  if constexpr (Rec::kOn) {
    record.scan_x = gjk::scan_entries(Vec<R, 2>(-state.n), query.x, prepared, prepared.x);
    record.scan_y = gjk::scan_entries(state.n, query.y, prepared, prepared.y);
  }
  state.support = gjk::support_point(query, prepared, gjk::farthest_pair(query, prepared, state.n));
  state.phase = Phase::stop;
}

/// In exact arithmetic each iteration finds another corner of Z, which has no more than both shapes
/// together. Rounding may find some twice.
template <class S>
[[nodiscard]] int iteration_cap(const gjk::Query<S, 2>& query) {
  return 8 + 2 * static_cast<int>(query.x.vertices().size() + query.y.vertices().size());
}

/// The stop tests, in order; the first that holds names the reason. What each compares:
///
///   reason            left                                     right           holds if
///   repeated_support  end of the edge that is the support      0               left >= right
///                     point: 0, 1, or -1 for none
///   no_progress       dot(n, support - end of the edge)        its rounding    left <= right
///   iteration_cap     cap                                      iteration       left <= right
template <class R, class S, class Rec>
void run_stop_tests(State<R>& state, const gjk::Query<S, 2>& query, Rec& record) {
  const auto test = [&](StopReason reason, bool holds, const R& left, const R& right) {
    const bool tried = state.stop == StopReason::running;
    if constexpr (Rec::kOn) {
      record.stop_tests.push_back({reason, tried, tried && holds, left, right});
    }
    if (tried && holds) state.stop = reason;
  };
  const gjk::SupportPoint<R, 2>& a = state.polygon.corners[state.edge.from].point;
  const gjk::SupportPoint<R, 2>& b = state.polygon.corners[state.edge.to].point;
  int repeated = -1;
  if (state.support.pair == b.pair) repeated = 1;
  if (state.support.pair == a.pair) repeated = 0;
  const Vec<R, 2> beyond = state.support.w - a.w;
  const R farther = gjk::dot(state.n, beyond);
  R rounding(0);
  if constexpr (!gjk::ScalarTraits<R>::kExact) {
    rounding =
        R(4) * gjk::ScalarTraits<R>::unit_roundoff() * gjk::norm_1(state.n) * gjk::norm_max(beyond);
  }
  const int cap = iteration_cap(query);

  test(StopReason::repeated_support, repeated >= 0, R(repeated), R(0));
  test(StopReason::no_progress, !(rounding < farther), farther, rounding);
  test(StopReason::iteration_cap, cap <= state.iteration, R(cap), R(state.iteration));
  if (state.stop == StopReason::running) state.phase = Phase::expand;
}

/// Puts the support point between the ends of the edge. Ends that are corners no more, because the
/// polygon does not turn left there, are outgrown, and so are their neighbours in turn.
template <class R, class Rec>
void expand(State<R>& state, Rec& record) {
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
  ++state.iteration;
  state.phase = Phase::nearest;
}

}  // namespace detail

/// The state before the first phase: the polygon is the simplex that GJK found around O.
template <class R, class S, class Found>
[[nodiscard]] State<R> start(const gjk::Query<S, 2>& query, const gjk::Prepared<R, 2>& prepared,
                             const gjk::Result<Found, 2>& found) {
  State<R> state;
  const auto refuse = [&](StopReason reason) {
    state.stop = reason;
    state.phase = Phase::stop;
    return state;
  };
  if (found.verdict == gjk::Verdict::none) return refuse(StopReason::failed);
  if (found.verdict == gjk::Verdict::separated) return refuse(StopReason::separated);
  if (found.verdict == gjk::Verdict::undecided) return refuse(StopReason::undecided);

  Polygon<R>& polygon = state.polygon;
  const int count = found.simplex.count;
  polygon.count = count;
  for (int i = 0; i < count; ++i) {
    const gjk::VertexPair pair = found.simplex.vertices[i].pair;
    polygon.corners.push_back(
        {gjk::support_point(query, prepared, pair), (i + count - 1) % count, (i + 1) % count});
  }
  if (count == 3) {
    const Vec<R, 2> in = polygon.at(1) - polygon.at(0);
    const Vec<R, 2> out = polygon.at(2) - polygon.at(1);
    if (gjk::cross(in, out) < R(0)) std::swap(polygon.corners[1].point, polygon.corners[2].point);
  }
  for (int i = 0; i < count; ++i) detail::add_edge(polygon, i, polygon.corners[i].next);
  return state;
}

/// Runs the phase `state.phase`. The run goes on while `state.stop` is StopReason::running.
template <class R, class S, class Rec>
void step(State<R>& state, const gjk::Query<S, 2>& query, const gjk::Prepared<R, 2>& prepared,
          Rec& record) {
  switch (state.phase) {
    case Phase::nearest:
      return detail::find_nearest_edge(state, record);
    case Phase::support:
      return detail::find_support(state, query, prepared, record);
    case Phase::stop:
      return detail::run_stop_tests(state, query, record);
    case Phase::expand:
      return detail::expand(state, record);
  }
}

/// Runs all phases until the run ends, recording nothing.
template <class R, class S>
void run(State<R>& state, const gjk::Query<S, 2>& query, const gjk::Prepared<R, 2>& prepared) {
  NoRecord none;
  while (state.stop == StopReason::running) step(state, query, prepared, none);
}

}  // namespace depth
