#pragma once
// The answer: how far X must move, and where the shapes touch then.

#include "depth/state.hpp"
#include "gjk/proof/result.hpp"

namespace depth {

/// The penetration depth is the length of the shortest translation t of X after which the shapes
/// just touch: X + t has no inner point in common with Y. With Z = Y - X that is the distance of O
/// from the boundary of Z, and t is the point of the boundary that is nearest to O.
///
/// lower <= exact depth <= upper, rounding included; with Proof::none both are `no_length()` (a
/// NaN). Moving X by upper * direction parts the shapes for certain. Shapes apart have no depth:
/// `verdict` says separated, and the lengths are no numbers.
template <class R, int D = 2>
struct Result {
  using Real = typename gjk::ScalarTraits<R>::Real;
  gjk::Error error = gjk::Error::none;
  StopReason stop = StopReason::running;
  gjk::Verdict verdict = gjk::Verdict::none;  ///< As that of GJK: touching means depth 0.
  bool settled = false;  ///< Rounding left too much open; exact arithmetic decided it.
  Real depth = gjk::ScalarTraits<R>::no_length();
  Real lower = gjk::ScalarTraits<R>::no_length();
  Real upper = gjk::ScalarTraits<R>::no_length();
  Vec<Real, D> direction = Vec<Real, D>::Zero();  ///< Direction of t; of length 1 even if t = 0.
  Vec<R, D> translation = Vec<R, D>::Zero();      ///< t = depth * direction; exact for exact R.
  Vec<R, D> x = Vec<R, D>::Zero();  ///< Contact point on X before the motion, world coordinates,
  Vec<R, D> y = Vec<R, D>::Zero();  ///< and on Y: x + t = y.
  int iterations = 0;               ///< Those that expand; GJK's come before.
  /// The edge of Z in the plane, the triangle of it in space, nearest to O (where the shapes touch
  /// also a face of fewer dimensions, which holds O), in the run's unit; its weights made the
  /// contact points.
  gjk::Simplex<R, D> face;
};

}  // namespace depth
