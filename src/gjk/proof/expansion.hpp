#pragma once
// Exact arithmetic on doubles: a number is a sum of long doubles that do not overlap, smallest
// first (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates"). It is far slower than double, and used only where rounding leaves an answer open.

#include <vector>

#include "gjk/proof/error_free.hpp"

namespace gjk {

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

/// Sums, differences, products and comparisons are exact while no product of two components leaves
/// the range of long double. Division rounds to long double: the core divides for weights and
/// squared distances, and decides at most by whether these are 0.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(long double value) {
    if (value != 0.0) components_.push_back(value);
  }

  /// The nearest number of R, or a neighbour of it.
  template <class R = double>
  [[nodiscard]] R estimate() const {
    Wider<R> sum(0);
    for (const long double component : components_) sum = sum + Wider<R>(component);
    return static_cast<R>(sum);
  }
  explicit operator double() const { return estimate(); }
  [[nodiscard]] Expansion scaled(int exponent) const {
    Expansion out = *this;
    for (long double& component : out.components_) component = std::ldexp(component, exponent);
    return out;
  }
  /// -1, 0 or 1: the largest component decides.
  [[nodiscard]] int sign() const {
    if (components_.empty()) return 0;
    return components_.back() > 0.0 ? 1 : -1;
  }

  friend Expansion operator-(const Expansion& a) {
    Expansion out = a;
    for (long double& component : out.components_) component = -component;
    return out;
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
    return Expansion(a.estimate<long double>() / b.estimate<long double>());
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
  template <class From>
  [[nodiscard]] static Expansion from(const From& value) {
    if constexpr (std::is_same_v<From, Expansion>) {
      return value;
    } else {
      return Expansion(static_cast<double>(value));
    }
  }
  [[nodiscard]] static bool is_finite(const Expansion&) { return true; }
  [[nodiscard]] static Real root(const Expansion& a) { return std::sqrt(a.estimate()); }
  [[nodiscard]] static Real root_below(const Expansion& a) { return root(a) * (1.0 - 0x1p-50); }
  [[nodiscard]] static Real root_above(const Expansion& a) { return root(a) * (1.0 + 0x1p-50); }
  [[nodiscard]] static Expansion scaled(const Expansion& a, int exponent) {
    return exponent == 0 ? a : a.scaled(exponent);
  }
  [[nodiscard]] static Real no_length() { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace gjk

template <>
struct Eigen::NumTraits<gjk::Expansion> : Eigen::GenericNumTraits<gjk::Expansion> {
  // NOLINTNEXTLINE(readability-identifier-naming): Eigen reads these names.
  enum { IsSigned = 1, ReadCost = 8, AddCost = 100, MulCost = 400 };
};
