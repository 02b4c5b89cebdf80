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
  Error error = Error::none;

  /// The run's unit of length is 2^exponent. It is 1 unless squares of coordinates would come near
  /// overflow or underflow.
  int exponent = 0;
  R unit = R(1);  ///< 2^-exponent, for scalars that round.

  /// Both poses are the identity: differences of vertices round once.
  bool in_world = false;
  Vec<R, D> x_centre = Vec<R, D>::Zero();  ///< Points::centre, in the shape's own frame.
  Vec<R, D> y_centre = Vec<R, D>::Zero();
  /// From the centre of X to that of Y, in the world, in the run's unit.
  Vec<R, D> offset = Vec<R, D>::Zero();

  /// A vector in the run's unit.
  [[nodiscard]] Vec<R, D> in_unit(const Vec<R, D>& a) const {
    if constexpr (ScalarTraits<R>::kExact) {
      Vec<R, D> out;
      for (int i = 0; i < D; ++i) out[i] = ScalarTraits<R>::scaled(a[i], -exponent);
      return out;
    } else {
      return a * unit;
    }
  }

  /// No point of Z is farther from O, in the run's unit.
  R reach = R(0);
  /// Bounds of what rounding can do, from an analysis of every operation; tests/truth holds them
  /// against exact answers. 0 for exact scalars.
  R vertex_error = R(0);   ///< To a vertex w of Z, apart from u |w|.
  R scan_error = R(0);     ///< To the choice of a support point: how much farther along d / |d| the
                           ///< true one may lie.
  R careful_error = R(0);  ///< To a length computed with about twice the digits.
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
  if (options.start_rule != StartRule::given) return false;
  if (options.start_count < 1 || options.start_count > dimension + 1) return true;
  return std::any_of(options.start.begin(), options.start.begin() + options.start_count,
                     [&](const VertexPair& pair) {
                       return pair.x < 0 || pair.x >= x_count || pair.y < 0 || pair.y >= y_count;
                     });
}

/// y - x in the world, for two points in their shapes' frames, times `unit`. N: a type in which
/// little or nothing rounds.
template <class N, class R, class S, int D>
[[nodiscard]] std::array<N, D> careful_difference(const Query<S, D>& query, const Vec<R, D>& x,
                                                  const Vec<R, D>& y, const R& unit) {
  const auto exact = [&](const R& value) { return N{value}; };
  const auto from = [&](const S& value) { return N{ScalarTraits<R>::from(value)}; };
  std::array<N, D> out;
  for (int row = 0; row < D; ++row) {
    out[row] = exact(ScalarTraits<R>::from(query.y.pose.translation[row]) * unit) -
               exact(ScalarTraits<R>::from(query.x.pose.translation[row]) * unit);
    for (int k = 0; k < D; ++k) {
      out[row] = out[row] + (from(query.y.pose.rotation(row, k)) * exact(y[k] * unit) -
                             from(query.x.pose.rotation(row, k)) * exact(x[k] * unit));
    }
  }
  return out;
}

/// The size of a box around a box of size `size` that `pose` turns.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> turned_box(const Pose<S, D>& pose, const Vec<R, D>& size) {
  Vec<R, D> out = Vec<R, D>::Zero();
  for (int row = 0; row < D; ++row) {
    for (int column = 0; column < D; ++column) {
      const R entry = ScalarTraits<R>::from(pose.rotation(row, column));
      out[row] = out[row] + R(magnitude(entry) * size[column]);
    }
  }
  return out;
}

/// How much longer than a vector its image under `pose` can be: 1 for a rotation.
template <class R, class S, int D>
[[nodiscard]] R stretch(const Pose<S, D>& pose) {
  R most(1);
  if (!pose.is_turned()) return most;
  for (int i = 0; i < D; ++i) {
    R row(0);
    for (int k = 0; k < D; ++k) {
      row = row + magnitude(dot<R, D>(converted<R, S, D>(pose.rotation.col(i)),
                                      converted<R, S, D>(pose.rotation.col(k))));
    }
    most = std::max(most, ScalarTraits<R>::root(row));
  }
  return most;
}

