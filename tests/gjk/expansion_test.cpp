// Exact arithmetic on doubles, against exact integers.

#include <random>

#include "check.hpp"
#include "gjk/proof/error_free.hpp"

namespace expansion_test {

using gjk::Expansion;
__extension__ typedef __int128 Int128;

constexpr int kCases = 5000;
constexpr std::uint64_t kSeed = 42;

/// Both the number and what it must be.
struct Number {
  Expansion expansion;
  Int128 integer = 0;
};
Number number(std::int64_t value) { return {Expansion(static_cast<double>(value)), value}; }
Number operator+(const Number& a, const Number& b) {
  return {a.expansion + b.expansion, a.integer + b.integer};
}
Number operator-(const Number& a, const Number& b) {
  return {a.expansion - b.expansion, a.integer - b.integer};
}
Number operator*(const Number& a, const Number& b) {
  return {a.expansion * b.expansion, a.integer * b.integer};
}

class Numbers {
 public:
  /// An integer of up to `bits` bits; often one of those before, so that sums cancel.
  [[nodiscard]] Number integer(int bits) {
    const std::uint64_t choice = bits_() % 4;
    const auto size = static_cast<std::int64_t>(bits_() >> (64 - bits));
    if (choice > 0) last_ = choice == 1 ? -last_ : choice == 2 ? size : -size;
    if (last_ >> bits != 0 && last_ >> bits != -1) last_ = size;
    return number(last_);
  }

 private:
  std::mt19937_64 bits_{kSeed};
  std::int64_t last_ = 1;
};

/// In 40 bits at a time, which do not overlap.
Expansion expansion_of(Int128 value) {
  Expansion out;
  for (int shift = 80; shift >= 0; shift -= 40) {
    const Int128 limb = value / (Int128(1) << shift);
    value -= limb * (Int128(1) << shift);
    out = out + Expansion(std::ldexp(static_cast<double>(limb), shift));
  }
  return out;
}
int sign_of(Int128 value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

void check_number(const Number& found) {
  CHECK_EQ(sign_of(found.integer), found.expansion.sign());
  CHECK(found.expansion == expansion_of(found.integer));
  CHECK(!(found.expansion == expansion_of(found.integer + 1)));
  CHECK(found.expansion < expansion_of(found.integer + 1));
  CHECK(!(found.expansion < expansion_of(found.integer)));
  CHECK(expansion_of(found.integer - 1) < found.expansion);
  const auto nearest = static_cast<double>(found.integer);
  CHECK_NEAR(nearest, static_cast<double>(found.expansion), std::abs(nearest) * 0x1p-52);
}

TEST(integers, "sums and products of products of 53 bits are those of integers") {
  Numbers numbers;
  int zeros = 0;
  for (int i = 0; i < kCases; ++i) {
    const check::Context context("seed", kSeed, "case", i);
    const Number a = numbers.integer(53);
    const Number b = numbers.integer(53);
    const Number c = numbers.integer(53);
    const Number d = numbers.integer(53);
    for (const Number& found : {a * b - c * d, a * b + c * d, (a + b) * (c - d), a * b - b * a}) {
      check_number(found);
      zeros += found.integer == 0 ? 1 : 0;
    }
  }
  CHECK(zeros > kCases);
  CHECK(zeros < 3 * kCases);
}

TEST(long_products, "products of long numbers are those of integers") {
  Numbers numbers;
  for (int i = 0; i < kCases; ++i) {
    const check::Context context("seed", kSeed, "case", i);
    const Number a = numbers.integer(20) * numbers.integer(20) * numbers.integer(20);
    const Number b = numbers.integer(20) * numbers.integer(20);
    check_number(a * b);
    check_number(a * numbers.integer(50) - numbers.integer(50) * a);
  }
}

TEST(wide, "numbers 2^1000 times as large lose nothing of the small ones") {
  const Expansion one(1.0);
  const Expansion large(0x1p500);
  const Expansion small(0x1p-500);
  const Expansion all = large + one + small;
  CHECK(large + one < all);
  CHECK(all - large - small == one);
  CHECK(all - large - one == small);
  CHECK_EQ(1, (all - large - one).sign());
  CHECK_EQ(-1, (large - all).sign());
  // (1 + 2^-500) (1 - 2^-500) = 1 - 2^-1000
  const Expansion product = (one + small) * (one - small);
  CHECK(product < one);
  CHECK(one - product == Expansion(0x1p-1000));
}

TEST(signs, "minus turns the sign, of zero too; scaled moves it by powers of two") {
  CHECK_EQ(0, Expansion().sign());
  CHECK_EQ(0, Expansion(0.0).sign());
  CHECK_EQ(0, (-Expansion()).sign());
  CHECK(Expansion() == Expansion(-0.0));
  CHECK_EQ(0.0, static_cast<double>(Expansion()));
  const Expansion number = Expansion(3.0) + Expansion(0x1p-80);
  CHECK_EQ(-1, (-number).sign());
  CHECK((-number) + number == Expansion());
  CHECK(number.scaled(70) == Expansion(0x3p70) + Expansion(0x1p-10));
  CHECK(number.scaled(-70).scaled(70) == number);
}

TEST(division, "a quotient rounds to long double") {
  CHECK((Expansion(6.0) + Expansion(0x1p-79)) / Expansion(3.0) == Expansion(2.0));
}

TEST(traits, "the core's questions: exact, always finite, roots bounded from both sides") {
  using Traits = gjk::ScalarTraits<Expansion>;
  CHECK(Traits::kExact);
  CHECK(Traits::is_finite(Traits::from(3)));
  CHECK(Traits::from(0.25f) == Expansion(0.25));
  CHECK(Traits::scaled(Expansion(3.0), 0) == Expansion(3.0));
  CHECK(Traits::scaled(Expansion(3.0), 4) == Expansion(48.0));
  CHECK(Traits::no_length() != Traits::no_length());
  for (const double value : {0.0, 0.3, 1.0, 2.0, 3.0, 1e10}) {
    const check::Context context("value", value);
    const Expansion square = Expansion(value) + Expansion(value * 0x1p-60);
    const Expansion below(Traits::root_below(square));
    const Expansion above(Traits::root_above(square));
    CHECK(!(square < below * below));
    CHECK(!(above * above < square));
    CHECK_NEAR(std::sqrt(value), Traits::root(square), 1e-15 * value);
    CHECK_NEAR(static_cast<double>(below), static_cast<double>(above), 4e-15 * value);
  }
}

}  // namespace expansion_test
