#include "geometry/rational.hpp"

#include <algorithm>
#include <cmath>

namespace gjkscope {
namespace {

constexpr int kDoubleDigits = std::numeric_limits<double>::digits;

/// A non-negative number as mantissa * 2^exponent, or a little more than that when not exact. The
/// mantissa has at least two digits more than a double.
struct Scaled {
  mpz_class mantissa;
  long exponent = 0;
  bool exact = true;
};

enum class Rounding { nearest, down, up };

double to_double(const Scaled& value, Rounding rounding) {
  if (value.mantissa == 0) return 0.0;
  const long size = static_cast<long>(mpz_sizeinbase(value.mantissa.get_mpz_t(), 2));
  // Digits below the smallest denormal do not fit, so that there a double has fewer than 53.
  const long smallest = std::numeric_limits<double>::min_exponent - kDoubleDigits;
  const long drop = std::max(size - kDoubleDigits, smallest - value.exponent);
  if (drop <= 0) return std::ldexp(value.mantissa.get_d(), static_cast<int>(value.exponent));
  mpz_class kept;
  mpz_class rest;
  mpz_fdiv_q_2exp(kept.get_mpz_t(), value.mantissa.get_mpz_t(), static_cast<mp_bitcnt_t>(drop));
  mpz_fdiv_r_2exp(rest.get_mpz_t(), value.mantissa.get_mpz_t(), static_cast<mp_bitcnt_t>(drop));
  bool up = rounding == Rounding::up && (rest != 0 || !value.exact);
  if (rounding == Rounding::nearest) {
    const mpz_class half = mpz_class(1) << static_cast<mp_bitcnt_t>(drop - 1);
    const int side = cmp(rest, half);
    const bool tie = side == 0 && value.exact;
    up = tie ? mpz_odd_p(kept.get_mpz_t()) != 0 : side >= 0;
  }
  if (up) kept += 1;
  const double result = std::ldexp(kept.get_d(), static_cast<int>(value.exponent + drop));
  if (std::isinf(result) && rounding == Rounding::down) return std::numeric_limits<double>::max();
  return result;
}

/// floor(value * 2^shift), and whether nothing was lost.
Scaled shifted(const Rational& value, long shift) {
  mpz_class numerator = value.get_num();
  mpz_class denominator = value.get_den();
  if (shift >= 0) {
    numerator <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    denominator <<= static_cast<mp_bitcnt_t>(-shift);
  }
  Scaled out;
  mpz_class rest;
  mpz_fdiv_qr(out.mantissa.get_mpz_t(), rest.get_mpz_t(), numerator.get_mpz_t(),
              denominator.get_mpz_t());
  out.exact = rest == 0;
  out.exponent = -shift;
  return out;
}

/// The shift that leaves floor(value * 2^shift) at least `digits` long.
long shift_for(const Rational& value, long digits) {
  const auto size = [](const mpz_class& a) {
    return static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2));
  };
  return digits + 1 + size(value.get_den()) - size(value.get_num());
}

double root(const Rational& value, Rounding rounding) {
  if (value <= 0) return 0.0;
  // Twice the digits before the root, and an even exponent to halve.
  long shift = shift_for(value, 2 * kDoubleDigits + 8);
  if (shift % 2 != 0) ++shift;
  const Scaled square = shifted(value, shift);
  Scaled out;
  mpz_class rest;
  mpz_sqrtrem(out.mantissa.get_mpz_t(), rest.get_mpz_t(), square.mantissa.get_mpz_t());
  out.exact = square.exact && rest == 0;
  out.exponent = square.exponent / 2;
  return to_double(out, rounding);
}

}  // namespace

double to_double(const Rational& value) {
  if (value == 0) return 0.0;
  const Rational magnitude = abs(value);
  const double result =
      to_double(shifted(magnitude, shift_for(magnitude, kDoubleDigits + 4)), Rounding::nearest);
  return value < 0 ? -result : result;
}

double root_nearest(const Rational& value) { return root(value, Rounding::nearest); }
double root_down(const Rational& value) { return root(value, Rounding::down); }
double root_up(const Rational& value) { return root(value, Rounding::up); }

}  // namespace gjkscope
