#pragma once
// Operations of a scalar type that the core needs beyond + - * / and comparison.
//
// The loop compares squared lengths only, so it runs on types without a square root, too. Lengths
// appear once, in the result, as ScalarTraits<S>::Real.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace gjk {

namespace detail {
/// 2^exponent, which a double must be able to hold.
[[nodiscard]] constexpr double power_of_two(int exponent) {
  double power = 1.0;
  for (; exponent > 0; --exponent) power *= 2.0;
  for (; exponent < 0; ++exponent) power /= 2.0;
  return power;
}
}  // namespace detail

/// Floating-point scalars: Eigen::half, float, double, long double. Other types specialise this
/// template, and those that are exact convert to double by static_cast.
template <class S>
struct ScalarTraits {
  using Real = S;                        ///< The type of a length.
  static constexpr bool kExact = false;  ///< + - * and comparison never round.

  template <class From>
  [[nodiscard]] static S from(const From& value) {
    return static_cast<S>(value);
  }

  [[nodiscard]] static bool is_finite(const S& a) { return (Eigen::numext::isfinite)(a); }

  /// Square root of a number that is not negative. root_below and root_above bound the exact root:
  /// IEEE roots round once, and the product once; 8 leaves room for roots that err by some units.
  [[nodiscard]] static Real root(const S& a) { return Eigen::numext::sqrt(a); }
  [[nodiscard]] static Real root_below(const S& a) {
    return root(a) * (S(1) - S(8) * unit_roundoff());
  }
  [[nodiscard]] static Real root_above(const S& a) {
    return root(a) * (S(1) + S(8) * unit_roundoff());
  }

  /// The length that a failed run answers.
  [[nodiscard]] static Real no_length() { return std::numeric_limits<S>::quiet_NaN(); }

  /// u, the largest relative error of one rounded operation. Made from the digits because Eigen 3.4
  /// gives half a wrong epsilon (2^-13, not 2^-10).
  [[nodiscard]] static S unit_roundoff() {
    constexpr double kRoundoff = detail::power_of_two(-std::numeric_limits<S>::digits);
    return S(kRoundoff);
  }

  /// e with 2^e <= a < 2^(e+1), for positive a.
  [[nodiscard]] static int exponent(const S& a) { return std::ilogb(a); }
  /// a * 2^exponent: exact unless it leaves the scalar's range.
  [[nodiscard]] static S scaled(const S& a, int exponent) {
    return static_cast<S>(std::ldexp(a, exponent));
  }

  /// True when products of `degree` lengths keep all digits that could matter for a Z of this size:
  /// sums of them stay finite, and lengths down to u^kSmallest times the size lose no digits.
  template <int degree = 2>
  [[nodiscard]] static bool is_in_range(const S& size) {
    constexpr double kLeast = detail::power_of_two(least_exponent(degree));
    constexpr double kLargest = detail::power_of_two(largest_exponent(degree));
    return S(kLeast) <= size && size <= S(kLargest);
  }
  static constexpr int kSmallest = std::numeric_limits<S>::max_exponent < 1024 ? 1 : 3;
  /// These sizes are 2^least_exponent to 2^largest_exponent, limited to what a double can hold.
  [[nodiscard]] static constexpr int least_exponent(int degree = 2) {
    const int kept = (2 * kSmallest + 1) * std::numeric_limits<S>::digits;
    return std::clamp((std::numeric_limits<S>::min_exponent + kept) / degree, -1000, -1);
  }
  [[nodiscard]] static constexpr int largest_exponent(int degree = 2) {
    return std::min((std::numeric_limits<S>::max_exponent - 6) / degree, 1000);
  }
};

/// Stands for the scalar in which `distance` and `trace` run by default: the query's, but double
/// for float and half, because it costs no more.
struct Default {};
template <class R, class S>
using RunScalar = std::conditional_t<
    !std::is_same_v<R, Default>, R,
    std::conditional_t<std::is_same_v<S, float> || std::is_same_v<S, Eigen::half>, double, S>>;

}  // namespace gjk
