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

  bool x_turned = false;  ///< The pose of X has a rotation.
  bool y_turned = false;
  bool same_frame = false;  ///< One pose moves both, unturned: differences of vertices round once.
  /// Some centre (Points::centre) is not its shape's own origin.
  bool centred = false;
  Vec<R, D> x_centre = Vec<R, D>::Zero();  ///< In the shape's own frame.
  Vec<R, D> y_centre = Vec<R, D>::Zero();
  /// From the centre of X to that of Y, in the world, in the run's unit.
  Vec<R, D> offset = Vec<R, D>::Zero();

  /// A vector in the run's unit.
  [[nodiscard]] Vec<R, D> in_unit(const Vec<R, D>& a) const {
    if (exponent == 0) return a;
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
  /// from O than `reach`.
  R extent = R(0);
  R reach = R(0);
  /// Bounds of what rounding can do, from an analysis of every operation; tests/truth holds them
  /// against exact answers. 0 for exact scalars.
  R vertex_error = R(0);   ///< To a vertex w of Z, apart from u |w|.
  R scan_error = R(0);     ///< To the choice of a support point: how much farther along d / |d| the
                           ///< true one may lie.
  R careful_error = R(0);  ///< To a length computed with about twice the digits.
  /// As `scan_error`, along a direction that is in doubt by `angle`, too.
  [[nodiscard]] R scan_error_within(const R& angle) const {
    return scan_error + R(2) * angle * extent;
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
  if (options.start_count < 0 || options.start_count > dimension + 1) return true;
  return std::any_of(options.start.begin(), options.start.begin() + options.start_count,
                     [&](const VertexPair& pair) {
                       return pair.x < 0 || pair.x >= x_count || pair.y < 0 || pair.y >= y_count;
                     });
}

/// How much longer than a vector its image under `pose` can be: 1 for a rotation.
template <class R, class S, int D>
[[nodiscard]] R stretch(const Pose<S, D>& pose) {
  const auto column = [&](int i) -> Vec<R, D> {
    return converted<R, S, D>(Vec<S, D>(pose.rotation.col(i)));
  };
  R longest_sq(1);
  R skewed(0);
  for (int i = 0; i < D; ++i) {
    longest_sq = larger(longest_sq, dot(column(i), column(i)));  // a NaN comes through `skewed`
    for (int k = 0; k < i; ++k) skewed = skewed + magnitude(dot(column(i), column(k)));
  }
  return (R(1) + longest_sq + skewed) / R(2);  // at least the root, for numbers from 1 on
}

/// From the centre of X to that of Y, with about twice the digits before the last rounding.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> offset_of_centres(const Query<S, D>& query,
                                          const Prepared<R, D>& prepared) {
  Vec<R, D> out;
  const auto exact = [](const R& value) { return DoubleWord<R>{value}; };
  const auto from = [](const S& value) { return DoubleWord<R>{ScalarTraits<R>::from(value)}; };
  const R& unit = prepared.unit;
  // In one frame nothing is moved by it: it says where to begin, and how far Z may reach.
  if (prepared.same_frame) return prepared.in_unit(prepared.y_centre - prepared.x_centre);
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
/// The offset, where centres are not the shapes' own origins. Returns how far from those they lie.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] R measure_centres(const Query<S, D>& query, Prepared<R, D>& prepared) {
  prepared.offset = offset_of_centres(query, prepared);
  const auto length_to = [&](const Pose<S, D>& pose, bool turned, const Vec<R, D>& centre) {
    const Vec<R, D> in_unit = prepared.in_unit(centre);
    return careful_length(turned ? pose.template rotated<R>(in_unit) : in_unit);
  };
  return length_to(query.x.pose, prepared.x_turned, prepared.x_centre) +
         length_to(query.y.pose, prepared.y_turned, prepared.y_centre);
}

/// Fills in what is measured in the run's unit of length.
template <class R, class S, int D>
void measure(const Query<S, D>& query, Prepared<R, D>& prepared) {
  const R u = ScalarTraits<R>::unit_roundoff();
  bool is_exact = false;
  R from_centres(0);
  if (prepared.centred) {
    from_centres = measure_centres(query, prepared);
  } else {
    const Vec<R, D> x_place = converted<R, S, D>(query.x.pose.translation) * prepared.unit;
    const Vec<R, D> y_place = converted<R, S, D>(query.y.pose.translation) * prepared.unit;
    const DoubleWord<Vec<R, D>> offset = exact_sum<Vec<R, D>>(y_place, -x_place);
    prepared.offset = offset.hi;
    is_exact = is_zero(offset.lo);
  }

  R extent(0);
  R moved(0);  // how often a vertex rounds on its way, times how large it is
  const auto add = [&](const Shape<S, D>& shape, bool turned) {
    R radius = ScalarTraits<R>::from(shape.vertices.radius()) * prepared.unit;
    if (turned) {
      radius = radius * stretch<R>(shape.pose);
      moved = moved + R(D == 2 ? 2.5 : 2.8) * radius;  // 1 + sqrt(D), of a product with a matrix
    }
    if (shape.vertices.is_centred()) moved = moved + radius;
    extent = extent + radius;
  };
  add(query.x, prepared.x_turned);
  add(query.y, prepared.y_turned);
  // In the world a vertex of Z is a single difference; else both vertices are centred and turned,
  // subtracted, and moved by the offset. A scan compares two dot products of a direction with
  // vertices that were centred; one or the other was turned.
  const R far = length(prepared.offset);
  const R vertex_roundings = (is_exact ? R(0) : far) + extent + moved;
  prepared.extent = extent;
  prepared.reach = far + extent;
  prepared.vertex_error = prepared.same_frame ? R(0) : R(u * vertex_roundings);
  prepared.scan_error = u * (R(2 * D) * extent + R(2) * moved);
  prepared.careful_error = R(256) * u * u * (prepared.reach + from_centres);
}

