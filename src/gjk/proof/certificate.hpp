#pragma once
// Proved bounds of the distance, rounding included: P bounds it from above, the best support plane
// from below (Larsen 1998, "Proof of Local Verification"). tests/truth checks these bounds.

#include "gjk/proof/careful.hpp"
#include "gjk/proof/result.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// Bounds are promised to be no farther apart than this, in u times the distance from O to the
/// farthest vertex of Z. A run whose bounds are wider has been misled by rounding.
inline constexpr double kPromisedWidth = 16.0;
/// A 32nd less is demanded, since the width itself and that distance are rounded.
inline constexpr double kAllowedWidth = kPromisedWidth * 31.0 / 32.0;

/// A bound of the error of a determinant of D vertices of Z with no coordinate larger than `size`.
/// They are no longer than r = sqrt(D) size and err by e = vertex_error + u r each, which the other
/// vertices multiply: D e r^(D-1). The determinant rounds by 2 u r^2, or 5.8 u r^3 in space (see
/// rounding.hpp). Together r^(D-1) (D vertex_error + c u r), c = 4 in the plane, 8.8 in space.
template <class R, int D>
[[nodiscard]] R volume_error(const R& size, const Prepared<R, D>& prepared) {
  const R r = ScalarTraits<R>::from(D == 2 ? 1.42 : 1.74) * size;
  R error = R(D) * prepared.vertex_error + R(D == 2 ? 4 : 9) * ScalarTraits<R>::unit_roundoff() * r;
  for (int i = 1; i < D; ++i) error = error * r;
  return error;
}

/// True when O certainly lies inside the full simplex: every weight is above its error.
template <class R, int D>
[[nodiscard]] bool surely_inside(const Simplex<R, D>& simplex, const Prepared<R, D>& prepared) {
  const R error = volume_error(largest_coordinate(simplex), prepared);
  const std::array<R, D + 1> volumes = volume_coordinates(simplex).numerator;
  return std::all_of(volumes.begin(), volumes.end(), [&](const R& v) { return error < v; });
}

/// An upper bound of the distance from weights that are not negative, however they came about: that
/// of the point of Z whose weights are these, divided by their sum. The sum P of weighted vertices
/// errs by D + 1 roundings of the farthest vertex, that vertex by its own error and 1, the sum of
/// the weights by D, and the quotient and the bound by 2 and kLengthRoundings.
template <class R, int D>
[[nodiscard]] R weights_bound(const Simplex<R, D>& simplex, const Rounding<R, D>& rounding) {
  R sum(0);
  R farthest_sq(0);
  for (int i = 0; i < simplex.count; ++i) {
    sum = sum + simplex.weights[i];
    farthest_sq = larger(farthest_sq, dot(simplex.vertices[i].w, simplex.vertices[i].w));
  }
  const R u = ScalarTraits<R>::unit_roundoff();
  const R p = length(weighted_point(simplex, simplex.all(), simplex.weights)) / sum;
  return p + rounding.vertex_error + R(4 * D + 4) * u * ScalarTraits<R>::root(farthest_sq);
}

/// The vertices of one shape in the pairs of a simplex, each once.
struct Corners {
  std::array<int, kMaxDimension + 1> index = {};
  int count = 0;

  template <class R, int D>
  Corners(const Simplex<R, D>& simplex, int VertexPair::*shape) {
    for (int i = 0; i < simplex.count; ++i) {
      const int found = simplex.vertices[i].pair.*shape;
      const auto end = index.begin() + count;
      if (std::find(index.begin(), end, found) == end) index[count++] = found;
    }
  }
};

/// True when every other vertex of the shape certainly lies less far along d than each of
/// `corners`. `error` bounds the rounding of a difference of two dot products with d.
template <class R, class S, int D>
[[nodiscard]] bool are_alone(const Vec<R, D>& d, const Shape<S, D>& shape,
                             const Prepared<R, D>& prepared, const Body<R, D>& body,
                             const Corners& corners, const R& error) {
  const Along<R, S, D> along(d, shape, prepared, body);
  R nearest = along(corners.index[0]);
  for (int k = 1; k < corners.count; ++k) nearest = smaller(nearest, along(corners.index[k]));
  int as_far = 0;
  for (int i = 0; i < along.count(); ++i) as_far += along(i) < nearest - error ? 0 : 1;
  return as_far == corners.count;
}

// Limits below which lengths are measured anew. They bound nothing: they choose between a quick
// bound and a close one, and either holds.

/// A distance below reach / kNear has lost 12 digits of 53 to the rounding of vertices: it is
/// computed anew with about twice the digits, and its face is checked (is_certainly_farthest).
inline constexpr int kNear = 4096;
/// A distance below reach / kQuiteNear has lost 4. It is computed anew, too, if that helps: when
/// both shapes are in one frame, because vertices round once, and in space, because turned vertices
/// round more often.
inline constexpr int kQuiteNear = 16;
/// A distance to an edge or triangle above reach / kFarFromEdge has more roundings of its own
/// (kLengthRoundings and kEdgeRoundings) than of vertices: it is computed anew, too.
inline constexpr int kFarFromEdge = 2;
/// In space rounding may end a run on a face beside the nearest one. When the distance is below
/// reach / kCloseInSpace, bounds must be half as wide, or the face is checked.
inline constexpr int kCloseInSpace = 4;
/// In a triangle kThin times as long as high the run's own weights place P visibly wrong.
inline constexpr int kThin = 4;

