#pragma once
// Phase "support": the farthest point of the Minkowski difference along d.
//
// Sign convention of the whole project, the slides': Z = Y - X, and the query point is the origin
// O. For a point query X = {Q}, so that d, drawn in the world, points from P to Q.

#include "gjk/prepare.hpp"
#include "gjk/record.hpp"

namespace gjk {

/// A vertex as its shape's pose turns it, seen from the shape's centre, in the run's unit.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> turned_vertex(const Shape<S, D>& shape, const Prepared<R, D>& prepared,
                                      const Body<R, D>& body, int i) {
  if (body.placed_count > 0) return body.placed[i];
  return shape.pose.template rotated<R>(detail::from_centre(shape, prepared, body, i));
}

/// w = (Ry y + ty) - (Rx x + tx), in the run's unit. A translation common to both shapes cancels
/// before anything rounds.
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

/// `use(count, along)` for the vertices of a shape along a direction of the world:
/// along(i) = dot(d, vertex i - centre).
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

/// The first of the vertices that lie farthest (Catto 2010, slide "Support point code"). Without a
/// branch on how vertices compare, which processors guess wrong.
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

/// The vertex of a shape that lies farthest along d; of equal ones the first. `visit(i, along)` of
/// each vertex that is looked at.
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
    R rounding(0);  // of two dot products of centred vertices
    if constexpr (!ScalarTraits<R>::kExact) {
      rounding = R(4 * (D + 1)) * ScalarTraits<R>::unit_roundoff() * norm_1(d) * body.radius;
    }
    return detail::climb(count, looked_at, rounding);
  });
}

/// support(Z, d) = support(Y, d) - support(X, -d)  (Catto 2010, slide "Property 2: support
/// points").
template <class R, class S, int D>
[[nodiscard]] VertexPair farthest_pair(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                       const Vec<R, D>& d) {
  const auto nothing = [](int, const R&) {};
  return {farthest_vertex(Vec<R, D>(-d), query.x, prepared, prepared.x, nothing),
          farthest_vertex(d, query.y, prepared, prepared.y, nothing)};
}

/// The vertices that `farthest_vertex` looks at, in its order. Values as in the shape's own frame.
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

/// Larsen's slab (1998, "Proof of Local Verification"): all of Z lies beyond the plane through the
/// support point, normal to d, so -dot(d, w) / |d| is a lower bound of the distance.
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
