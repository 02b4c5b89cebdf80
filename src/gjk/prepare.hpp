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
  R unit = R(1);  ///< 2^-exponent

  /// Both poses are the identity: differences of vertices round once.
  bool in_world = false;
  Vec<R, D> x_centre = Vec<R, D>::Zero();  ///< Points::centre, in the shape's own frame.
  Vec<R, D> y_centre = Vec<R, D>::Zero();
  /// From the centre of X to that of Y, in the world, in the run's unit.
  Vec<R, D> offset = Vec<R, D>::Zero();

  /// No point of Z is farther from O, in the run's unit.
  R reach = R(0);
  /// Bounds of what rounding can do to a vertex of Z, and to the distance of a support plane, the
  /// wrong choices of scans included. From one analysis of every operation; tests/geometry checks
  /// them against exact answers. 0 for exact scalars.
  R vertex_error = R(0);
  R plane_error = R(0);
  R careful_error = R(0);  ///< Of a length computed with about twice the digits.
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

/// A box around the box of half size `half` when `pose` turns it.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> turned_box(const Pose<S, D>& pose, const Vec<R, D>& half) {
  Vec<R, D> out = Vec<R, D>::Zero();
  for (int row = 0; row < D; ++row) {
    for (int column = 0; column < D; ++column) {
      const R entry = ScalarTraits<R>::from(pose.rotation(row, column));
      out[row] = out[row] + R(magnitude(entry) * half[column]);
    }
  }
  return out;
}

/// Fills in what is measured in the run's unit of length. Gives the largest coordinate that a point
/// of Z can have.
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
  const auto box = [&](const Shape<S, D>& shape, const Vec<S, D>& half) {
    return turned_box<R>(shape.pose, Vec<R, D>(converted<R, S, D>(half) * unit));
  };
  const auto middle = [&](const Shape<S, D>& shape) {
    const Vec<S, D> local = shape.vertices.middle() - shape.vertices.centre();
    return shape.pose.template rotated<R>(converted<R, S, D>(local) * unit);
  };
  const Points<S, D>& x = query.x.vertices;
  const Points<S, D>& y = query.y.vertices;
  const Vec<R, D> w = (prepared.offset + (middle(query.y) - middle(query.x))).cwiseAbs() +
                      box(query.x, x.half_size()) + box(query.y, y.half_size());
  prepared.reach = length(w);

  // Each term: how many roundings, times what they are relative to. In the world a vertex of Z is a
  // single difference; else both vertices are centred and turned (1 + D roundings each),
  // subtracted, and moved by the offset.
  const Vec<R, D> extents = box(query.x, x.extent()) + box(query.y, y.extent());
  const R u = ScalarTraits<R>::unit_roundoff();
  const R moved = R(centred ? 1 : 0);
  const Vec<R, D> vertex_error =
      prepared.in_world
          ? w
          : Vec<R, D>(extents * R(R(D + 1) + moved) + prepared.offset.cwiseAbs() + w);
  // A plane: the error of its support point, that of dot(d, w), and twice that of each dot product
  // that the scans compare, in which d is turned and the vertex is centred.
  const R scan = R(2) * (moved + R(prepared.in_world ? D : 2 * D));
  const Vec<R, D> plane_error = vertex_error + w * R(D) + extents * scan;
  prepared.vertex_error = u * length(vertex_error);
  prepared.plane_error = u * length(plane_error);
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
