#pragma once
// Phase "support": the farthest point of the Minkowski difference along d.
//
// The sign convention of the whole project is the slides': Z = Y - X, and the query point is the
// origin O. For a point query X = {Q}, so d, drawn in the world, points from P to Q.

#include "gjk/prepare.hpp"
#include "gjk/record.hpp"

namespace gjk {

/// Vertex i relative to its shape's centre, in world axes and the run's unit.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> turned_vertex(const Shape<S, D>& shape, const Prepared<R, D>& prepared,
                                      const Body<R, D>& body, int i) {
  if (body.placed_count > 0) return body.placed[i];
  return shape.pose.template rotated<R>(detail::from_centre(shape, prepared, body, i));
}

/// w = (Ry y + ty) - (Rx x + tx), in the run's unit, for rotations R and translations t. A
/// translation common to both shapes cancels before anything rounds.
template <class R, class S, int D>
[[nodiscard]] SupportPoint<R, D> support_point(const Query<S, D>& query,
                                               const Prepared<R, D>& prepared, VertexPair pair) {
  if (prepared.same_frame) {
    const auto& x = converted<R, S, D>(query.x.vertices()[pair.x]);
    const auto& y = converted<R, S, D>(query.y.vertices()[pair.y]);
    return {prepared.in_unit(y) - prepared.in_unit(x), pair};
  }
  const Vec<R, D> x = turned_vertex(query.x, prepared, prepared.x, pair.x);
  const Vec<R, D> y = turned_vertex(query.y, prepared, prepared.y, pair.y);
  return {Vec<R, D>(y - x) + prepared.offset, pair};
}

/// Returns use(count, along), with along(i) = dot(d, vertex i - centre) for a shape's `count`
/// vertices and a direction d in world axes.
template <class R, class S, int D, class Use>
auto look_along(const Vec<R, D>& d, const Shape<S, D>& shape, const Prepared<R, D>& prepared,
                const Body<R, D>& body, const Use& use) {
  const int count = static_cast<int>(shape.vertices().size());
  if (body.placed_count > 0) {
    return use(count, [&](int i) { return dot(d, body.placed[i]); });
  }
  const Vec<R, D> local = shape.pose.template direction_to_local<R>(d);
  return use(count,
             [&](int i) { return dot(local, detail::from_centre(shape, prepared, body, i)); });
}

/// The first of the farthest vertices (Catto 2010, slide "Support point code"). Comparisons select
/// instead of branching, because processors would mispredict the branch.
template <class R, class Along>
[[nodiscard]] int scan(int count, const Along& along) {
  int index = 0;
  R most = along(0);
  for (int i = 1; i < count; ++i) {
    const R value = along(i);
    index = most < value ? i : index;
    most = larger(most, value);
  }
  return index;
}

/// The vertex of a shape that lies farthest along d; of equal ones the first. Calls visit(i, value)
/// for each vertex that it looks at.
template <class R, class S, int D, class Visit>
[[nodiscard]] int farthest_vertex(const Vec<R, D>& d, const Shape<S, D>& shape,
                                  const Prepared<R, D>& prepared, const Body<R, D>& body,
                                  const Visit& visit) {
  return look_along(d, shape, prepared, body, [&](int count, const auto& along) {
    const auto looked_at = [&](int i) {
      R value = along(i);
      visit(i, value);
      return value;
    };
    if (!body.is_ring) [[likely]]
      return scan<R>(count, looked_at);
    R rounding(0);  // of the difference of two values
    if constexpr (!ScalarTraits<R>::kExact) {
      rounding = R(4 * (D + 1)) * ScalarTraits<R>::unit_roundoff() * norm_1(d) * body.radius;
    }
    return detail::climb(count, looked_at, rounding);
  });
}

/// The pair that makes Z's support point: support(Z, d) = support(Y, d) - support(X, -d) (Catto
/// 2010, slide "Property 2: support points").
template <class R, class S, int D>
[[nodiscard]] VertexPair farthest_pair(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                       const Vec<R, D>& d) {
  const auto nothing = [](int, const R&) {};
  return {farthest_vertex(Vec<R, D>(-d), query.x, prepared, prepared.x, nothing),
          farthest_vertex(d, query.y, prepared, prepared.y, nothing)};
}

/// The record of `farthest_vertex`: the vertices that it looks at, in its order.
template <class R, class S, int D>
[[nodiscard]] std::vector<ScanEntry<R>> scan_entries(const Vec<R, D>& d, const Shape<S, D>& shape,
                                                     const Prepared<R, D>& prepared,
                                                     const Body<R, D>& body) {
  std::vector<ScanEntry<R>> entries;
  const R at_centre = dot(d, shape.pose.template rotated<R>(prepared.in_unit(body.centre)));
  detail::Farthest<R> farthest;
  static_cast<void>(farthest_vertex(d, shape, prepared, body, [&](int i, const R& value) {
    entries.push_back({i, value + at_centre, farthest.offer(i, value)});
  }));
  return entries;
}

/// Notes the plane through the support point w with normal d. All of Z lies beyond it, so
/// -dot(d, w) / |d| is a lower bound of the distance (Larsen 1998, "Proof of Local Verification").
template <class R, int D>
void note_support_plane(State<R, D>& state) {
  const R d_sq = dot(state.d, state.d);
  if (!(state.support_value < R(0)) || !(R(0) < d_sq)) return;
  const R distance_sq = state.support_value * R(state.support_value / d_sq);
  if (!(state.plane_distance_sq < distance_sq)) return;
  state.plane_distance_sq = distance_sq;
  state.plane_reach_sq = dot(state.support.w, state.support.w);
}

template <class R, class S, int D, class Rec>
void find_support(State<R, D>& state, const Query<S, D>& query, const Prepared<R, D>& prepared,
                  Rec& record) {
  if constexpr (Rec::kOn) {
    record.scan_x = scan_entries(Vec<R, D>(-state.d), query.x, prepared, prepared.x);
    record.scan_y = scan_entries(state.d, query.y, prepared, prepared.y);
  }
  state.support = support_point(query, prepared, farthest_pair(query, prepared, state.d));
  state.support_value = dot(state.d, state.support.w);
  note_support_plane(state);
  if (state.support_value == R(0)) state.touches_plane = true;
  state.previous = Phase::support;
  state.phase = Phase::stop;
}

}  // namespace gjk
