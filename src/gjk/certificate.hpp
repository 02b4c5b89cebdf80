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
  Vec<R, D> y = Vec<R, D>::Zero();  ///< Witness point on Y: the same where the shapes meet.
  int iterations = 0;
  Simplex<R, D> simplex;  ///< The simplex whose weights made the witness points, in the run's unit
                          ///< of length.

  /// For the next query of the same shapes, somewhat moved.
  [[nodiscard]] WarmStart warm() const { return warm_start(simplex); }
};

namespace detail {

template <class R>
[[nodiscard]] R rounded(const Expansion& value) {
  return value.estimate<R>();
}
template <class R>
[[nodiscard]] R rounded(const DoubleWord<R>& value) {
  return value.hi;
}

/// Adds up numbers and products of two, with what rounding loses kept beside them. R: see
/// exact_product.
template <class R, class Number = R>
class CarefulSum {
 public:
  explicit CarefulSum(const R& first) : sum_{first, R{}} {}
  void add(const R& a) {
    const DoubleWord<R> next = exact_sum(sum_.hi, a);
    sum_ = {next.hi, R(sum_.lo + next.lo)};
  }
  void add_product(const R& a, const R& b) {
    const DoubleWord<R> product = exact_product<R, Number>(a, b);
    add(product.hi);
    sum_.lo = sum_.lo + product.lo;
  }
  /// Not normalised.
  [[nodiscard]] const DoubleWord<R>& sum() const { return sum_; }

