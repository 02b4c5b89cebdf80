#pragma once
// Error-free transformations: sums and products of floating-point numbers together with the
// rounding error. They need round-to-nearest, no contraction and no underflow.

#include <limits>

#include "gjk/proof/scalar.hpp"

namespace gjk {

/// The number hi + lo, of about twice the digits, where lo is small beside hi (Dekker 1971, "A
/// floating-point technique for extending the available precision").
template <class R>
struct DoubleWord {
  R hi = R(0);
  R lo = R(0);
  DoubleWord() = default;
  explicit DoubleWord(int value) : hi(static_cast<R>(value)) {}
  // NOLINTNEXTLINE(google-explicit-constructor): every R is a DoubleWord.
  DoubleWord(const R& value, const R& rest = R(0)) : hi(value), lo(rest) {}
};

/// a + b, exactly (Knuth 1969, "The Art of Computer Programming", vol. 2, section 4.2.2).
template <class R>
[[nodiscard]] DoubleWord<R> exact_sum(const R& a, const R& b) {
  const R sum = a + b;
  const R from_b = sum - a;
  const R from_a = sum - from_b;
  return {sum, R(a - from_a) + R(b - from_b)};
}

/// The number as a sum of two, each of about half its digits (Veltkamp 1968).
template <class R>
[[nodiscard]] DoubleWord<R> halves(const R& whole) {
  constexpr int kHalf = (std::numeric_limits<R>::digits + 1) / 2;
  const R splitter = R(static_cast<double>(1ull << kHalf)) + R(1);
  const R big = splitter * whole;
  const R hi = big - R(big - whole);
  return {hi, whole - hi};
}

/// a * b, exactly (Dekker 1971).
template <class R>
[[nodiscard]] DoubleWord<R> exact_product(const R& a, const R& b) {
  const DoubleWord<R> x = halves(a);
  const DoubleWord<R> y = halves(b);
  const R product = a * b;
  const R error = R(R(R(x.hi * y.hi) - product) + R(x.hi * y.lo) + R(x.lo * y.hi)) + R(x.lo * y.lo);
  return {product, error};
}

/// The same number, with hi rounded to nearest again; needs |lo| <= |hi|.
template <class R>
[[nodiscard]] DoubleWord<R> normalised(const DoubleWord<R>& a) {
  const R hi = a.hi + a.lo;
  return {hi, a.lo - R(hi - a.hi)};
}

template <class R>
[[nodiscard]] DoubleWord<R> operator-(const DoubleWord<R>& a) {
  return {-a.hi, -a.lo};
}
template <class R>
[[nodiscard]] DoubleWord<R> operator+(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  const DoubleWord<R> sum = exact_sum(a.hi, b.hi);
  return normalised<R>({sum.hi, sum.lo + R(a.lo + b.lo)});
}
template <class R>
[[nodiscard]] DoubleWord<R> operator-(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  return a + (-b);
}
template <class R>
[[nodiscard]] DoubleWord<R> operator*(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  const DoubleWord<R> product = exact_product(a.hi, b.hi);
  return normalised<R>({product.hi, product.lo + R(R(a.hi * b.lo) + R(a.lo * b.hi))});
}
template <class R>
[[nodiscard]] bool operator<(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}
template <class R>
[[nodiscard]] bool operator==(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  return a.hi == b.hi && a.lo == b.lo;
}

/// Only what rotating a vertex needs.
template <class R>
struct ScalarTraits<DoubleWord<R>> {
  using Real = R;
  static constexpr bool kExact = false;
  template <class From>
  [[nodiscard]] static DoubleWord<R> from(const From& value) {
    return ScalarTraits<R>::from(value);
  }
};

}  // namespace gjk

template <class R>
struct Eigen::NumTraits<gjk::DoubleWord<R>> : Eigen::GenericNumTraits<R> {};
