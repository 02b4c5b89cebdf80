#pragma once
// Exact answers about two convex hulls in the plane, found without GJK: by trying all features, in
// rationals. Slow (points^3), and made to be trusted: tests compare runs with it.

#include <span>
#include <vector>

#include "geometry/rational.hpp"
#include "gjk/linear.hpp"

namespace gjkscope {

using RationalPoint = gjk::Vec<Rational, 2>;

/// Every finite double is a rational.
[[nodiscard]] RationalPoint rational(double x, double y);

/// How the convex hulls X and Y of two point sets stand to each other.
struct ExactAnswer {
  Rational distance_sq;
  bool overlap = false;   ///< They share a point.
  bool touching = false;  ///< They share a point, but no interior point of Y - X: moving one by any
                          ///< little in some direction parts them.
  RationalPoint x;        ///< A pair of nearest points; of their hulls. Only when they do not
  RationalPoint y;        ///< overlap.
};

/// Both sets have at least one point.
[[nodiscard]] ExactAnswer exact_answer(std::span<const RationalPoint> x,
                                       std::span<const RationalPoint> y);

/// True when no pair of points of the hulls of `x` and `y` is nearer than the points `at_x` and
/// `at_y`, by duality: with n = at_y - at_x, all of Y lies beyond at_y along n, and all of X before
/// at_x. (That they lie in the hulls is for the caller to know.)
[[nodiscard]] bool is_nearest_pair(std::span<const RationalPoint> x,
                                   std::span<const RationalPoint> y, const RationalPoint& at_x,
                                   const RationalPoint& at_y);

}  // namespace gjkscope
