#pragma once
// Exact rational numbers as a scalar of the core: no step of such a run rounds, and only the
// lengths of its result do.

#include <compare>
#include <string>

#include "exact/integer.hpp"
#include "gjk/proof/scalar.hpp"

namespace gjkscope {

/// numerator / denominator * 2^exponent, in lowest terms: both odd, or 0 / 1 * 2^0; the denominator
/// positive. Sums and products of doubles have the denominator 1, and nothing of them is divided.
class Rational {
 public:
  Rational() = default;
  Rational(int value) : Rational(Integer(value)) {}  // NOLINT: as every scalar
  /// The double exactly; it must be finite.
  explicit Rational(double value);
  explicit Rational(Integer numerator, Integer denominator = 1);

  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator-=(const Rational& b) { return *this = *this - b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  Rational& operator/=(const Rational& b) { return *this = *this / b; }

  friend Rational operator-(Rational a) {
    a.numerator_ = -a.numerator_;
    return a;
  }
  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(Rational a, Rational b);
  /// `b` is not 0.
  friend Rational operator/(const Rational& a, const Rational& b);
  friend bool operator==(const Rational& a, const Rational& b) = default;
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

  /// The nearest double; ties to even.
  explicit operator double() const { return to_double(*this); }
  /// -1, 0 or 1.
  [[nodiscard]] int sign() const { return numerator_.sign(); }
  [[nodiscard]] Rational times_power_of_two(int exponent) const;
  /// The fraction as two whole numbers.
  [[nodiscard]] std::pair<Integer, Integer> fraction() const;
  friend std::string to_string(const Rational& value);
  friend double to_double(const Rational& value);

 private:
  Rational(Integer numerator, Integer denominator, long exponent);
  void reduce();

  Integer numerator_ = 0;
  Integer denominator_ = 1;
  long exponent_ = 0;
};
[[nodiscard]] inline Rational abs(const Rational& a) { return a.sign() < 0 ? -a : a; }

/// "-3/4", "7".
[[nodiscard]] std::string to_string(const Rational& value);
/// The nearest double; ties to even.
[[nodiscard]] double to_double(const Rational& value);

/// Square root of a non-negative rational, rounded to nearest, down, up. The three are equal
/// exactly when the root is a double.
[[nodiscard]] double root_nearest(const Rational& value);
[[nodiscard]] double root_down(const Rational& value);
[[nodiscard]] double root_up(const Rational& value);

}  // namespace gjkscope

template <>
struct Eigen::NumTraits<gjkscope::Rational> : Eigen::GenericNumTraits<gjkscope::Rational> {
  using Real = gjkscope::Rational;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  // NOLINTBEGIN(readability-identifier-naming): the names are those that Eigen reads.
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 6,
    AddCost = 150,
    MulCost = 100
  };
  // NOLINTEND(readability-identifier-naming)
  static Real epsilon() { return 0; }
  static Real dummy_precision() { return 0; }
  static int digits10() { return 0; }
};

template <>
struct gjk::ScalarTraits<gjkscope::Rational> {
  using Rational = gjkscope::Rational;
  using Real = double;
  static constexpr bool kExact = true;
  template <class From>
  [[nodiscard]] static Rational from(const From& value) {
    if constexpr (std::is_same_v<From, Rational>) {
      return value;
    } else {
      return Rational(static_cast<double>(value));
    }
  }
  [[nodiscard]] static bool is_finite(const Rational&) { return true; }
  [[nodiscard]] static Real root(const Rational& a) { return gjkscope::root_nearest(a); }
  [[nodiscard]] static Real root_below(const Rational& a) { return gjkscope::root_down(a); }
  [[nodiscard]] static Real root_above(const Rational& a) { return gjkscope::root_up(a); }
  [[nodiscard]] static Rational scaled(const Rational& a, int exponent) {
    return a.times_power_of_two(exponent);
  }
  [[nodiscard]] static Real no_length() { return std::numeric_limits<double>::quiet_NaN(); }
};