 private:
  DoubleWord<R> sum_;
};

/// A vertex of Z, and the way from there to another one.
template <class N>
struct Edge {
  Flat<N> from;
  Flat<N> way;
};

/// The edge from a to b, from the vertices themselves, in the run's unit, with about twice the
/// digits. Nearly always a and b have the vertex of one shape in common: that comes first, and the
/// way is the other shape's.
template <class R, class S>
[[nodiscard]] Edge<DoubleWord<R>> careful_edge(const Query<S, 2>& query,
                                               const Prepared<R, 2>& prepared, VertexPair a,
                                               VertexPair b) {
  const auto in_unit = [&](const S& value) {
    return R(ScalarTraits<R>::from(value) * prepared.unit);
  };
  const bool x_moves = a.y == b.y;
  const auto coordinate = [&](int row) -> std::array<DoubleWord<R>, 2> {
    const auto add = [&](CarefulSum<R>& sum, bool of_x, VertexPair pair, R sign) {
      const Shape<S, 2>& shape = of_x ? query.x : query.y;
      const Vec<S, 2>& local = shape.vertices[of_x ? pair.x : pair.y];
      if (of_x) sign = -sign;
      if (!shape.pose.rotation.turns()) return sum.add(sign * in_unit(local[row]));
      for (int k = 0; k < 2; ++k) {
        sum.add_product(ScalarTraits<R>::from(shape.pose.rotation(row, k)),
                        sign * in_unit(local[k]));
      }
    };
    CarefulSum<R> from(in_unit(query.y.pose.translation[row]));
    from.add(-in_unit(query.x.pose.translation[row]));
    add(from, !x_moves, a, R(1));
    add(from, x_moves, a, R(1));
    CarefulSum<R> way(R(0));
    if (a.x != b.x && a.y != b.y) {
      add(way, !x_moves, b, R(1));
      add(way, !x_moves, a, R(-1));
    }
    add(way, x_moves, b, R(1));
    add(way, x_moves, a, R(-1));
    return {from.sum(), normalised(way.sum())};
  };
  const auto& [from_x, way_x] = coordinate(0);
  const auto& [from_y, way_y] = coordinate(1);
  return {{from_x, from_y}, {way_x, way_y}};
}
template <class R, class S>
[[nodiscard]] Flat<DoubleWord<R>> careful_vertex(const Query<S, 2>& query,
                                                 const Prepared<R, 2>& prepared, VertexPair pair) {
  const Flat<DoubleWord<R>> vertex = careful_edge(query, prepared, pair, pair).from;
  return {normalised(vertex.x), normalised(vertex.y)};
}

/// How often `careful_distance` rounds, and its bounds do, at worst: both coordinates of the edge,
/// the determinant, three times in the length, the quotient, and the bound.
inline constexpr int kCarefulRoundings = 6;

/// cross(a, b), rounded.
template <class R>
[[nodiscard]] R rounded_cross(const Flat<Expansion>& a, const Flat<Expansion>& b) {
  return rounded<R>(cross(a, b));
}
/// The same within some 10 u^2 |a| |b| before the last rounding.
template <class R>
[[nodiscard]] R rounded_cross(const Flat<DoubleWord<R>>& a, const Flat<DoubleWord<R>>& b) {
  const DoubleWord<R> left = exact_product(a.x.hi, b.y.hi);
  const DoubleWord<R> right = exact_product(a.y.hi, b.x.hi);
  const R left_rest = left.lo + R(R(a.x.hi * b.y.lo) + R(a.x.lo * b.y.hi));
  const R right_rest = right.lo + R(R(a.y.hi * b.x.lo) + R(a.y.lo * b.x.hi));
  const DoubleWord<R> difference = exact_sum(left.hi, R(-right.hi));
  return difference.hi + R(difference.lo + R(left_rest - right_rest));
}

/// Distance of O from a vertex of Z, or from the line through an edge, in the run's unit: nothing
/// rounds before the last few operations when N is exact, and little when it is a DoubleWord. The
/// latter is negative when O lies on that side of the edge to which perpendicular(way) points.
template <class R, class N>
[[nodiscard]] R careful_length(const Flat<N>& a) {
  return gjk::careful_length(Vec<R, 2>(rounded<R>(a.x), rounded<R>(a.y)));
}
template <class R, class N>
[[nodiscard]] R careful_distance(const Edge<N>& edge) {
  return R(rounded_cross<R>(edge.from, edge.way) / careful_length<R>(edge.way));
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
  const R rounding = R(2) * ScalarTraits<R>::unit_roundoff() * largest_coordinate(simplex);
  return !(rounding < norm_max(weighted_point(simplex, simplex.all())));
}

/// Weights of the vertices of a triangle around O: the areas across from them, as shares of all.
template <class R, class N>
[[nodiscard]] std::array<R, 3> shares_of_area(const std::array<Flat<N>, 3>& w) {
  std::array<R, 3> weights{};
  R sum(0);
  for (int i = 0; i < 3; ++i) {
    weights[i] = magnitude(rounded_cross<R>(w[(i + 1) % 3], w[(i + 2) % 3]));
    sum = sum + weights[i];
  }
  for (R& weight : weights) weight = weight / sum;
  return weights;
}

/// Weights of a simplex around O, with about twice the digits: in a thin one the run's own put P
/// visibly beside O.
template <class R, class S>
void set_careful_weights(Simplex<R, 2>& simplex, const Query<S, 2>& query,
                         const Prepared<R, 2>& prepared) {
  std::array<Flat<DoubleWord<R>>, 3> w;
  for (int i = 0; i < 3; ++i) {
    w[i] = careful_vertex(query, prepared, simplex.vertices[i].pair);
  }
  const std::array<R, 3> weights = shares_of_area<R>(w);
  std::copy(weights.begin(), weights.end(), simplex.weights.begin());
}

/// The place of from + beyond in the world, with about twice the digits before the last rounding:
/// for shapes that lie far from their own origin, where a rotation rounds by more than Z is large.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Vec<R, D> careful_place(const Pose<S, D>& pose, const Vec<R, D>& from,
                                                     const Vec<R, D>& beyond, int exponent) {
  const R unit = ScalarTraits<R>::scaled(R(1), -exponent);
  Vec<R, D> world;
  for (int row = 0; row < D; ++row) {
    CarefulSum<R> sum(ScalarTraits<R>::from(pose.translation[row]) * unit);
    for (int k = 0; k < D; ++k) {
      const R entry = ScalarTraits<R>::from(pose.rotation(row, k));
      sum.add_product(entry, R(from[k] * unit));
      sum.add_product(entry, R(beyond[k] * unit));
    }
    world[row] = ScalarTraits<R>::scaled(normalised(sum.sum()).hi, exponent);
  }
  return world;
}

