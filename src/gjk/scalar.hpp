#pragma once
// What the core asks of a scalar type, beyond + - * / and comparison.
//
// The loop compares squared lengths only, so it runs unchanged on types without a square root.
// Lengths appear once, in the result, as ScalarTraits<S>::Real.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace gjk {

namespace detail {
/// 2^exponent, where a double can hold it.
[[nodiscard]] constexpr double power_of_two(int exponent) {
  double power = 1.0;
  for (; exponent > 0; --exponent) power *= 2.0;
  for (; exponent < 0; ++exponent) power /= 2.0;
  return power;
}
}  // namespace detail

/// Floating-point scalars: Eigen::half, float, double, long double. Other types specialise this
/// template.
template <class S>
struct ScalarTraits {
  /// The type of a length.
  using Real = S;

  /// True when + - * and comparison never round.
  static constexpr bool kExact = false;

  template <class From>
  [[nodiscard]] static S from(const From& value) {
    return static_cast<S>(value);
  }

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
  [[nodiscard]] static S unit_roundoff() { return S(kRoundoff); }

  /// e with 2^e <= a < 2^(e+1), for positive a.
  [[nodiscard]] static int exponent(const S& a) { return std::ilogb(a); }
  /// a * 2^exponent: exact unless it leaves the scalar's range.
  [[nodiscard]] static S scaled(const S& a, int exponent) {
    return static_cast<S>(std::ldexp(a, exponent));
  }

  /// Is this a size of Z at which products of `degree` lengths keep all digits that could matter?
  /// Those of numbers as small as u^kSmallest times the size lose none, and sums of some stay
  /// finite.
  template <int degree = 2>
  [[nodiscard]] static bool is_in_range(const S& size) {
    return S(kLeast<degree>) <= size && size <= S(kLargest<degree>);
  }
  static constexpr int kSmallest = std::numeric_limits<S>::max_exponent < 1024 ? 1 : 3;
  /// Such sizes are 2^least_exponent to 2^largest_exponent. (long double has room for more; the
  /// powers are made as doubles.)
  [[nodiscard]] static constexpr int least_exponent(int degree = 2) {
    const int kept = (2 * kSmallest + 1) * std::numeric_limits<S>::digits;
    return std::clamp((std::numeric_limits<S>::min_exponent + kept) / degree, -1000, -1);
  }
  [[nodiscard]] static constexpr int largest_exponent(int degree = 2) {
    return std::min((std::numeric_limits<S>::max_exponent - 6) / degree, 1000);
  }

 private:
  static constexpr double kRoundoff = detail::power_of_two(-std::numeric_limits<S>::digits);
  template <int degree>
  static constexpr double kLeast = detail::power_of_two(least_exponent(degree));
  template <int degree>
  static constexpr double kLargest = detail::power_of_two(largest_exponent(degree));
};

/// Stands for the scalar in which `distance` and `trace` run unless told otherwise: that of the
/// query, but double for float and half, because scalar code in double costs no more.
struct Default {};
template <class R, class S>
using RunScalar = std::conditional_t<
    !std::is_same_v<R, Default>, R,
    std::conditional_t<std::is_same_v<S, float> || std::is_same_v<S, Eigen::half>, double, S>>;

}  // namespace gjk
