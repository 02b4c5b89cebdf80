#pragma once
// Exact signs of polynomials in doubles. A polynomial is written once, as a template over its
// scalar. It is evaluated in long double with a bound of the error, and anew in expansions where
// that bound leaves the sign open (Shewchuk 1997, "Adaptive precision floating-point arithmetic and
// fast robust geometric predicates").

#include "gjk/proof/error_free.hpp"
#include "gjk/vector.hpp"

namespace gjkscope {

/// A number that rounds, and a bound of how far it is from the true one. What rounding loses is
/// computed, so that whole numbers of up to 64 bits have the bound 0.
struct Bounded {
  long double value = 0;
  long double error = 0;
  Bounded() = default;
  explicit Bounded(long double exact, long double bound = 0) : value(exact), error(bound) {}

  friend Bounded operator-(const Bounded& a) { return Bounded(-a.value, a.error); }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const auto sum = gjk::exact_sum(a.value, b.value);
    return Bounded(sum.hi, a.error + b.error + std::abs(sum.lo));
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const auto product = gjk::exact_product(a.value, b.value);
    return Bounded(product.hi, std::abs(a.value) * b.error + std::abs(b.value) * a.error +
                                   a.error * b.error + std::abs(product.lo));
  }
};

/// The sign of `polynomial(N())`, for N either Bounded or Expansion. Exact while no product of two
/// terms leaves the range of long double.
template <class Polynomial>
[[nodiscard]] int sign_of(const Polynomial& polynomial) {
  const Bounded rounded = polynomial(Bounded());
  const long double least = 2 * rounded.error;  // the bound itself rounds, too
  if (least < std::abs(rounded.value)) return rounded.value > 0 ? 1 : -1;
  if (least == 0) return 0;
  return polynomial(gjk::Expansion()).sign();
}

/// The value of `polynomial(N())`, but for some roundings of long double.
template <class Polynomial>
[[nodiscard]] long double value_of(const Polynomial& polynomial) {
  const Bounded rounded = polynomial(Bounded());
  if (rounded.error <= 0x1p-58L * std::abs(rounded.value)) return rounded.value;
  return static_cast<long double>(polynomial(gjk::Expansion()));
}

/// The way from one point to another, in the scalar N.
template <class N>
[[nodiscard]] gjk::Vec<N, 3> difference(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return {N(to[0]) - N(from[0]), N(to[1]) - N(from[1]), N(to[2]) - N(from[2])};
}

}  // namespace gjkscope
