#pragma once
// The exact truth about a pair of shapes: found quickly, then proved.
//
// Floating-point numbers are integers times a power of two, and so are vertices moved by poses.
// Where X and Y stand on such a common grid nothing divides and nothing rounds. A simplex guessed
// (say, by the core) is improved until a proof holds, so a wrong guess costs time only:
//
//   apart:   all of Z = Y - X lies beyond the plane through P, normal to P, where P is the nearest
//            point to O of the hull of some vertices of Z;
//   overlap: O lies in the hull of some vertices of Z.

#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

#include "gjk/query.hpp"

namespace truth {

struct IntegerPoint {
  mpz_class x;
  mpz_class y;
};

/// A point relative to ExactPair::origin. Good to 2^-63 of its length.
using NearPoint = std::array<long double, 2>;

struct Truth {
  bool overlap = false;  ///< The shapes share a point.
  mpz_class numerator;   ///< distance^2 = numerator / denominator * 4^ExactPair::exponent
  mpz_class denominator;
  long double distance = 0;  ///< Good to 2^-61 of itself.
};

/// Two shapes, moved by their poses, in exact coordinates.
class ExactPair {
 public:
  explicit ExactPair(const gjk::Query<double, 2>& query);

  /// `guess`: at most 3 pairs of vertices, from which the search starts; may be empty.
  [[nodiscard]] Truth truth(std::span<const gjk::VertexPair> guess) const;

  /// O lies on the boundary of Z: the shapes share a point, but no interior point of Z.
  [[nodiscard]] bool touching() const;

  /// The sign of bound - distance, for a bound that is not negative.
  [[nodiscard]] int compare(double bound, const Truth& truth) const;

  /// Largest distance between a vertex of X and one of Y.
  [[nodiscard]] long double scale() const;

  /// Distance of `point`, in world coordinates, from the hull of X or Y.
  [[nodiscard]] long double distance_from_x(const Eigen::Vector2d& point) const;
  [[nodiscard]] long double distance_from_y(const Eigen::Vector2d& point) const;

 private:
  [[nodiscard]] IntegerPoint difference(gjk::VertexPair pair) const;
  [[nodiscard]] gjk::VertexPair nearest_along(const IntegerPoint& normal) const;
  [[nodiscard]] NearPoint near(const IntegerPoint& point) const;
  [[nodiscard]] NearPoint near(const Eigen::Vector2d& point) const;

  int exponent_ = 0;  ///< A point stands at (x, y) * 2^exponent.
  std::vector<IntegerPoint> x_;
  std::vector<IntegerPoint> y_;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  ///< Close to the first vertex of X.
  std::vector<NearPoint> x_near_;
  std::vector<NearPoint> y_near_;
};

}  // namespace truth