/// Fills in what is measured in the run's unit of length. Gives twice the largest coordinate that a
/// point of Z can have.
template <class R, class S, int D>
R measure(const Query<S, D>& query, Prepared<R, D>& prepared) {
  const R unit = prepared.unit;
  const bool centred = !is_zero(prepared.x_centre) || !is_zero(prepared.y_centre);
  if (centred) {
    const auto offset =
        careful_difference<DoubleWord<R>>(query, prepared.x_centre, prepared.y_centre, unit);
    for (int i = 0; i < D; ++i) prepared.offset[i] = offset[i].hi;
  } else {
    prepared.offset = converted<R, S, D>(query.y.pose.translation) * unit -
                      converted<R, S, D>(query.x.pose.translation) * unit;
  }
  // Twice the middle and the half size of a box around Z: halving could underflow.
  Vec<R, D> middle = prepared.offset * R(2);
  Vec<R, D> half = Vec<R, D>::Zero();
  const auto add_box = [&](const Shape<S, D>& shape, const Vec<R, D>& centre, R sign) {
    const Vec<R, D> low = converted<R, S, D>(shape.vertices.low()) - centre;
    const Vec<R, D> high = converted<R, S, D>(shape.vertices.high()) - centre;
    middle = middle + shape.pose.template rotated<R>((low + high) * R(sign * unit));
    half = half + turned_box<R>(shape.pose, Vec<R, D>((high - low) * unit));
  };
  add_box(query.x, prepared.x_centre, R(-1));
  add_box(query.y, prepared.y_centre, R(1));
  const Vec<R, D> w = middle.cwiseAbs() + half;
  prepared.reach = length(w) / R(2);

  // How many roundings, times what they are relative to. In the world a vertex of Z is a single
  // difference; else both vertices are centred and turned, subtracted, and moved by the offset. A
  // scan compares two dot products of a direction that was turned with vertices that were centred.
  // Turning a vector of length r rounds by at most (1 + sqrt(D)) u r.
  const R u = ScalarTraits<R>::unit_roundoff();
  R vertex_error = length(prepared.offset);
  R scan_error(0);
  for (const Shape<S, D>* shape : {&query.x, &query.y}) {
    const R radius = ScalarTraits<R>::from(shape->vertices.radius()) * unit * stretch<R>(shape->pose);
    const R moved = R((is_zero(shape->vertices.centre()) ? 0.0 : 1.0) +
                      (shape->pose.is_turned() ? (D == 2 ? 2.5 : 2.8) : 0.0));
    vertex_error = vertex_error + radius * R(R(1) + moved);
    scan_error = scan_error + radius * R(R(2 * D) + R(2) * moved);
  }
  prepared.vertex_error = prepared.in_world ? R(0) : R(u * vertex_error);
  prepared.scan_error = u * scan_error;
  prepared.careful_error = R(64) * u * u * prepared.reach;
  if (centred) {
    const R far = length(query.x.pose.template rotated<R>(prepared.x_centre * unit)) +
                  length(query.y.pose.template rotated<R>(prepared.y_centre * unit));
    prepared.careful_error = prepared.careful_error + R(64) * u * u * far;
  }
  return gjk::is_finite(w) ? norm_max(w) : std::numeric_limits<R>::infinity();
}

/// Measures in a unit of length in which squares of coordinates neither overflow nor underflow.
template <class R, class S, int D>
[[nodiscard]] Error measure_in_good_unit(const Query<S, D>& query, Prepared<R, D>& prepared) {
  using Traits = ScalarTraits<R>;
  constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
  const auto in_range = [](const R& size) {
    return size == R(0) || (Traits::is_finite(size) &&
                            Traits::exponent(size) >= Traits::kLeastExponent &&
                            Traits::exponent(size) <= Traits::kLargestExponent);
  };
  R size = measure(query, prepared);
  if (in_range(size)) return Error::none;
  if (!Traits::is_finite(size)) {
    prepared.exponent = kLimit;
    prepared.unit = Traits::scaled(R(1), -kLimit);
    size = measure(query, prepared);
    if (!Traits::is_finite(size)) return Error::overflow;
  }
  prepared.exponent = std::clamp(prepared.exponent + Traits::exponent(size), -kLimit, kLimit);
  prepared.unit = Traits::scaled(R(1), -prepared.exponent);
  size = measure(query, prepared);
  if (!Traits::is_finite(size)) return Error::overflow;
  return in_range(size) ? Error::none : Error::underflow;
}

}  // namespace detail

/// Checks the query and measures it for a run in R.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> prepare(const Query<S, D>& query, const Options& options) {
  Prepared<R, D> prepared;
  const auto refuse = [&](Error error) {
    prepared.error = error;
    return prepared;
  };
  if (query.x.vertices.empty()) return refuse(Error::x_has_no_vertices);
  if (query.y.vertices.empty()) return refuse(Error::y_has_no_vertices);
  if (!query.x.vertices.is_finite() || !detail::is_finite(query.x.pose))
    return refuse(Error::x_not_finite);
  if (!query.y.vertices.is_finite() || !detail::is_finite(query.y.pose))
    return refuse(Error::y_not_finite);
  if (options.iteration_cap < 1 || !(options.tolerance >= 0.0 && options.tolerance < 1.0))
    return refuse(Error::bad_options);
  if (detail::bad_start(options, static_cast<int>(query.x.vertices.size()),
                        static_cast<int>(query.y.vertices.size()), D)) {
    return refuse(Error::bad_start);
  }
  prepared.in_world = query.x.pose.is_identity() && query.y.pose.is_identity();
  if constexpr (!ScalarTraits<R>::kExact) {
    prepared.x_centre = converted<R, S, D>(query.x.vertices.centre());
    prepared.y_centre = converted<R, S, D>(query.y.vertices.centre());
    prepared.error = detail::measure_in_good_unit(query, prepared);
  }
  return prepared;
}

}  // namespace gjk
