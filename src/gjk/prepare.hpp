#pragma once
// What the phases need to know of a query beyond its shapes: whether it can be answered, in which
// unit of length, and how large rounding errors can become.

#include <algorithm>

#include "gjk/error_free.hpp"
#include "gjk/simplex.hpp"

namespace gjk {

/// Made once by `prepare`. R: the scalar of the run, not of the query.
template <class R, int D>
struct Prepared {
  /// The run's unit of length is 2^exponent. It is 1 unless squares of coordinates would come near
  /// overflow or underflow.
  int exponent = 0;
  R unit = R(1);  ///< 2^-exponent, for scalars that round.

  Error error = Error::none;

  bool same_frame = false;  ///< One pose moves both, unturned: differences of vertices round once.
  /// Some centre (Points::centre) is not its shape's own origin.
  bool centred = false;
  Vec<R, D> x_centre = Vec<R, D>::Zero();  ///< In the shape's own frame.
  Vec<R, D> y_centre = Vec<R, D>::Zero();
  /// From the centre of X to that of Y, in the world, in the run's unit.
  Vec<R, D> offset = Vec<R, D>::Zero();
  R offset_error = R(0);

  /// A vector in the run's unit.
  [[nodiscard]] Vec<R, D> in_unit(const Vec<R, D>& a) const {
    Vec<R, D> out;
    for (int i = 0; i < D; ++i) {
      if constexpr (ScalarTraits<R>::kExact) {
        out[i] = ScalarTraits<R>::scaled(a[i], -exponent);
      } else {
        out[i] = a[i] * unit;
      }
    }
    return out;
  }

  /// In the run's unit: no two points of Z are farther apart than twice `extent`, none is farther
  /// from O than `reach`; some point is as far as `least_reach`, but for rounding.
  R extent = R(0);
  R reach = R(0);
  R least_reach = R(0);
  /// How often a vertex of X and one of Y round on their way into the world, times how large they
  /// are.
  R moved = R(0);
  R from_origins = R(0);  ///< `reach`, and how far the centres lie from the shapes' own origins.
  /// A scan turns vertices into the world, not directions into frames.
  bool turns_vertices = false;

  // Bounds of what rounding can do, from an analysis of every operation; tests/truth holds them
  // against exact answers. 0 for exact scalars.

