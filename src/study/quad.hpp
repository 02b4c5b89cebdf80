#pragma once
// IEEE quadruple precision, 113 bits, as a scalar of the core: the compilers' own type, in software
// on most machines. It is wrapped because the standard library knows it in GNU dialects only.

#include <cstdint>
#include <cstring>

#include "gjk/proof/scalar.hpp"

namespace gjkscope {

class Quad {
 public:
  __extension__ using Bits = __float128;

  Quad() = default;
  template <class From>
  requires std::is_arithmetic_v<From>
  explicit Quad(From value) : value_(value) {}

  template <class To>
  requires std::is_floating_point_v<To>
  explicit operator To() const { return static_cast<To>(value_); }

  friend Quad operator-(const Quad& a) { return of(-a.value_); }
  friend Quad operator+(const Quad& a, const Quad& b) { return of(a.value_ + b.value_); }
  friend Quad operator-(const Quad& a, const Quad& b) { return of(a.value_ - b.value_); }
  friend Quad operator*(const Quad& a, const Quad& b) { return of(a.value_ * b.value_); }
  friend Quad operator/(const Quad& a, const Quad& b) { return of(a.value_ / b.value_); }
  Quad& operator+=(const Quad& b) { return *this = *this + b; }
  Quad& operator-=(const Quad& b) { return *this = *this - b; }
  Quad& operator*=(const Quad& b) { return *this = *this * b; }
  Quad& operator/=(const Quad& b) { return *this = *this / b; }

  friend bool operator==(const Quad& a, const Quad& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Quad& a, const Quad& b) { return a.value_ != b.value_; }
  friend bool operator<(const Quad& a, const Quad& b) { return a.value_ < b.value_; }
  friend bool operator<=(const Quad& a, const Quad& b) { return a.value_ <= b.value_; }
  friend bool operator>(const Quad& a, const Quad& b) { return a.value_ > b.value_; }
  friend bool operator>=(const Quad& a, const Quad& b) { return a.value_ >= b.value_; }

  /// e with 2^e <= |a| < 2^(e+1), for numbers that are normal; 16384 for what is not finite.
  [[nodiscard]] int exponent() const {
    std::uint64_t words[2];
    std::memcpy(words, &value_, sizeof words);
    return static_cast<int>((words[1] >> 48) & 0x7fff) - kBias;
  }
  /// 2^exponent, for exponents of normal numbers.
  [[nodiscard]] static Quad power_of_two(int exponent) {
    const std::uint64_t words[2] = {0, static_cast<std::uint64_t>(exponent + kBias) << 48};
    Quad out;
    std::memcpy(&out.value_, words, sizeof words);
    return out;
  }

 private:
  static constexpr int kBias = 16383;
  static Quad of(Bits value) {
    Quad out;
    out.value_ = value;
    return out;
  }

  Bits value_ = 0;
};
static_assert(sizeof(Quad) == 16);

}  // namespace gjkscope

/// The traits that the core and Eigen ask for.
// NOLINTBEGIN(readability-identifier-naming): the names are the standard library's.
template <>
class std::numeric_limits<gjkscope::Quad> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr bool has_infinity = true;
  static constexpr bool has_quiet_NaN = true;
  static constexpr int digits = 113;
  static constexpr int digits10 = 33;
  static constexpr int max_digits10 = 36;
  static constexpr int min_exponent = -16381;
  static constexpr int max_exponent = 16384;
  static gjkscope::Quad min() { return gjkscope::Quad::power_of_two(min_exponent - 1); }
  static gjkscope::Quad max() {
    const gjkscope::Quad one(1);
    return (one - epsilon() / gjkscope::Quad(2)) * gjkscope::Quad::power_of_two(max_exponent - 1) *
           gjkscope::Quad(2);
  }
  static gjkscope::Quad lowest() { return -max(); }
  static gjkscope::Quad epsilon() { return gjkscope::Quad::power_of_two(1 - digits); }
  static gjkscope::Quad denorm_min() { return min() * epsilon(); }
  static gjkscope::Quad infinity() { return gjkscope::Quad(numeric_limits<double>::infinity()); }
  static gjkscope::Quad quiet_NaN() { return gjkscope::Quad(numeric_limits<double>::quiet_NaN()); }
};
// NOLINTEND(readability-identifier-naming)

template <>
struct Eigen::NumTraits<gjkscope::Quad> : Eigen::GenericNumTraits<gjkscope::Quad> {
  // NOLINTBEGIN(readability-identifier-naming): the names are those that Eigen reads.
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 20
  };
  // NOLINTEND(readability-identifier-naming)
};

template <>
struct gjk::ScalarTraits<gjkscope::Quad> {
  using Quad = gjkscope::Quad;
  using Real = Quad;
  static constexpr bool kExact = false;
  template <class From>
  [[nodiscard]] static Quad from(const From& value) {
    return static_cast<Quad>(value);
  }
  [[nodiscard]] static bool is_finite(const Quad& a) {
    return a.exponent() < std::numeric_limits<Quad>::max_exponent;
  }
  /// From the root in long double, 64 bits, by a step of Newton's that doubles them.
  [[nodiscard]] static Quad root(const Quad& a) {
    if (!(Quad(0) < a) || !is_finite(a)) return a;
    // In a unit of length in which long double neither over- nor underflows.
    const int half = a.exponent() / 2;
    const Quad small = scaled(a, -2 * half);
    const Quad near(std::sqrt(static_cast<long double>(small)));
    return scaled(near + (small - near * near) / (near + near), half);
  }
  [[nodiscard]] static Quad root_below(const Quad& a) {
    return root(a) * (Quad(1) - Quad(8) * unit_roundoff());
  }
  [[nodiscard]] static Quad root_above(const Quad& a) {
    return root(a) * (Quad(1) + Quad(8) * unit_roundoff());
  }
  [[nodiscard]] static Quad no_length() { return std::numeric_limits<Quad>::quiet_NaN(); }
  [[nodiscard]] static Quad unit_roundoff() { return Quad::power_of_two(-113); }
  [[nodiscard]] static int exponent(const Quad& a) { return a.exponent(); }
  [[nodiscard]] static Quad scaled(const Quad& a, int exponent) {
    return a * Quad::power_of_two(exponent);
  }
  /// The exponents that coordinates in double can have: products of such coordinates are far from
  /// over- and underflow in quad.
  static constexpr int kLeastExponent = -1080;
  static constexpr int kLargestExponent = 1030;
  template <int degree = 2>
  [[nodiscard]] static bool is_in_range(const Quad& size) {
    static_assert(degree == 2, "quad is asked about the plane");
    return Quad::power_of_two(kLeastExponent) <= size &&
           size <= Quad::power_of_two(kLargestExponent);
  }
};
