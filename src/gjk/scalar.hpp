#pragma once
// What the core asks of a scalar type, beyond + - * / and comparison.
//
// The loop compares squared lengths only, so it runs unchanged on types without a square root.
// Lengths appear once, in the result, as ScalarTraits<S>::Real.

#include <Eigen/Core>
#include <cmath>
#include <limits>

namespace gjk {

/// Floating-point scalars: Eigen::half, float, double, long double. Other types specialise this
/// template.
template <class S>
struct ScalarTraits {
  /// The type of a length.
  using Real = S;

  [[nodiscard]] static bool is_finite(const S& a) { return (Eigen::numext::isfinite)(a); }

  /// Square root of a non-negative number; `below` and `above` bound the exact root from each side.
  [[nodiscard]] static Real root(const S& a) { return Eigen::numext::sqrt(a); }
  [[nodiscard]] static Real root_below(const S& a) {
    return root(a) * (S(1) - S(8) * unit_roundoff());
  }
  [[nodiscard]] static Real root_above(const S& a) {
    return root(a) * (S(1) + S(8) * unit_roundoff());
  }

  /// What a run that failed answers where a length would stand.
  [[nodiscard]] static Real no_length() { return std::numeric_limits<S>::quiet_NaN(); }

  /// u: the largest relative error of one rounded operation. Zero for exact types. Made from the
  /// digits because Eigen 3.4 gives half a wrong epsilon (2^-13 for 2^-10).
  [[nodiscard]] static S unit_roundoff() {
    return S(std::ldexp(1.0, -std::numeric_limits<S>::digits));
  }

  /// Half of it is the largest error that a product can pick up by underflow. Zero for exact types.
  [[nodiscard]] static S smallest() { return std::numeric_limits<S>::denorm_min(); }

  /// True when the square of u * scale is below every positive number: squared lengths near the
  /// rounding error of the coordinates would be lost.
  [[nodiscard]] static bool loses_products(const S& scale) {
    const S rounding = scale * unit_roundoff();
    return rounding * rounding < smallest();
  }
};

}  // namespace gjk