  R vertex_error = R(0);  ///< To a vertex w of Z, apart from u |w|.
  /// To the choice of a support point along a direction that is in doubt by `angle`: how much
  /// farther along d / |d| the true one may lie. A scan compares two dot products of vertices that
  /// were centred; one or the other was turned.
  [[nodiscard]] R scan_error_within(const R& angle) const {
    const R u = ScalarTraits<R>::unit_roundoff();
    return u * (R(2 * D) * extent + R(2) * moved) + R(2) * angle * extent;
  }
  /// To the distance of a support plane, apart from that of its terms: by its support point, and by
  /// the choice of it. Where a scan turns vertices, it has seen that point where it is placed, and
  /// only the others may lie farther.
  [[nodiscard]] R plane_error() const {
    const R u = ScalarTraits<R>::unit_roundoff();
    const R dots = u * (R(2 * D) * extent);
    return turns_vertices ? R(vertex_error + dots) : R(vertex_error + (dots + u * (R(2) * moved)));
  }
  /// To a length computed with about twice the digits.
  [[nodiscard]] R careful_error() const {
    const R u = ScalarTraits<R>::unit_roundoff();
    return R(256) * u * u * from_origins;
  }
  /// To |P|: the vertices of a simplex, and what is computed of them.
  [[nodiscard]] R simplex_error() const {
    return vertex_error + R(8 * D) * ScalarTraits<R>::unit_roundoff() * reach;
  }
};

namespace detail {

template <class S, int D>
[[nodiscard]] bool is_finite(const Pose<S, D>& pose) {
  for (int i = 0; i < D; ++i) {
    if (!gjk::is_finite<S, D>(pose.rotation.col(i))) return false;
  }
  return gjk::is_finite(pose.translation);
}

[[nodiscard]] inline bool bad_start(const Options& options, int x_count, int y_count,
                                    int dimension) {
  if (options.start.count < 0 || options.start.count > dimension + 1) return true;
  return std::any_of(options.start.pairs.begin(), options.start.pairs.begin() + options.start.count,
                     [&](const VertexPair& pair) {
                       return pair.x < 0 || pair.x >= x_count || pair.y < 0 || pair.y >= y_count;
                     });
}

/// True of a trait of X or Y.
template <class S, int D>
[[nodiscard]] bool has_trait(const Query<S, D>& query, unsigned traits) {
  return ((query.x.vertices.traits() | query.y.vertices.traits()) & traits) != 0;
}

/// The unit and the frames of a run.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> frames(const Query<S, D>& query, int exponent) {
  Prepared<R, D> prepared;
  prepared.exponent = exponent;
  if (exponent != 0) prepared.unit = ScalarTraits<R>::scaled(R(1), -exponent);
  prepared.same_frame = !query.x.pose.rotation.turns() && !query.y.pose.rotation.turns() &&
                        query.x.pose.translation == query.y.pose.translation;
  if constexpr (!ScalarTraits<R>::kExact) {
    prepared.centred = has_trait(query, Points<S, D>::kCentred);
    if (prepared.centred) {
      prepared.x_centre = converted<R, S, D>(query.x.vertices.centre());
      prepared.y_centre = converted<R, S, D>(query.y.vertices.centre());
    }
  }
  return prepared;
}

/// From the centre of X to that of Y, with about twice the digits before the last rounding.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Vec<R, D> offset_of_centres(const Query<S, D>& query, int exponent) {
  const Prepared<R, D> prepared = frames<R>(query, exponent);
  const R& unit = prepared.unit;
  // In one frame nothing is moved by it: it says where to begin, and how far Z may reach.
  if (prepared.same_frame) return prepared.in_unit(prepared.y_centre - prepared.x_centre);
  Vec<R, D> out;
  const auto exact = [](const R& value) { return DoubleWord<R>{value}; };
  const auto from = [](const S& value) { return DoubleWord<R>{ScalarTraits<R>::from(value)}; };
  for (int row = 0; row < D; ++row) {
    DoubleWord<R> offset = exact(ScalarTraits<R>::from(query.y.pose.translation[row]) * unit) -
                           exact(ScalarTraits<R>::from(query.x.pose.translation[row]) * unit);
    for (int k = 0; k < D; ++k) {
      offset = offset + (from(query.y.pose.rotation(row, k)) * exact(prepared.y_centre[k] * unit) -
                         from(query.x.pose.rotation(row, k)) * exact(prepared.x_centre[k] * unit));
    }
    out[row] = offset.hi;
  }
  return out;
}
/// How far the centres lie from the shapes' own origins.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] R distance_of_centres(const Query<S, D>& query, int exponent) {
  const Prepared<R, D> prepared = frames<R>(query, exponent);
  const auto length_to = [&](const Pose<S, D>& pose, const Vec<R, D>& centre) {
    return careful_length(pose.template rotated<R>(prepared.in_unit(centre)));
  };
  return length_to(query.x.pose, prepared.x_centre) + length_to(query.y.pose, prepared.y_centre);
}

/// Where the shapes stand, in the run's unit of length, 2^exponent. What rounding can do is left to
/// `measure`.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> placed(const Query<S, D>& query, int exponent) {
  Prepared<R, D> prepared = frames<R>(query, exponent);
  if (prepared.centred) {
    prepared.offset = offset_of_centres<R>(query, exponent);
    prepared.offset_error = ScalarTraits<R>::unit_roundoff() * length(prepared.offset);
  } else {
    const Vec<R, D> x_place = converted<R, S, D>(query.x.pose.translation) * prepared.unit;
    const Vec<R, D> y_place = converted<R, S, D>(query.y.pose.translation) * prepared.unit;
    const DoubleWord<Vec<R, D>> offset = exact_sum<Vec<R, D>>(y_place, -x_place);
    prepared.offset = offset.hi;
    prepared.offset_error = norm_1(offset.lo);
  }
  return prepared;
}

