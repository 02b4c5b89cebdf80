#pragma once
// Exact rational numbers as a scalar of the core: no step of such a run rounds, and only the
// lengths of its result do.
//
// Products and sums of mpq_class are expression templates: never keep one in an `auto` variable.

#include <gmpxx.h>

#include "gjk/scalar.hpp"

namespace gjkscope {

using Rational = mpq_class;

/// The nearest double; ties to even. mpq_class::get_d truncates instead.
[[nodiscard]] double to_double(const Rational& value);

/// Square root of a non-negative rational, rounded to nearest, down, up. The three are equal
/// exactly when the root is a double.
[[nodiscard]] double root_nearest(const Rational& value);
[[nodiscard]] double root_down(const Rational& value);
[[nodiscard]] double root_up(const Rational& value);

}  // namespace gjkscope

template <>
struct Eigen::NumTraits<mpq_class> : Eigen::GenericNumTraits<mpq_class> {
  using Real = mpq_class;
  using NonInteger = mpq_class;
  using Nested = mpq_class;
  using Literal = mpq_class;
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
struct gjk::ScalarTraits<mpq_class> {
  using Real = double;
  static constexpr bool kExact = true;
  template <class From>
  [[nodiscard]] static mpq_class from(const From& value) {
    if constexpr (std::is_same_v<From, mpq_class>) {
      return value;
    } else {
      return mpq_class(static_cast<double>(value));
    }
  }
  [[nodiscard]] static bool is_finite(const mpq_class&) { return true; }
  [[nodiscard]] static Real root(const mpq_class& a) { return gjkscope::root_nearest(a); }
  [[nodiscard]] static Real root_below(const mpq_class& a) { return gjkscope::root_down(a); }
  [[nodiscard]] static Real root_above(const mpq_class& a) { return gjkscope::root_up(a); }
  [[nodiscard]] static mpq_class scaled(const mpq_class& a, int exponent) {
    mpq_class out = a;
    if (exponent > 0) mpq_mul_2exp(out.get_mpq_t(), a.get_mpq_t(), exponent);
    if (exponent < 0) mpq_div_2exp(out.get_mpq_t(), a.get_mpq_t(), -exponent);
    return out;
  }
  [[nodiscard]] static Real no_length() { return std::numeric_limits<double>::quiet_NaN(); }
};
