#pragma once
// Phase "support": the farthest point of the Minkowski difference along d.
//
// Sign convention of the whole project, the slides': Z = Y - X, and the query point is the origin
// O. For a point query X = {Q}, so that d, drawn in the world, points from P to Q.

#include "gjk/state.hpp"

namespace gjk {

/// What the phases need to know of a query beyond its shapes; made once by `prepare`.
template <class S>
struct Prepared {
  /// At least |x| + |y| + |offset|, over all coordinates of vertices and poses: what rounding
  /// errors are proportional to.
  S scale = S(0);
  Error error = Error::none;
};

namespace detail {

/// Roundings that enter dot(d, y - x) and the scans that chose x and y, each at most u * scale *
/// |d|_1: D+1 for each of d and the vertices when a pose turns them, D for each dot product, the
/// rest for differences. tests/gjk/bounds_test.cpp checks the bounds that follow from it against
/// exact ones.
template <int D>
inline constexpr int kRoundings = 4 * D + 4;

template <int D, class S>
[[nodiscard]] S support_error(const S& scale, const S& d_norm_1) {
  return S(kRoundings<D>) * ScalarTraits<S>::unit_roundoff() * scale * d_norm_1 +
         S(kRoundings<D>) * ScalarTraits<S>::smallest();
}

/// The slides' scan: the first vertex with the largest dot product (Catto 2010, slide "Support
/// point code"). `d` is in the shape's own frame.
template <bool kRecord, class S, int D>
[[nodiscard]] int scan(std::span<const Vec<S, D>> vertices, const Vec<S, D>& d,
                       std::vector<ScanEntry<S>>* entries) {
  int best = 0;
  S best_value = dot(d, vertices[0]);
  if constexpr (kRecord) entries->push_back({0, best_value, true});
  for (int i = 1; i < static_cast<int>(vertices.size()); ++i) {
    const S value = dot(d, vertices[i]);
    const bool improves = best_value < value;
    if constexpr (kRecord) entries->push_back({i, value, improves});
    if (improves) {
      best = i;
      best_value = value;
    }
  }
  return best;
}

/// w = (Ry y + ty) - (Rx x + tx), summed so that a common translation of both shapes cancels before
/// anything rounds.
template <class S, int D>
[[nodiscard]] SupportPoint<S, D> support_point(const Query<S, D>& query, VertexPair pair) {
  SupportPoint<S, D> point;
  const Vec<S, D> x = query.x.pose.rotated(query.x.vertices[pair.x]);
  const Vec<S, D> y = query.y.pose.rotated(query.y.vertices[pair.y]);
  const Vec<S, D> offset = query.y.pose.translation - query.x.pose.translation;
  point.pair = pair;
  point.x = x + query.x.pose.translation;
  point.y = y + query.y.pose.translation;
  point.w = (y - x) + offset;
  return point;
}

/// Larsen's slab (1998, "Proof of Local Verification"): all of Z lies beyond the plane through the
/// support point, normal to d, so -dot(d, w) / |d| is a lower bound of the distance. The scan may
/// have preferred a wrong vertex, and the value itself is rounded; the error subtracted covers
/// both.
template <class S, int D>
void note_support_plane(State<S, D>& state, const Prepared<S>& prepared) {
  const S error = support_error<D>(prepared.scale, norm_1(state.d));
  const S gap = -state.support_value - error;
  const S d_sq = dot(state.d, state.d);
  if (!(S(0) < gap) || !(S(0) < d_sq)) return;
  const S distance_sq = gap * S(gap / d_sq);
  if (state.plane_distance_sq < distance_sq) state.plane_distance_sq = distance_sq;
}

/// support(Z, d) = support(Y, d) - support(X, -d)  (Catto 2010, slide "Property 2: support
/// points").
template <class S, int D, class Rec>
void find_support(State<S, D>& state, const Query<S, D>& query, const Prepared<S>& prepared,
                  Rec& record) {
  const Vec<S, D> d_x = query.x.pose.direction_to_local(-state.d);
  const Vec<S, D> d_y = query.y.pose.direction_to_local(state.d);
  VertexPair pair;
  if constexpr (Rec::kOn) {
    pair.x = scan<true, S, D>(query.x.vertices, d_x, &record.scan_x);
    pair.y = scan<true, S, D>(query.y.vertices, d_y, &record.scan_y);
  } else {
    pair.x = scan<false, S, D>(query.x.vertices, d_x, nullptr);
    pair.y = scan<false, S, D>(query.y.vertices, d_y, nullptr);
  }
  state.support = support_point(query, pair);
  state.support_value = dot(state.d, state.support.w);
  if (!ScalarTraits<S>::is_finite(state.support_value)) state.error = Error::overflow;

  note_support_plane(state, prepared);
  if (state.support_value == S(0)) state.touches_plane = true;
  state.previous = Phase::support;
  state.phase = Phase::stop;
}

}  // namespace detail
}  // namespace gjk