/// True when all pairs of the simplex have the same vertex of a shape.
template <class R, int D>
[[nodiscard]] bool has_one_vertex_of(int VertexPair::*shape, const Simplex<R, D>& simplex) {
  return std::all_of(simplex.vertices.begin() + 1, simplex.vertices.begin() + simplex.count,
                     [&](const SupportPoint<R, D>& vertex) {
                       return vertex.pair.*shape == simplex.vertices[0].pair.*shape;
                     });
}

/// Makes one of the witness points of shapes that meet, which only rounding sets apart: halfway
/// between both, or the one that is a vertex.
template <class Point, class R, int D>
void join(Point& x, Point& y, const Simplex<R, D>& simplex) {
  if (has_one_vertex_of(&VertexPair::y, simplex)) {
    x = y;
  } else if (!has_one_vertex_of(&VertexPair::x, simplex)) {
    x = x + Point((y - x) * ScalarTraits<R>::from(0.5));
  }
  y = x;
}

/// Witness points, in the world, from the pairs and weights of a simplex. They are put together
/// from the vertex of the largest weight, so that little rounds but the last addition.
template <class R, class S, int D>
void set_witness_points(Result<R, D>& out, const Query<S, D>& query,
                        const Prepared<R, D>& prepared) {
  using W = RunScalar<Default, R>;
  const Simplex<R, D>& simplex = out.simplex;
  int base = 0;
  for (int i = 1; i < simplex.count; ++i) {
    if (simplex.weights[base] < simplex.weights[i]) base = i;
  }
  const auto set = [&](Vec<R, D>& point, const Shape<S, D>& shape, int VertexPair::*index) {
    const auto vertex = [&](int i) -> decltype(auto) {
      return converted<W, S, D>(shape.vertices[simplex.vertices[i].pair.*index]);
    };
    const auto& from = vertex(base);
    Vec<W, D> beyond = Vec<W, D>::Zero();
    for (int i = 0; i < simplex.count; ++i) {
      if (i == base) continue;
      const W weight = ScalarTraits<W>::from(simplex.weights[i]);
      beyond = beyond + Vec<W, D>((vertex(i) - from) * weight);
    }
    if constexpr (std::is_same_v<W, R> && !ScalarTraits<R>::kExact) {
      if (shape.pose.rotation.turns() && prepared.centred) {
        point = careful_place<R>(shape.pose, from, beyond, prepared.exponent);
        return;
      }
    }
    const Vec<W, D> local = from + beyond;
    Vec<W, D> world =
        shape.pose.template rotated<W>(local) + converted<W, S, D>(shape.pose.translation);
    for (int i = 0; i < D; ++i) point[i] = static_cast<R>(world[i]);
  };
  set(out.x, query.x, &VertexPair::x);
  set(out.y, query.y, &VertexPair::y);
  if constexpr (!ScalarTraits<R>::kExact) {
    if (out.verdict == Verdict::overlapping || out.verdict == Verdict::touching) {
      join(out.x, out.y, simplex);
    }
  }
}

/// What rounding can do to a determinant of D vertices with no coordinate larger than `size`: when
/// none is longer than r and each in doubt by e + u r, it errs by less than r^(D-1) (D e +
/// 8 D D! u r).
template <class R, int D>
[[nodiscard]] R volume_error(const R& size, const Prepared<R, D>& prepared) {
  const R r = ScalarTraits<R>::from(D == 2 ? 1.5 : 1.8) * size;
  R error =
      R(D) * prepared.vertex_error + R(D == 2 ? 32 : 144) * ScalarTraits<R>::unit_roundoff() * r;
  for (int i = 1; i < D; ++i) error = error * r;
  return error;
}