/// Fills in what bounds of rounding are made of.
template <class R, class S, int D>
void measure(const Query<S, D>& query, Prepared<R, D>& prepared) {
  R extent(0);
  R moved(0);
  R to_means(0);
  const auto add = [&](const Shape<S, D>& shape) {
    const R stretch = ScalarTraits<R>::from(shape.pose.rotation.stretch());
    const R radius = ScalarTraits<R>::from(shape.vertices.radius()) * prepared.unit * stretch;
    // 1 + sqrt(D), of a product with a matrix
    if (shape.pose.rotation.turns()) moved = moved + R(D == 2 ? 2.5 : 2.8) * radius;
    if (prepared.centred && shape.vertices.is_centred()) moved = moved + radius;
    extent = extent + radius;
    to_means = to_means + ScalarTraits<R>::from(shape.vertices.to_mean()) * prepared.unit * stretch;
  };
  add(query.x);
  add(query.y);
  const R far = length(prepared.offset);
  prepared.extent = extent;
  prepared.moved = moved;
  prepared.reach = far + extent;
  prepared.least_reach = far - to_means;
  prepared.from_origins = prepared.reach;
  if (prepared.centred) {
    prepared.from_origins = prepared.reach + distance_of_centres<R>(query, prepared.exponent);
  }
  // In one frame a vertex of Z is a single difference of what was given, not of what scans saw;
  // else both vertices are centred and turned, subtracted, and moved by the offset.
  prepared.turns_vertices = !prepared.same_frame && !has_trait(query, Points<S, D>::kLarge);
  if (!prepared.same_frame) {
    prepared.vertex_error =
        prepared.offset_error + ScalarTraits<R>::unit_roundoff() * (extent + moved);
  }
}
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> measured(const Query<S, D>& query, int exponent) {
  Prepared<R, D> prepared = placed<R>(query, exponent);
  measure(query, prepared);
  return prepared;
}

/// e with all numbers that place a shape below 2^(e + 1).
template <class R, class S, int D>
[[nodiscard]] int coordinate_exponent(const Shape<S, D>& shape) {
  const S local = std::max(norm_max(shape.vertices.low()), norm_max(shape.vertices.high()));
  const S largest = std::max(local, norm_max(shape.pose.translation));
  return ScalarTraits<R>::exponent(ScalarTraits<R>::from(largest));
}

/// Measures again, in a unit of length in which squares of coordinates neither overflow nor
/// underflow.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Prepared<R, D> measured_in_good_unit(const Query<S, D>& query) {
  using Traits = ScalarTraits<R>;
  const auto refused = [](Error error) {
    Prepared<R, D> prepared;
    prepared.error = error;
    return prepared;
  };
  if (!is_finite(query.x.pose)) return refused(Error::x_not_finite);
  if (!is_finite(query.y.pose)) return refused(Error::y_not_finite);
  // Squares may have gone out of range: first a unit in which they do not.
  constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
  const auto in_unit = [&](int exponent) {
    return measured<R>(query, std::clamp(exponent, -kLimit, kLimit));
  };
  Prepared<R, D> prepared =
      in_unit(std::max(coordinate_exponent<R>(query.x), coordinate_exponent<R>(query.y)));
  if (prepared.reach == R(0)) return prepared;
  if (Traits::is_finite(prepared.reach)) {
    prepared = in_unit(prepared.exponent + Traits::exponent(prepared.reach));
  }
  if (!Traits::is_finite(prepared.reach)) return refused(Error::overflow);
  return Traits::is_in_range(prepared.reach) ? prepared : refused(Error::underflow);
}

/// The first thing wrong with what needs no measuring.
template <class S, int D>
[[nodiscard]] Error first_wrong(const Query<S, D>& query, const Options& options) {
  if (has_trait(query, Points<S, D>::kUnusable)) {
    if (query.x.vertices.empty()) return Error::x_has_no_vertices;
    if (query.y.vertices.empty()) return Error::y_has_no_vertices;
    return query.x.vertices.is_finite() ? Error::y_not_finite : Error::x_not_finite;
  }
  const bool bad_options =
      options.iteration_cap < 1 || !(options.tolerance >= 0.0 && options.tolerance < 1.0);
  const bool wrong = bad_options || bad_start(options, static_cast<int>(query.x.vertices.size()),
                                              static_cast<int>(query.y.vertices.size()), D);
  if (!wrong) return Error::none;
  if (!is_finite(query.x.pose)) return Error::x_not_finite;
  if (!is_finite(query.y.pose)) return Error::y_not_finite;
  return bad_options ? Error::bad_options : Error::bad_start;
}

}  // namespace detail

/// Checks the query and measures it for a run in R.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> prepare(const Query<S, D>& query, const Options& options) {
  Prepared<R, D> prepared;
  prepared.error = detail::first_wrong(query, options);
  if (prepared.error != Error::none) return prepared;
  if constexpr (ScalarTraits<R>::kExact) {
    prepared = detail::frames<R>(query, 0);
    prepared.offset =
        converted<R, S, D>(query.y.pose.translation) - converted<R, S, D>(query.x.pose.translation);
  } else {
    prepared = detail::measured<R>(query, 0);
    if (!ScalarTraits<R>::is_in_range(prepared.reach)) {
      return detail::measured_in_good_unit<R>(query);
    }
  }
  return prepared;
}

}  // namespace gjk