/// Roundings of the distance to an edge or triangle, in u times the distance a of its nearest
/// vertex, times longest / height, beside kLengthRoundings.
///   edge in the plane     |dot(n, a)| / |n|, n = B - A: n rounds once, the dot product twice: 3.
///   edge in space         |cross(n, a)| / |n|: n 1, two products and a difference 2, both times
///                         1.155 as products of magnitudes; the longer length and quotient 3: 6.5.
///   triangle in space     n = cross of two edges: (2 + 2) times 1.155; the dot product 3: 7.7.
template <int D>
inline constexpr int kEdgeRoundings = D == 2 ? 3 : 8;
/// Roundings of a weight times the height over its side, in u times the distance of the farthest
/// vertex, times longest / height: of the edge 1, of its dot product D; in a triangle of the normal
/// 4.7, of a cross product 3.5, of their dot product 3.
template <int D>
inline constexpr int kWeightRoundings = D == 2 ? 4 : 12;

/// Proves bounds for a run whose last simplex does not hold O inside: P lies on a face.
///
/// Usually the numbers of the run suffice. When P is near O, the rounding of vertices dominates the
/// distance, so it is computed anew with about twice the digits. When P is very near, the face may
/// be the wrong one, unless all other vertices are certainly farther.
template <class R, class S, int D>
class OutsideBounds {
 public:
  /// `face`: the run's last simplex. `prove` replaces its weights where they are too inexact.
  OutsideBounds(const State<R, D>& state, const Query<S, D>& query, const Prepared<R, D>& prepared,
                Simplex<R, D>& face)
      : query_(query), prepared_(prepared), face_(face) {
    lower_ = plane_bound<R, D>(state.evidence, prepared_);
    R most_sq(0);
    R least_sq(0);
    for (int i = 0; i < face_.count; ++i) {
      const R to_vertex_sq = dot(face_.vertices[i].w, face_.vertices[i].w);
      most_sq = larger(most_sq, to_vertex_sq);
      if (i > 0 && !(to_vertex_sq < least_sq)) continue;
      nearest_ = i;
      least_sq = to_vertex_sq;
    }
    size_ = ScalarTraits<R>::root(most_sq);
    to_nearest_ = ScalarTraits<R>::root(least_sq);
  }

  /// `ended`: the run stopped neither by its cap nor within its tolerance, so that wide bounds mean
  /// that rounding misled it.
  [[nodiscard]] Bounds<R> prove(bool ended) {
    measure();
    near_ = R(kNear) * foot.distance < prepared_.reach;
    const bool is_wide = !(upper_ < no_bound()) || (ended && !is_allowed());
    if (near_ || is_wide || is_too_rounded()) measure_anew();
    if ((near_ || is_wide) && is_certainly_farthest()) {
      lower_ = larger(R(foot.distance - error), lower_);
    }
    const R distance = larger(foot.distance, lower_);
    return {lower_, distance, larger(distance, upper_)};
  }

  /// True when the bounds are as close as rounding permits; false when rounding misled the run.
  [[nodiscard]] bool is_tight() const {
    return is_allowed() && (!near_ || upper_ - lower_ <= R(4) * error);
  }

  /// Computes distance, error and upper bound in the run's own digits.
  void measure() {
    foot = foot_of<R>(face_, nearest_);
    error = prepared_.vertex_error + length_rounding(foot.distance);
    if (face_.count > 1) {
      const R of_vertices = vertex_error();
      const R flatness = foot.longest / foot.height;
      error = error + u_ * (size_ + R(kEdgeRoundings<D>) * to_nearest_ * flatness);
      const R angle = R(2) * u_ + R(2) * of_vertices / foot.height;
      beyond = of_vertices + R(kWeightRoundings<D>) * u_ * size_ * flatness + angle * foot.distance;
      for (int i = 0; i < face_.count; ++i) {
        is_inside = is_inside && beyond < foot.height * face_.weights[i];
      }
    }
    upper_ = is_inside ? R(foot.distance + error) : no_bound();
  }

  /// As `measure`, with about twice the digits; replaces weights that may be too inexact.
  [[gnu::noinline]] void measure_anew() {
    const Simplex<DoubleWord<R>, D> face = careful_simplex(face_, query_, prepared_);
    foot = foot_of<R>(face);
    if (!(R(0) < foot.height)) {  // a degenerate face: its nearest vertex takes its place
      foot.distance = to_nearest_;
      error = vertex_error() + length_rounding(to_nearest_) + least();
      upper_ = to_nearest_ + error;
      return;
    }
    const R few = R(kCarefulRoundings) * u_;
    R to_p = foot.distance;
    if (!is_inside || R(kThin) * foot.height < foot.longest) {
      face_.weights = weights_of<R>(face);
      if (!is_inside) to_p = larger(to_p, distance_of_p(face));
    }
    R moved = careful_error();
    if (face.count > 1) {
      const R beside_sq = (to_p - foot.distance) * (to_p + foot.distance);
      moved = moved * (foot.longest + ScalarTraits<R>::root(beside_sq)) / foot.height;
    }
    error = few * foot.distance + moved;
    upper_ = to_p * (R(1) + few) + moved;
  }

