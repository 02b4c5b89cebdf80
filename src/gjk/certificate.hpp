#pragma once
// The answer, and what is proved of it.

#include <array>

#include "gjk/expansion.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// What the run came to. In the plane, for exact scalars and those that a double can hold, it is
/// proved: by exact arithmetic where rounding leaves it open.
enum class Verdict : std::uint8_t {
  separated,    ///< The distance is positive.
  touching,     ///< Distance 0, but some support plane of Z passes through O: the least motion in
                ///< some direction parts the shapes.
  overlapping,  ///< Distance 0, and O is an inner point of Z.
  undecided,  ///< The bounds leave it open: the run gave up, or its scalar has no exact arithmetic.
  none,       ///< The query was refused.
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

/// A vertex of Z from the vertices themselves, in the run's unit. Nothing rounds when N is exact,
/// and little when it is a DoubleWord.
template <class N, class R, class S>
[[nodiscard]] std::array<N, 2> careful_vertex(const Query<S, 2>& query,
                                              const Prepared<R, 2>& prepared, VertexPair pair) {
  const Vec<R, 2> x = converted<R, S, 2>(query.x.vertices[pair.x]);
  const Vec<R, 2> y = converted<R, S, 2>(query.y.vertices[pair.y]);
  if (!prepared.same_frame) return careful_difference<N>(query, x, y, prepared.unit);
  const Vec<R, 2> scaled_x = x * prepared.unit;
  const Vec<R, 2> scaled_y = y * prepared.unit;
  return {N{scaled_y[0]} - N{scaled_x[0]}, N{scaled_y[1]} - N{scaled_x[1]}};
}

/// The length of a vector whose squares may underflow.
template <class R>
[[nodiscard]] R careful_length(const R& x, const R& y) {
  const R size = std::max(magnitude(x), magnitude(y));
  if (size == R(0)) return size;
  const int exponent = ScalarTraits<R>::is_in_range(size) ? 0 : ScalarTraits<R>::exponent(size);
  const auto scaled = [&](const R& a) { return ScalarTraits<R>::scaled(a, -exponent); };
  const R in_unit = length(Vec<R, 2>(scaled(x), scaled(y)));
  return ScalarTraits<R>::scaled(in_unit, exponent);
}

/// How often `careful_distance` rounds, and its bounds do, at worst: both coordinates of the edge,
/// the determinant, three times in the length, the quotient, and the bound.
inline constexpr int kCarefulRoundings = 6;

/// Distance of O from the feature of Z, vertex or line through an edge, that the simplex names, in
/// the run's unit: nothing rounds before the last few operations when N is exact, and little when
/// it is a DoubleWord. Negative when O lies on that side of the edge to which perpendicular(edge)
/// points.
template <class N, class R, class S>
[[nodiscard]] R careful_distance(const Query<S, 2>& query, const Prepared<R, 2>& prepared,
                                 const Simplex<R, 2>& simplex) {
  const std::array<N, 2> a = careful_vertex<N>(query, prepared, simplex.vertices[0].pair);
  if (simplex.count == 1) return R(careful_length(rounded(a[0]), rounded(a[1])));
  const std::array<N, 2> b = careful_vertex<N>(query, prepared, simplex.vertices[1].pair);
  const N edge_x = b[0] - a[0];
  const N edge_y = b[1] - a[1];
  return R(rounded(a[0] * edge_y - a[1] * edge_x) /
           careful_length(rounded(edge_x), rounded(edge_y)));
}

/// The largest coordinate of the simplex.
template <class R, int D>
[[nodiscard]] R largest_coordinate(const Simplex<R, D>& simplex) {
  R size(0);
  for (int i = 0; i < simplex.count; ++i) size = std::max(size, norm_max(simplex.vertices[i].w));
  return size;
}

/// The weights put P at O, but for the least that rounding can do.
template <class R, int D>
[[nodiscard]] bool is_at_origin(const Simplex<R, D>& simplex) {
  const R rounding = ScalarTraits<R>::unit_roundoff() * largest_coordinate(simplex);
  return !(rounding < norm_max(weighted_point(simplex, simplex.all())));
}

/// Weights of a simplex around O, with about twice the digits: in a thin one the run's own put P
/// visibly beside O.
template <class R, class S>
void set_careful_weights(Simplex<R, 2>& simplex, const Query<S, 2>& query,
                         const Prepared<R, 2>& prepared) {
  std::array<std::array<DoubleWord<R>, 2>, 3> w;
  for (int i = 0; i < 3; ++i) {
    w[i] = careful_vertex<DoubleWord<R>>(query, prepared, simplex.vertices[i].pair);
  }
  R sum(0);
  for (int i = 0; i < 3; ++i) {
    const auto& b = w[(i + 1) % 3];
    const auto& c = w[(i + 2) % 3];
    simplex.weights[i] = magnitude(rounded(b[0] * c[1] - b[1] * c[0]));
    sum = sum + simplex.weights[i];
  }
  for (int i = 0; i < 3; ++i) simplex.weights[i] = simplex.weights[i] / sum;
}

/// Witness points, in the world, from the pairs and weights of a simplex. They are put together
/// from the vertex of the largest weight, so that little rounds but the last addition.
template <class R, class S, int D>
void set_witness_points(Result<R, D>& out, const Query<S, D>& query,
                        const Prepared<R, D>& prepared) {
  using W = RunScalar<Default, R>;
  const Simplex<R, D>& simplex = out.simplex;
  R sum = simplex.weights[0];
  int base = 0;
  for (int i = 1; i < simplex.count; ++i) {
    sum = sum + simplex.weights[i];
    if (simplex.weights[base] < simplex.weights[i]) base = i;
  }
  const auto set = [&](Vec<R, D>& point, const Shape<S, D>& shape, int VertexPair::*index,
                       bool turned) {
    const auto vertex = [&](int i) -> decltype(auto) {
      return converted<W, S, D>(shape.vertices[simplex.vertices[i].pair.*index]);
    };
    const auto& from = vertex(base);
    Vec<W, D> beyond = Vec<W, D>::Zero();
    for (int i = 0; i < simplex.count; ++i) {
      if (i == base) continue;
      const W weight = ScalarTraits<W>::from(R(simplex.weights[i] / sum));
      beyond = beyond + Vec<W, D>((vertex(i) - from) * weight);
    }
    const Vec<W, D> local = from + beyond;
    Vec<W, D> world = turned ? shape.pose.template rotated<W>(local) : local;
    world = world + converted<W, S, D>(shape.pose.translation);
    for (int i = 0; i < D; ++i) point[i] = static_cast<R>(world[i]);
  };
  set(out.x, query.x, &VertexPair::x, prepared.x_turned);
  set(out.y, query.y, &VertexPair::y, prepared.y_turned);
}

/// True when every weight of the full simplex around O is positive beyond doubt: a determinant of D
/// vertices, none longer than r and each in doubt by e + u r, errs by less than r^(D-1) (D e +
/// 8 D D! u r).
template <class R, int D>
[[nodiscard]] bool surely_inside(const Simplex<R, D>& simplex, const Prepared<R, D>& prepared) {
  const R r = ScalarTraits<R>::from(D == 2 ? 1.5 : 1.8) * largest_coordinate(simplex);
  R error =
      R(D) * prepared.vertex_error + R(D == 2 ? 32 : 144) * ScalarTraits<R>::unit_roundoff() * r;
  for (int i = 1; i < D; ++i) error = error * r;
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
  bool tight = false;  ///< As close as rounding lets them be. Else rounding led the run astray.
};

/// How many vertices may lie as far along a direction as vertices `i` and `j`, for all that
/// rounding lets one know.
template <class R, class S, int D>
[[nodiscard]] int count_as_far(const Along<R, S, D>& along, int i, int j, const R& error) {
  const R certainly_nearer = std::min(along(i), along(j)) - error;
  int count = 0;
  for (std::size_t k = 0; k < along.vertices.size(); ++k) {
    count += along(k) < certainly_nearer ? 0 : 1;
  }
  return count;
}

/// True when certainly no vertex of Z but those of the simplex lies as far along d, which is in
/// doubt by `angle`.
template <class R, class S>
[[nodiscard]] bool is_certainly_farthest(const Simplex<R, 2>& simplex, const Vec<R, 2>& d,
                                         const R& angle, const Query<S, 2>& query,
                                         const Prepared<R, 2>& prepared) {
  const R error = length(d) * (prepared.scan_error + R(2) * angle * prepared.extent);
  const VertexPair first = simplex.vertices[0].pair;
  const VertexPair last = simplex.vertices[simplex.count - 1].pair;
  return count_as_far(along_x(query, prepared, d), first.x, last.x, error) *
             count_as_far(along_y(query, prepared, d), first.y, last.y, error) ==
         simplex.count;
}

/// Bounds from P, when it is a vertex of Z or lies between two, and from the best support plane.
///
/// Far from O the numbers of the run do. The nearer P is, the more of its distance is the rounding
/// of vertices: then the distance is computed anew, with about twice the digits. Nearer still, the
/// vertices that P lies between may be the wrong ones, unless all others are certainly farther.
template <class R, class S>
[[nodiscard, gnu::flatten]] Bounds<R> bounds_outside(const State<R, 2>& state,
                                                     const Query<S, 2>& query,
                                                     const Prepared<R, 2>& prepared) {
  const R u = ScalarTraits<R>::unit_roundoff();
  const Simplex<R, 2>& simplex = state.best;
  const Vec<R, 2>& a = simplex.vertices[0].w;
  const Vec<R, 2>& b = simplex.vertices[1].w;
  const bool on_edge = simplex.count == 2;
  const Vec<R, 2> edge = b - a;
  const R edge_length = on_edge ? length(edge) : R(0);
  const R size = on_edge ? std::max(length(a), length(b)) : length(a);
  const R vertex_error = prepared.vertex_error + u * size;

  Bounds<R> out;
  R to_line = on_edge ? R(determinant<R, 2>({a, edge}) / edge_length) : size;
  R error = prepared.vertex_error + R(4) * u * magnitude(to_line);
  if (on_edge) error = error + u * (size + R(3) * std::min(length(a), length(b)));
  const R plane_error = detail::plane_error(state, prepared);
  out.lower = std::max(R(ScalarTraits<R>::root(state.plane_distance_sq) - plane_error), R(0));

  const bool near = R(4096) * magnitude(to_line) < prepared.reach;
  // The largest vertex of Z is no smaller than `size`, nor than box_reach over the root of 2.
  R allowed = R(15.5) * u * size;
  const R width = magnitude(to_line) + error - out.lower;
  bool wide = allowed < width;
  if (wide) {
    allowed = std::max(allowed, R(R(10.9) * u * box_reach(query, prepared)));
    wide = allowed < width;
  }
  if (near || wide || (prepared.same_frame && R(16) * magnitude(to_line) < prepared.reach)) {
    to_line = careful_distance<DoubleWord<R>>(query, prepared, simplex);
    error = R(kCarefulRoundings) * u * magnitude(to_line) + prepared.careful_error;
  }
  out.distance = magnitude(to_line);
  out.upper = out.distance + error;
  const R angle = R(2) * u + R(2) * vertex_error / (on_edge ? edge_length : size);
  if (on_edge) {
    // The foot of the perpendicular from O may lie beyond an end of the edge by this much.
    const R beyond = vertex_error + R(4) * u * size + angle * out.distance;
    const R to_end = edge_length * std::min(simplex.weights[0], simplex.weights[1]);
    if (to_end < beyond) out.upper = length(Vec<R, 2>(out.upper, std::min(beyond, edge_length)));
  }
  if (near || wide) {
    const Vec<R, 2> normal = perpendicular<R, 2>({edge});
    const Vec<R, 2> d = !on_edge ? Vec<R, 2>(-a) : R(0) < to_line ? Vec<R, 2>(-normal) : normal;
    if (is_certainly_farthest(simplex, d, angle, query, prepared)) {
      out.lower = std::max(R(out.distance - error), R(0));
    }
  }
  out.distance = std::max(out.distance, out.lower);
  out.upper = std::max(out.distance, out.upper);
  out.tight = out.upper - out.lower <= (near ? R(R(4) * error) : allowed);
  return out;
}

/// The certificate of a floating-point run.
template <class R, class S, int D>
[[nodiscard]] Bounds<R> bounds(const State<R, D>& state, const Query<S, D>& query,
                               const Prepared<R, D>& prepared) {
  Bounds<R> out;
  const R error =
      prepared.vertex_error + R(8 * D) * ScalarTraits<R>::unit_roundoff() * prepared.reach;
  if (state.best.count == D + 1) {
    out.tight = true;
    if (!surely_inside(state.best, prepared)) out.upper = error;
    return out;
  }
  if constexpr (D == 2) {
    return bounds_outside(state, query, prepared);
  } else {
    out.lower = ScalarTraits<R>::root(state.plane_distance_sq) - plane_error(state, prepared);
    out.lower = std::max(out.lower, R(0));
    out.distance = std::max(out.lower, ScalarTraits<R>::root(state.best_sq));
    out.upper = out.distance + error;
    out.tight = true;
    return out;
  }
}

}  // namespace detail
}  // namespace gjk