/// e with all coordinates of a shape, in its frame and in the world, below 2^(e + D).
template <class R, class S, int D>
[[nodiscard]] int coordinate_exponent(const Shape<S, D>& shape) {
  using Traits = ScalarTraits<R>;
  const auto exponent = [](const S& size) {
    return S(0) < size ? Traits::exponent(Traits::from(size))
                       : std::numeric_limits<R>::min_exponent;
  };
  const S local = std::max(norm_max(shape.vertices.low()), norm_max(shape.vertices.high()));
  S turn(1);
  for (int i = 0; i < D; ++i)
    turn = std::max(turn, norm_max(Vec<S, D>(shape.pose.rotation.col(i))));
  return std::max(exponent(local) + exponent(turn), exponent(norm_max(shape.pose.translation)));
}

/// Measures again, in a unit of length in which squares of coordinates neither overflow nor
/// underflow.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Error measure_in_good_unit(const Query<S, D>& query,
                                                        Prepared<R, D>& prepared) {
  using Traits = ScalarTraits<R>;
  if (!is_finite(query.x.pose)) return Error::x_not_finite;
  if (!is_finite(query.y.pose)) return Error::y_not_finite;
  // Squares in `measure` may have gone out of range: first a unit in which they do not.
  constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
  const auto take_unit = [&](int exponent) {
    prepared.exponent = std::clamp(exponent, -kLimit, kLimit);
    prepared.unit = Traits::scaled(R(1), -prepared.exponent);
    measure(query, prepared);
  };
  take_unit(std::max(coordinate_exponent<R>(query.x), coordinate_exponent<R>(query.y)));
  if (prepared.reach == R(0)) return Error::none;
  if (Traits::is_finite(prepared.reach)) {
    take_unit(prepared.exponent + Traits::exponent(prepared.reach));
  }
  if (!Traits::is_finite(prepared.reach)) return Error::overflow;
  return Traits::is_in_range(prepared.reach) ? Error::none : Error::underflow;
}

/// Returns the first thing found wrong.
template <class R, class S, int D>
[[nodiscard]] Error check_and_measure(const Query<S, D>& query, const Options& options,
                                      Prepared<R, D>& prepared) {
  if (query.x.vertices.empty()) return Error::x_has_no_vertices;
  if (query.y.vertices.empty()) return Error::y_has_no_vertices;
  if (!query.x.vertices.is_finite()) return Error::x_not_finite;
  if (!query.y.vertices.is_finite()) return Error::y_not_finite;
  prepared.x_turned = query.x.pose.is_turned();
  prepared.y_turned = query.y.pose.is_turned();
  prepared.same_frame = !prepared.x_turned && !prepared.y_turned &&
                        query.x.pose.translation == query.y.pose.translation;
  if constexpr (ScalarTraits<R>::kExact) {
    prepared.offset =
        converted<R, S, D>(query.y.pose.translation) - converted<R, S, D>(query.x.pose.translation);
  } else {
    prepared.centred = query.x.vertices.is_centred() || query.y.vertices.is_centred();
    if (prepared.centred) {
      prepared.x_centre = converted<R, S, D>(query.x.vertices.centre());
      prepared.y_centre = converted<R, S, D>(query.y.vertices.centre());
    }
    measure(query, prepared);
    if (!ScalarTraits<R>::is_in_range(prepared.reach)) {
      const Error error = measure_in_good_unit(query, prepared);
      if (error != Error::none) return error;
    }
  }
  if (options.iteration_cap < 1 || !(options.tolerance >= 0.0 && options.tolerance < 1.0))
    return Error::bad_options;
  if (bad_start(options, static_cast<int>(query.x.vertices.size()),
                static_cast<int>(query.y.vertices.size()), D)) {
    return Error::bad_start;
  }
  return Error::none;
}

}  // namespace detail

/// Checks the query and measures it for a run in R.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> prepare(const Query<S, D>& query, const Options& options) {
  Prepared<R, D> prepared;
  prepared.error = detail::check_and_measure(query, options, prepared);
  return prepared;
}

}  // namespace gjk
