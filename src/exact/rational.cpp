#include "exact/rational.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace gjkscope {
namespace {

constexpr int kDoubleDigits = std::numeric_limits<double>::digits;

enum class Rounding { nearest, down, up };

/// mantissa * 2^exponent, or a little more where `is_exact` is false, as a double. The mantissa is
/// not negative; when not exact it has at least two digits more than a double.
double rounded(const Integer& mantissa, long exponent, bool is_exact, Rounding rounding) {
  // Digits below the smallest denormal do not fit, so that there a double has fewer than 53.
  const long smallest = std::numeric_limits<double>::min_exponent - kDoubleDigits;
  const long drop = std::max(digit_count(mantissa) - kDoubleDigits, smallest - exponent);
  if (drop <= 0) return std::ldexp(mantissa.convert_to<double>(), static_cast<int>(exponent));
  Integer kept = mantissa >> drop;
  const Integer rest = mantissa - (kept << drop);
  bool up = rounding == Rounding::up && (!rest.is_zero() || !is_exact);
  if (rounding == Rounding::nearest) {
    const int side = rest.compare(Integer(1) << (drop - 1));
    const bool tie = side == 0 && is_exact;
    up = tie ? bit_test(kept, 0) : side >= 0;
  }
  if (up) ++kept;
  const double result = std::ldexp(kept.convert_to<double>(), static_cast<int>(exponent + drop));
  if (std::isinf(result) && rounding == Rounding::down) return std::numeric_limits<double>::max();
  return result;
}

Integer common_divisor(const Integer& a, const Integer& b) {
  if (a == 1 || b == 1) return 1;
  return a == b ? a : Integer(gcd(a, b));
}

/// Divides both by what they have in common.
void cancel(Integer& a, Integer& b) {
  const Integer common = common_divisor(a, b);
  if (common == 1) return;
  a /= common;
  b /= common;
}

/// The quotient rounded down, of at least `digits` digits, times a power of two.
struct Quotient {
  Integer mantissa;
  long exponent = 0;
  bool is_exact = true;
};
Quotient divided(const Integer& a, const Integer& b, long digits, bool even) {
  Quotient out;
  long shift = digits + 1 + digit_count(b) - digit_count(a);
  if (even && shift % 2 != 0) ++shift;
  Integer rest;
  divide_qr(shift >= 0 ? Integer(a << shift) : a, shift >= 0 ? b : Integer(b << -shift),
            out.mantissa, rest);
  out.exponent = -shift;
  out.is_exact = rest.is_zero();
  return out;
}

double root(const Rational& value, Rounding rounding) {
  if (value.sign() <= 0) return 0.0;
  const auto [numerator, denominator] = value.fraction();
  const Quotient square = divided(numerator, denominator, 2 * kDoubleDigits + 8, true);
  const Integer mantissa = root_down(square.mantissa);
  const bool is_exact = square.is_exact && mantissa * mantissa == square.mantissa;
  return rounded(mantissa, square.exponent / 2, is_exact, rounding);
}

}  // namespace

Rational::Rational(double value) {
  assert(std::isfinite(value));
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), kDoubleDigits);
  numerator_ = static_cast<std::int64_t>(mantissa);
  exponent_ = exponent - kDoubleDigits;
  reduce();
}

Rational::Rational(Integer numerator, Integer denominator)
    : Rational(std::move(numerator), std::move(denominator), 0) {
  assert(!denominator_.is_zero());
  cancel(numerator_, denominator_);
}

Rational::Rational(Integer numerator, Integer denominator, long exponent)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)), exponent_(exponent) {
  reduce();
}

void Rational::reduce() {
  if (numerator_.is_zero()) {
    denominator_ = 1;
    exponent_ = 0;
    return;
  }
  if (denominator_.sign() < 0) {
    numerator_ = -numerator_;
    denominator_ = -denominator_;
  }
  const auto make_odd = [&](Integer& a, int sign) {
    const long zeros = trailing_zeros(a);
    if (zeros == 0) return;
    a >>= zeros;
    exponent_ += sign * zeros;
  };
  make_odd(numerator_, 1);
  if (denominator_ != 1) make_odd(denominator_, -1);
}

Rational operator+(const Rational& a, const Rational& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  const long exponent = std::min(a.exponent_, b.exponent_);
  const Integer of_a = a.numerator_ << (a.exponent_ - exponent);
  const Integer of_b = b.numerator_ << (b.exponent_ - exponent);
  // Only what the denominators have in common can numerator and denominator of the sum have (Knuth,
  // The Art of Computer Programming 2, 4.5.1).
  Integer common = common_divisor(a.denominator_, b.denominator_);
  const Integer rest_of_a = a.denominator_ / common;
  const Integer rest_of_b = b.denominator_ / common;
  Integer numerator = of_a * rest_of_b + of_b * rest_of_a;
  cancel(numerator, common);
  return {std::move(numerator), rest_of_a * rest_of_b * common, exponent};
}

Rational operator-(const Rational& a, const Rational& b) { return a + -b; }

Rational operator*(Rational a, Rational b) {
  cancel(a.numerator_, b.denominator_);
  cancel(b.numerator_, a.denominator_);
  return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_, a.exponent_ + b.exponent_};
}

Rational operator/(const Rational& a, const Rational& b) {
  assert(b.sign() != 0);
  return a * Rational(b.denominator_, b.numerator_, -b.exponent_);
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  const long exponent = std::min(a.exponent_, b.exponent_);
  const Integer of_a = (a.numerator_ << (a.exponent_ - exponent)) * b.denominator_;
  const Integer of_b = (b.numerator_ << (b.exponent_ - exponent)) * a.denominator_;
  return of_a.compare(of_b) <=> 0;
}

Rational Rational::times_power_of_two(int exponent) const {
  Rational out = *this;
  if (sign() != 0) out.exponent_ += exponent;
  return out;
}

std::pair<Integer, Integer> Rational::fraction() const {
  return {numerator_ << std::max(0L, exponent_), denominator_ << std::max(0L, -exponent_)};
}

std::string to_string(const Rational& value) {
  const auto [numerator, denominator] = value.fraction();
  return denominator == 1 ? numerator.str() : numerator.str() + "/" + denominator.str();
}

double to_double(const Rational& value) {
  if (value.sign() == 0) return 0.0;
  const Quotient q = divided(abs(value.numerator_), value.denominator_, kDoubleDigits + 4, false);
  const double size =
      rounded(q.mantissa, q.exponent + value.exponent_, q.is_exact, Rounding::nearest);
  return value.sign() < 0 ? -size : size;
}

double root_nearest(const Rational& value) { return root(value, Rounding::nearest); }
double root_down(const Rational& value) { return root(value, Rounding::down); }
double root_up(const Rational& value) { return root(value, Rounding::up); }

}  // namespace gjkscope
