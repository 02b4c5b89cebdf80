#pragma once
// How large rounding errors can become. Each bound is derived from the model of one operation,
//
//   fl(a op b) = (a op b)(1 + e) with |e| <= u, for op in + - * / and the square root,
//
// to the first order in u (Higham 2002, "Accuracy and Stability of Numerical Algorithms", 2.2 and
// 3.1): a bound adds the worst of all roundings with one sign, which no run comes near, while terms
// of order u^2 are smaller by a factor of u. A product with a power of two does not round. Below,
// |.| of a vector is its length, and of a matrix that of its entries one by one.
//
//   dot(a, b)     D u |a||b|: a product rounds once, and at most D - 1 sums follow it.
//   length(a)     (D/2 + 1) u |a|: the root halves the D roundings of its square, and rounds.
//   R v           The D products of each row err by at most u |R||v|, as long as sqrt(D) u |v|, and
//                 each of D - 1 sums by u times a part of R v that is no longer than |v|:
//                 (D - 1 + sqrt(D)) u |v|. A matrix that stretches does so by `stretch`.
//   determinant   In the plane a0 b1 - a1 b0 rounds twice. In space each of the six products of
//                 three rounds twice in the cross product and three times in the dot product. Their
//                 magnitudes add up to at most D! / D^(D/2) r^D for vectors no longer than r
//                 (Carlen, Lieb, Loss 2006): 2 u r^2 and 5 * 1.155 u r^3 = 5.8 u r^3.
//
// tests/truth/shares.cpp reports how much of each bound is used at worst; see docs/numerics.md.

#include "gjk/proof/frames.hpp"

namespace gjk {

/// Roundings of a length that bounds a distance: its square D/2, the root 1, and two more: that of
/// the sum with its error bound, and that of a quotient or of the last sum of a vertex.
template <int D>
inline constexpr double kLengthRoundings = 3.0 + D / 2.0;

/// Lengths in the run's unit, and bounds of rounding errors made of them; 0 for exact scalars.
template <class R, int D>
struct Rounding {
  R extent = R(0);        ///< The sum of the radii; twice this is at least the diameter of Z.
  R reach = R(0);         ///< No point of Z is farther from O.
  R least_reach = R(0);   ///< Some point of Z is at least as far from O.
  R from_origins = R(0);  ///< `reach`, plus how far both centers are from their frames' origins.
  R moved = R(0);         ///< Sum over the shapes: roundings of moving a vertex, times the radius.
  bool scans_placed = false;  ///< Scans see the vertices of both shapes as Z has them.

  /// The error of a vertex w of Z, apart from the u |w| of its last sum: that of the offset, u
  /// radius where the vertex is centered, (D - 1 + sqrt(D)) u radius where it is turned, and u
  /// extent for y - x. In one frame 0: w is one difference.
  R vertex_error = R(0);

  /// The error of the choice of a support point along a direction in doubt by `angle` (in radians):
  /// how much farther along d / |d| the true one may lie. A scan compares two dot products, each of
  /// which errs by D u radius, and by `moved`, since the vertex was moved or the direction turned.
  /// Two vertices are at most two radii apart, which the angle multiplies.
  [[nodiscard]] R scan_error_within(const R& angle) const {
    const R u = ScalarTraits<R>::unit_roundoff();
    return u * (R(2 * D) * extent + R(2) * moved) + R(2) * angle * extent;
  }
  /// The error of the distance of a support plane, |dot(d, w)| / |d|, |w| = `reach_of_w`: the error
  /// of w with its last sum, u |w|, that of the dot product, D u |w|, that of the choice of w, and
  /// the roundings of a length. With `scans_placed` scans saw w as it is, so `moved` counts once.
  [[nodiscard]] R plane_error(const R& distance, const R& reach_of_w) const {
    const R u = ScalarTraits<R>::unit_roundoff();
    const R dots = u * (R(2 * D) * extent);
    const R of_support =
        scans_placed ? R(vertex_error + dots) : R(vertex_error + (dots + u * (R(2) * moved)));
    return of_support +
           u * (R(D + 1) * reach_of_w + ScalarTraits<R>::from(kLengthRoundings<D>) * distance);
  }
  /// The error of a vertex w of Z in DoubleWords, and of the arithmetic of foot_of on it. A product
  /// of words errs by 8 u^2, a sum by 3 u^2 of its parts. Turning a vertex costs (8 + 6 (D - 1))
  /// sqrt(D) u^2, at most 35, and y - x + offset 9: 44 for the vertex. In foot_of the normal costs
  /// 24 and its dot product with a vertex 20 more, of lengths that are no longer than
  /// `from_origins`. The sum is 88; 256 leaves room for the error's own rounding in half, and for
  /// sums of six of them.
  [[nodiscard]] R careful_error() const {
    const R u = ScalarTraits<R>::unit_roundoff();
    return R(256) * u * u * from_origins;
  }
  /// The error of |P| as take_region computes it, while no face is shorter or thinner than about a
  /// sixth of its distance: u reach for the vertices, kLengthRoundings for the length, and for the
  /// cross product 2 u |a||b| / |e|, or as much for a triangle. weights_bound holds for every face.
  [[nodiscard]] R simplex_error() const {
    return vertex_error + R(8 * D) * ScalarTraits<R>::unit_roundoff() * reach;
  }
};

namespace detail {

/// The lengths from which rounding is bounded.
template <class R, class S, int D>
[[nodiscard]] Rounding<R, D> rounding_of(const MeasuredQuery<S, D>& measured,
                                         const Frames<R, D>& frames) {
  constexpr double kTurnRoundings = D == 2 ? 2.5 : 3.75;  // D - 1 + sqrt(D), rounded up
  Rounding<R, D> out;
  R to_means(0);
  R to_centers(0);
  const auto add = [&](const Shape<S, D>& shape, const Measures<S, D>& measures,
                       const Body<R, D>& body) {
    const R stretch = ScalarTraits<R>::from(shape.pose.rotation.stretch());
    const R radius = body.radius * stretch;
    if (shape.pose.rotation.turns())
      out.moved = out.moved + ScalarTraits<R>::from(kTurnRoundings) * radius;
    if (frames.centered) {
      if (measures.is_centered) out.moved = out.moved + radius;
      to_centers =
          to_centers + careful_length(shape.pose.template rotated<R>(frames.in_unit(body.center)));
    }
    out.extent = out.extent + radius;
    to_means = to_means + ScalarTraits<R>::from(measures.to_mean) * frames.unit * stretch;
  };
  add(measured.query.x, measured.x, frames.x);
  add(measured.query.y, measured.y, frames.y);
  const R far = length(frames.offset);
  out.reach = far + out.extent;
  out.least_reach = far - to_means;
  out.from_origins = out.reach + to_centers;
  out.scans_placed = !frames.same_frame && frames.x.placed_count > 0 && frames.y.placed_count > 0;
  if (!frames.same_frame) {
    out.vertex_error =
        frames.offset_error + ScalarTraits<R>::unit_roundoff() * (out.extent + out.moved);
  }
  return out;
}

}  // namespace detail
}  // namespace gjk