/// True when every weight of the full simplex around O is positive beyond doubt.
template <class R, int D>
[[nodiscard]] bool surely_inside(const Simplex<R, D>& simplex, const Prepared<R, D>& prepared) {
  const R error = volume_error(largest_coordinate(simplex), prepared);
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
template <class R, class Along>
[[nodiscard]] int count_as_far(int count, const Along& along, int i, int j, const R& error) {
  const R certainly_nearer = std::min(R(along(i)), R(along(j))) - error;
  int as_far = 0;
  for (int k = 0; k < count; ++k) as_far += along(k) < certainly_nearer ? 0 : 1;
  return as_far;
}
template <class R, class S, int D>
[[nodiscard]] int count_as_far(const Along<R, S, D>& along, int i, int j, const R& error) {
  return count_as_far<R>(static_cast<int>(along.vertices.size()), along, i, j, error);
}

/// The squared distance from O to the farthest of four vertices of Z: those that are made of the
/// points of X, and of Y, that lie far apart.
template <class R, class S>
[[nodiscard]] R corner_reach_sq(const Query<S, 2>& query, const Prepared<R, 2>& prepared) {
  const auto& [x0, x1] = query.x.vertices.far_apart();
  const auto& [y0, y1] = query.y.vertices.far_apart();
  const auto length_sq = [&](VertexPair pair) {
    const Vec<R, 2> w = support_point(query, prepared, pair).w;
    return dot(w, w);
  };
  return larger(larger(length_sq({x0, y0}), length_sq({x1, y1})),
                larger(length_sq({x0, y1}), length_sq({x1, y0})));
}

/// What bounds may have to ask of the shapes, when what the run found does not do.
template <class R, class S>
struct ShapesAsked {
  const Query<S, 2>& query;
  const Prepared<R, 2>& prepared;
  VertexPair a;
  VertexPair b;
  bool on_edge = false;

  [[nodiscard]] R corner_reach_sq() const { return detail::corner_reach_sq(query, prepared); }
  [[nodiscard]] R careful_distance() const {
    if (!on_edge) return careful_length<R>(careful_vertex(query, prepared, a));
    return detail::careful_distance<R>(careful_edge(query, prepared, a, b));
  }
  /// True when certainly no vertex of Z but those of the feature lies as far along d, which is in
  /// doubt by `angle`.
  [[nodiscard]] bool is_certainly_farthest(const Flat<R>& d, const R& length,
                                           const R& angle) const {
    const R error = length * prepared.scan_error_within(angle);
    const VertexPair last = on_edge ? b : a;
    const Vec<R, 2> direction(d.x, d.y);
    return count_as_far(along_x(query, prepared, direction), a.x, last.x, error) *
               count_as_far(along_y(query, prepared, direction), a.y, last.y, error) ==
           (on_edge ? 2 : 1);
  }
};

/// Where a run in the plane ended outside of Z: at vertex a, or between a and b.
template <class R>
struct Feature {
  Flat<R> a;
  Flat<R> b;
  bool on_edge;
  R least_weight;       ///< Of P, on an edge.
  R plane_distance_sq;  ///< See State.
  R plane_reach_sq;
};

/// So near to O that distances are computed anew, with about twice the digits.
template <class R>
[[nodiscard]] bool is_near(const R& distance, const Prepared<R, 2>& prepared) {
  return R(4096) * distance < prepared.reach;
}

/// How wide bounds may be when some vertex of Z lies as far from O as `reach`.
template <class R>
[[nodiscard]] R allowed_width(const R& reach) {
  return R(15.5) * ScalarTraits<R>::unit_roundoff() * reach;
}
/// When it is one of the four corners.
template <class R, class Shapes>
[[nodiscard]] R allowed_by_corners(const Shapes& shapes) {
  return allowed_width(R(ScalarTraits<R>::root(shapes.corner_reach_sq())));
}

/// Bounds from P, when it is a vertex of Z or lies between two, and from the best support plane.
///
/// Mostly the numbers of the run do. The nearer P is, the more of its distance is the rounding of
/// vertices: then the distance is computed anew, with about twice the digits. Nearer still, the
/// vertices that P lies between may be the wrong ones, unless all others are certainly farther. And
/// if P is about as far from O as Z reaches, five roundings of the distance from an edge and one of
/// the vertices may come to more than 4 u of that: it is computed anew there, too.
template <class R, class Shapes>
[[nodiscard]] Bounds<R> bounds_outside(const Feature<R>& feature, const Prepared<R, 2>& prepared,
                                       const Shapes& shapes) {
  const R u = ScalarTraits<R>::unit_roundoff();
  const bool on_edge = feature.on_edge;
  const Flat<R>& a = feature.a;
  const Flat<R> edge = feature.b - a;
  const auto& [length_a, length_b] = roots(dot(a, a), dot(feature.b, feature.b));
  const R edge_length = ScalarTraits<R>::root(dot(edge, edge));
  const R size = on_edge ? larger(length_a, length_b) : length_a;
  const R vertex_error = prepared.vertex_error + u * size;

  Bounds<R> out;
  R to_line = on_edge ? R(cross(a, edge) / edge_length) : size;
  R error = prepared.vertex_error + R(4) * u * magnitude(to_line);
  if (on_edge) error = error + u * (size + R(3) * smaller(length_a, length_b));
  out.lower = plane_bound(feature.plane_distance_sq, feature.plane_reach_sq, prepared);

  const bool near = is_near(magnitude(to_line), prepared);
  const R width = magnitude(to_line) + error - out.lower;
  R allowed = allowed_width(larger(prepared.least_reach, size));
  bool wide = false;
  if (!near && allowed < width) [[unlikely]] {
    allowed = larger(allowed, allowed_by_corners<R>(shapes));
    wide = allowed < width;
  }
  if (near || wide || (prepared.same_frame && R(16) * magnitude(to_line) < prepared.reach) ||
      (on_edge && prepared.reach < R(2) * magnitude(to_line))) [[unlikely]] {
    to_line = shapes.careful_distance();
    error = R(kCarefulRoundings) * u * magnitude(to_line) + prepared.careful_error();
  }
  out.distance = magnitude(to_line);
  out.upper = out.distance + error;
  const R d_length = on_edge ? edge_length : size;
  const R angle = R(2) * u + R(2) * vertex_error / d_length;
  if (on_edge) {
    // The foot of the perpendicular from O may lie beyond an end of the edge by this much.
    const R beyond = vertex_error + R(4) * u * size + angle * out.distance;
    if (edge_length * feature.least_weight < beyond) {
      out.upper = length(Flat<R>{out.upper, smaller(beyond, edge_length)});
    }
  }
  if (near || wide) {
    const R side = sign_of(to_line);
    const Flat<R> d = on_edge ? Flat<R>{-side * edge.y, side * edge.x} : -a;
    if (shapes.is_certainly_farthest(d, d_length, angle)) {
      out.lower = larger(R(out.distance - error), R(0));
    }
  }
  out.distance = larger(out.distance, out.lower);
  out.upper = larger(out.distance, out.upper);
  out.tight = out.upper - out.lower <= (near ? R(R(4) * error) : allowed);
  return out;
}

/// The certificate of a floating-point run.
template <class R, class S, int D>
[[nodiscard]] Bounds<R> bounds(const State<R, D>& state, const Query<S, D>& query,
                               const Prepared<R, D>& prepared) {
  const Simplex<R, D>& simplex = state.best;
  Bounds<R> out;
  out.tight = true;
  if (simplex.count == D + 1) {
    if (!surely_inside(simplex, prepared)) out.upper = prepared.simplex_error();
    return out;
  }
  if constexpr (D == 2) {
    const bool on_edge = simplex.count == 2;
    const Feature<R> feature{flat(simplex.vertices[0].w),
                             flat(simplex.vertices[1].w),
                             on_edge,
                             std::min(simplex.weights[0], simplex.weights[1]),
                             state.plane_distance_sq,
                             state.plane_reach_sq};
    const ShapesAsked<R, S> shapes{query, prepared, simplex.vertices[0].pair,
                                   simplex.vertices[1].pair, on_edge};
    out = bounds_outside(feature, prepared, shapes);
    if (!out.tight && !is_near(out.distance, prepared)) {
      out.tight = out.upper - out.lower <= allowed_by_corners<R>(shapes);
    }
    return out;
  } else {
    out.lower = plane_bound(state.plane_distance_sq, state.plane_reach_sq, prepared);
    out.distance = std::max(out.lower, ScalarTraits<R>::root(state.best_sq));
    out.upper = out.distance + prepared.simplex_error();
    return out;
  }
}

}  // namespace detail
}  // namespace gjk