  // Results of `measure` and `measure_anew`.
  Foot<R, D> foot;        ///< The foot of the perpendicular from O to the face's line or plane.
  R error = R(0);         ///< Bound of the error of foot.distance.
  R beyond = R(0);        ///< Bound of the error of a weight times the height.
  bool is_inside = true;  ///< The foot certainly lies on the face.

 private:
  /// The distance of O from the point that the weights make of `face`.
  [[nodiscard]] R distance_of_p(const Simplex<DoubleWord<R>, D>& face) const {
    const Vec<DoubleWord<R>, D>& a = face.vertices[0].w;
    Vec<DoubleWord<R>, D> p = a;
    for (int i = 1; i < face.count; ++i) {
      const DoubleWord<R> weight = face_.weights[i] * (R(1) - R(4) * u_);  // their sum is below 1
      p = p + Vec<DoubleWord<R>, D>((face.vertices[i].w - a) * weight);
    }
    return careful_length(converted<R, DoubleWord<R>, D>(p));
  }

  /// The rounding of denormal lengths: only half needs it, since every unit leaves it some of them.
  [[nodiscard]] static R least() {
    constexpr bool kIsNarrow = std::numeric_limits<R>::max_exponent < 100;
    return kIsNarrow ? R(4) * std::numeric_limits<R>::denorm_min() : R(0);
  }
  [[nodiscard]] R length_rounding(const R& length) const {
    return ScalarTraits<R>::from(kLengthRoundings<D>) * u_ * length;
  }
  /// The error of vertices: in the run's own digits, and computed anew.
  [[nodiscard]] R vertex_error() const { return prepared_.vertex_error + u_ * size_; }
  [[nodiscard]] R careful_error() const { return prepared_.careful_error() + least(); }
  [[nodiscard]] static R no_bound() { return std::numeric_limits<R>::infinity(); }
  /// The distance from O to the farthest of the four vertices of Z that `far_apart` points make.
  [[nodiscard, gnu::noinline]] R corner_reach() const {
    R most(0);
    for (const int x : prepared_.x.far_apart) {
      for (const int y : prepared_.y.far_apart) {
        most = larger(most, length(support_point<R, S, D>(query_, prepared_, {x, y}).w));
      }
    }
    return most;
  }
  [[nodiscard]] bool is_allowed() const {
    const bool is_close = D == 3 && R(kCloseInSpace) * foot.distance < prepared_.reach;
    const R allowed = ScalarTraits<R>::from(is_close ? kAllowedWidth / 2 : kAllowedWidth) * u_;
    const R width = upper_ - lower_;
    return width <= allowed * larger(prepared_.least_reach, size_) ||
           (upper_ < no_bound() && width <= allowed * corner_reach());
  }
  [[nodiscard]] bool is_too_rounded() const {
    const bool gains = prepared_.same_frame || D == 3;
    return (gains && R(kQuiteNear) * foot.distance < prepared_.reach) ||
           (face_.count > 1 && prepared_.reach < R(kFarFromEdge) * foot.distance);
  }
  /// True when certainly no vertex of Z outside the face lies as far along the direction to O. The
  /// face's own vertices lie equally far, because pairs that share one join all of them.
  [[nodiscard]] bool is_certainly_farthest() const {
    const Corners of_x(face_, &VertexPair::x);
    const Corners of_y(face_, &VertexPair::y);
    if (of_x.count + of_y.count != face_.count + 1 || !(R(0) < foot.height)) return false;
    const bool is_space_edge = D == 3 && face_.count == 2;  // d is the product of two products
    const R arm = is_space_edge ? smaller(foot.height, foot.distance) : foot.height;
    // In one frame d is a sum of vertices, and sums in twice the digits are exact.
    const bool is_sum = prepared_.same_frame && (D == 2 || face_.count == 1);
    const R angle = R(4) * u_ + (is_sum ? R(0) : R(R(4) * careful_error() / arm));
    const R scan_error = length(foot.d) * prepared_.scan_error_within(angle);
    return are_alone(Vec<R, D>(-foot.d), query_.x, prepared_, prepared_.x, of_x, scan_error) &&
           are_alone(foot.d, query_.y, prepared_, prepared_.y, of_y, scan_error);
  }

  const Query<S, D>& query_;
  const Prepared<R, D>& prepared_;
  Simplex<R, D>& face_;
  R u_ = ScalarTraits<R>::unit_roundoff();
  R size_ = R(0);        ///< The distance from O to the farthest vertex of the face.
  int nearest_ = 0;      ///< The vertex of the face that is nearest to O.
  R to_nearest_ = R(0);  ///< The distance from O to that vertex.
  R lower_ = R(0);
  R upper_ = R(0);
  bool near_ = false;
};

}  // namespace gjk
