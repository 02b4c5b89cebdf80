#pragma once
// Numbers of more digits. Error-free transformations, sums and products of floating-point numbers
// together with the rounding error, make double words and exact expansions of them. They need
// round-to-nearest, no contraction and no underflow.

#include <limits>
#include <vector>

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
  template <class To>
  [[nodiscard]] explicit operator To() const {
    return static_cast<To>(hi);
  }

  friend DoubleWord operator-(const DoubleWord& a) { return {-a.hi, -a.lo}; }
  friend DoubleWord operator-(const DoubleWord& a, const DoubleWord& b) { return a + (-b); }
  friend bool operator<(const DoubleWord& a, const DoubleWord& b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
  }
  friend bool operator==(const DoubleWord& a, const DoubleWord& b) = default;
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
[[nodiscard]] DoubleWord<R> operator+(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  const DoubleWord<R> sum = exact_sum(a.hi, b.hi);
  return normalised<R>({sum.hi, sum.lo + R(a.lo + b.lo)});
}
template <class R>
[[nodiscard]] DoubleWord<R> operator*(const DoubleWord<R>& a, const DoubleWord<R>& b) {
  const DoubleWord<R> product = exact_product(a.hi, b.hi);
  return normalised<R>({product.hi, product.lo + R(R(a.hi * b.lo) + R(a.lo * b.hi))});
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

/// R or long double, whichever has more digits.
template <class R>
using Wider =
    std::conditional_t<(std::numeric_limits<long double>::digits < std::numeric_limits<R>::digits),
                       R, long double>;

// g++ 12 at -O1 takes an Expansion that one of these functions returns for one that it knows, when
// it sees which memory the function writes (-fipa-modref), and decides a sign without looking.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC optimize("no-ipa-modref")
#endif

/// Exact arithmetic on doubles: a number is a sum of long doubles that do not overlap, smallest
/// first (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates"). It is far slower than double, and used only where rounding leaves an answer open.
/// Sums, differences, products and comparisons are exact while no product of two components leaves
/// the range of long double. Division rounds to long double: the core divides for weights and
/// squared distances, and decides at most by whether these are 0.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(long double value) { append(value); }

  /// The nearest number of R, or a neighbour of it.
  template <class R>
  [[nodiscard]] explicit operator R() const {
    Wider<R> sum(0);
    for (const long double component : components_) sum = sum + Wider<R>(component);
    return static_cast<R>(sum);
  }
  [[nodiscard]] Expansion scaled(int exponent) const {
    Expansion out = *this;
    for (long double& component : out.components_) component = std::ldexp(component, exponent);
    return out;
  }
  /// -1, 0 or 1: the largest component decides.
  [[nodiscard]] int sign() const {
    return components_.empty() ? 0 : components_.back() > 0.0 ? 1 : -1;
  }
  friend Expansion operator-(Expansion a) {
    for (long double& component : a.components_) component = -component;
    return a;
  }
  friend Expansion operator+(const Expansion& a, const Expansion& b) {
    Expansion out;
    out.components_.reserve(a.components_.size() + b.components_.size());
    auto next_a = a.components_.begin();
    auto next_b = b.components_.begin();
    long double sum = 0.0;
    while (next_a != a.components_.end() || next_b != b.components_.end()) {
      const bool from_a = next_b == b.components_.end() ||
                          (next_a != a.components_.end() && std::abs(*next_a) < std::abs(*next_b));
      const DoubleWord<long double> step = exact_sum(sum, from_a ? *next_a++ : *next_b++);
      out.append(step.lo);
      sum = step.hi;
    }
    out.append(sum);
    return out;
  }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion out;
    for (const long double factor : b.components_) out = out + a.times(factor);
    return out;
  }
  friend Expansion operator/(const Expansion& a, const Expansion& b) {
    return Expansion(static_cast<long double>(a) / static_cast<long double>(b));
  }
  friend bool operator<(const Expansion& a, const Expansion& b) { return (a - b).sign() < 0; }
  friend bool operator==(const Expansion& a, const Expansion& b) { return (a - b).sign() == 0; }

 private:
  void append(long double component) {
    if (component != 0.0) components_.push_back(component);
  }
  [[nodiscard]] Expansion times(long double factor) const {
    Expansion out;
    out.components_.reserve(2 * components_.size());
    long double carry = 0.0;
    for (const long double component : components_) {
      const DoubleWord<long double> product = exact_product(component, factor);
      const DoubleWord<long double> low = exact_sum(carry, product.lo);
      const DoubleWord<long double> high = exact_sum(product.hi, low.hi);
      out.append(low.lo);
      out.append(high.lo);
      carry = high.hi;
    }
    out.append(carry);
    return out;
  }

  std::vector<long double> components_;
};

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC pop_options
#endif

template <>
struct ScalarTraits<Expansion> {
  using Real = double;
  static constexpr bool kExact = true;
  [[nodiscard]] static Expansion from(const Expansion& value) { return value; }
  template <class From>
  [[nodiscard]] static Expansion from(const From& value) {
    return Expansion(static_cast<double>(value));
  }
  [[nodiscard]] static bool is_finite(const Expansion&) { return true; }
  [[nodiscard]] static Real root(const Expansion& a) { return std::sqrt(static_cast<double>(a)); }
  [[nodiscard]] static Real root_below(const Expansion& a) { return root(a) * (1.0 - 0x1p-50); }
  [[nodiscard]] static Real root_above(const Expansion& a) { return root(a) * (1.0 + 0x1p-50); }
  [[nodiscard]] static Expansion scaled(const Expansion& a, int exponent) {
    return exponent == 0 ? a : a.scaled(exponent);
  }
  [[nodiscard]] static Real no_length() { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace gjk
