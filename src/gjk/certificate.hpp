#pragma once
// The answer, and what is proved of it.

#include <array>

#include "gjk/expansion.hpp"
#include "gjk/prepare.hpp"
#include "gjk/state.hpp"

namespace gjk {

/// What the run came to. In the plane, for exact scalars and those that a double can hold, it is
/// proved: by exact arithmetic where rounding leaves it open.
enum class Verdict : std::uint8_t {
  separated,    ///< The distance is positive.
  touching,     ///< Distance 0, but some support plane of Z passes through O: the least motion in
                ///< some direction parts the shapes.
  overlapping,  ///< Distance 0, and O is an inner point of Z.
  undecided,    ///< The bounds leave it open: the run gave up, or its scalar has no exact arithmetic.
  none,         ///< The query was refused.
};

/// The answer, with its certificate: lower <= exact distance <= upper, rounding included.
template <class R, int D>
struct Result {
  using Real = typename ScalarTraits<R>::Real;
  Error error = Error::none;
  StopReason stop = StopReason::running;
  Verdict verdict = Verdict::none;
  bool settled = false;  ///< Rounding left the verdict open; exact arithmetic decided it.
  Real distance = ScalarTraits<R>::no_length();
  Real lower = ScalarTraits<R>::no_length();
  Real upper = ScalarTraits<R>::no_length();
  R distance_sq = R(0);
  Vec<R, D> x = Vec<R, D>::Zero();  ///< Witness point on X, world coordinates.
  Vec<R, D> y = Vec<R, D>::Zero();  ///< Witness point on Y.
  int iterations = 0;
  Simplex<R, D> simplex;  ///< The simplex whose weights made the witness points; its pairs
                          ///< warm-start the next query. In the run's unit of length.
};

namespace detail {

[[nodiscard]] inline double rounded(const Expansion& value) { return value.estimate(); }
template <class R>
[[nodiscard]] R rounded(const DoubleWord<R>& value) {
  return value.hi;
}

/// Distance of O from the feature (vertex, or line through an edge) of Z that the simplex names, in
/// the run's unit, from the vertices themselves: nothing rounds before the last few operations when
/// N is exact, and little when it is a DoubleWord.
template <class N, class R, class S>
[[nodiscard]] R careful_distance(const Query<S, 2>& query, const Prepared<R, 2>& prepared,
                                 const Simplex<R, 2>& simplex) {
  const auto vertex = [&](int i) {
    const VertexPair pair = simplex.vertices[i].pair;
    const Vec<R, 2> x = converted<R, S, 2>(query.x.vertices[pair.x]);
    const Vec<R, 2> y = converted<R, S, 2>(query.y.vertices[pair.y]);
    if (!prepared.in_world) return careful_difference<N>(query, x, y, prepared.unit);
    const Vec<R, 2> scaled_x = x * prepared.unit;
    const Vec<R, 2> scaled_y = y * prepared.unit;
    return std::array<N, 2>{N{scaled_y[0]} - N{scaled_x[0]}, N{scaled_y[1]} - N{scaled_x[1]}};
  };
  const auto size = [](const N& x, const N& y) {
    return length(Vec<R, 2>(R(rounded(x)), R(rounded(y))));
  };
  const std::array<N, 2> a = vertex(0);
  if (simplex.count == 1) return size(a[0], a[1]);
  const std::array<N, 2> b = vertex(1);
  const N edge_x = b[0] - a[0];
  const N edge_y = b[1] - a[1];
  const R cross = R(rounded(a[0] * edge_y - a[1] * edge_x));
  return (cross < R(0) ? R(-cross) : cross) / size(edge_x, edge_y);
}

/// Witness points, in the world, from the pairs and weights of a simplex.
template <class R, class S, int D>
void set_witness_points(Result<R, D>& out, const Query<S, D>& query) {
  const auto world = [](const Shape<S, D>& shape, int i) {
    const Vec<R, D> turned =
        shape.pose.template rotated<R>(converted<R, S, D>(shape.vertices[i]));
    return Vec<R, D>(turned + converted<R, S, D>(shape.pose.translation));
  };
  const Simplex<R, D>& simplex = out.simplex;
  out.x = world(query.x, simplex.vertices[0].pair.x);
  out.y = world(query.y, simplex.vertices[0].pair.y);
  const Vec<R, D> first_x = out.x;
  const Vec<R, D> first_y = out.y;
  for (int i = 1; i < simplex.count; ++i) {
    const Vec<R, D> x = world(query.x, simplex.vertices[i].pair.x);
    const Vec<R, D> y = world(query.y, simplex.vertices[i].pair.y);
    out.x = out.x + Vec<R, D>((x - first_x) * simplex.weights[i]);
    out.y = out.y + Vec<R, D>((y - first_y) * simplex.weights[i]);
  }
}

/// True when every weight of the full simplex around O is positive beyond doubt: a determinant of
/// vertices below `reach` in length errs by less than 4 D D! u (2 reach)^D.
template <class R, int D>
[[nodiscard]] bool surely_inside(const Simplex<R, D>& simplex, const Prepared<R, D>& prepared) {
  R error = R(4 * D) * ScalarTraits<R>::unit_roundoff();
  for (int i = 1; i <= D; ++i) error = error * R(2 * i) * prepared.reach;
  Barycentric<R, D> coordinates;
  volume_coordinates(simplex, coordinates);
  for (int i = 0; i <= D; ++i) {
    if (!(error < coordinates.numerator[i])) return false;
  }
  return true;
}

/// The distance as a floating-point run has it, between its bounds, in the run's unit.
template <class R>
struct Bounds {
  R lower = R(0);
  R distance = R(0);
  R upper = R(0);
};

/// Distance of O from the best simplex of the run, which has fewer than D+1 vertices, and a bound
/// that it certainly does not exceed.
template <class R, class S, int D>
void bound_from_above(const State<R, D>& state, const Query<S, D>& query,
                      const Prepared<R, D>& prepared, Bounds<R>& out) {
  const R u = ScalarTraits<R>::unit_roundoff();
  const R error = prepared.vertex_error + R(D == 2 ? 4 : 8 * D) * u * prepared.reach;
  out.distance = ScalarTraits<R>::root(state.best_sq);
  out.upper = out.distance + error;
  if constexpr (D == 2) {
    const Simplex<R, 2>& simplex = state.best;
    const bool on_edge = simplex.count == 2;
    const Vec<R, 2>& a = simplex.vertices[0].w;
    const Vec<R, 2> edge = simplex.vertices[1].w - a;
    const R edge_length = on_edge ? length(edge) : R(0);
    if (on_edge) out.distance = magnitude(determinant<R, 2>({a, edge})) / edge_length;
    out.upper = out.distance + error;
    // Near O the rounding of the vertices would be most of the answer.
    if (R(prepared.in_world ? 16 : 4096) * out.distance < prepared.reach) {
      out.distance = careful_distance<DoubleWord<R>>(query, prepared, simplex);
      out.upper = out.distance * (R(1) + R(8) * u) + prepared.careful_error;
    }
    if (on_edge) {
      // P, where the line through the edge is nearest to O, may lie beyond an end by this much.
      const R doubt = error + prepared.vertex_error * R(out.distance / edge_length);
      const R to_end = edge_length * std::min(simplex.weights[0], simplex.weights[1]);
      if (to_end < doubt) out.upper = length(Vec<R, 2>(out.upper, std::min(doubt, edge_length)));
    }
  }
}

/// The certificate of a floating-point run.
template <class R, class S, int D>
[[nodiscard]] Bounds<R> bounds(const State<R, D>& state, const Query<S, D>& query,
                               const Prepared<R, D>& prepared) {
  Bounds<R> out;
  if (state.best.count <= D) {
    bound_from_above(state, query, prepared, out);
  } else if (!surely_inside(state.best, prepared)) {
    out.upper = prepared.vertex_error + R(8 * D) * ScalarTraits<R>::unit_roundoff() * prepared.reach;
  }
  const R plane = ScalarTraits<R>::root_below(state.plane_distance_sq) - prepared.plane_error;
  out.lower = std::max(plane, R(0));
  out.distance = std::max(out.distance, out.lower);
  out.upper = std::max(out.distance, out.upper);
  return out;
}

}  // namespace detail
}  // namespace gjk
