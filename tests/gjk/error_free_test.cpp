// Sums and products together with what rounding lost, against exact integers and wider scalars.

#include "gjk/proof/error_free.hpp"

#include <array>
#include <random>

#include "check.hpp"

namespace error_free_test {

using gjk::DoubleWord;
__extension__ typedef __int128 Int128;

constexpr int kCases = 20000;
constexpr std::uint64_t kSeed = 41;

class Numbers {
 public:
  /// An integer of up to `bits` bits, with either sign.
  [[nodiscard]] std::int64_t integer(int bits) {
    const auto size = static_cast<std::int64_t>(bits_() >> (64 - bits));
    return bits_() % 2 == 0 ? size : -size;
  }
  /// A float of all digits, times a power of two.
  [[nodiscard]] float full(int least, int most) {
    const auto digits = static_cast<float>(integer(24));
    return std::ldexp(digits, least + static_cast<int>(bits_() % (most - least + 1)));
  }

 private:
  std::mt19937_64 bits_{kSeed};
};

TEST(sum, "exact_sum gives the rounded sum and all that rounding lost") {
  Numbers numbers;
  int rounded = 0;
  for (int i = 0; i < kCases; ++i) {
    const check::Context context("seed", kSeed, "case", i);
    const auto a = static_cast<double>(numbers.integer(53));
    const double b = std::ldexp(static_cast<double>(numbers.integer(53)), i % 60);
    for (const auto& [x, y] : {std::array{a, b}, std::array{b, a}}) {
      const DoubleWord<double> sum = gjk::exact_sum(x, y);
      CHECK_EQ(x + y, sum.hi);
      CHECK(Int128(x) + Int128(y) == Int128(sum.hi) + Int128(sum.lo));
      rounded += sum.lo != 0 ? 1 : 0;
    }
  }
  CHECK(rounded > kCases);
}

TEST(product, "exact_product gives the rounded product and all that rounding lost") {
  Numbers numbers;
  int rounded = 0;
  for (int i = 0; i < kCases; ++i) {
    const check::Context context("seed", kSeed, "case", i);
    const auto a = static_cast<double>(numbers.integer(1 + i % 53));
    const auto b = static_cast<double>(numbers.integer(53));
    const DoubleWord<double> product = gjk::exact_product(a, b);
    CHECK_EQ(a * b, product.hi);
    CHECK(Int128(a) * Int128(b) == Int128(product.hi) + Int128(product.lo));
    rounded += product.lo != 0 ? 1 : 0;
  }
  CHECK(rounded > kCases / 2);
}

TEST(floats, "the same in float, where double holds every sum and product") {
  Numbers numbers;
  for (int i = 0; i < kCases; ++i) {
    const check::Context context("seed", kSeed, "case", i);
    const float a = numbers.full(-10, 0);
    const float b = numbers.full(-10, 10);
    const DoubleWord<float> sum = gjk::exact_sum(a, b);
    CHECK_EQ(double{a} + double{b}, double{sum.hi} + double{sum.lo});
    const DoubleWord<float> product = gjk::exact_product(a, b);
    CHECK_EQ(double{a} * double{b}, double{product.hi} + double{product.lo});
  }
}

TEST(room, "products of the least numbers that a run's unit allows lose nothing") {
  // u times the size; 1 + 2u has its last digit set, and so has its square.
  constexpr int kLeast = gjk::ScalarTraits<double>::least_exponent() - 53;
  const double all_digits = 1.0 + 0x1p-52;
  const DoubleWord<double> expected = gjk::exact_product(all_digits, all_digits);
  const double least = std::ldexp(all_digits, kLeast);
  const DoubleWord<double> product = gjk::exact_product(least, least);
  CHECK_EQ(expected.hi, std::ldexp(product.hi, -2 * kLeast));
  CHECK_EQ(expected.lo, std::ldexp(std::ldexp(product.lo, -kLeast), -kLeast));
  CHECK_EQ(0x1p-104, expected.lo);
}

/// Two floats that do not overlap, and their sum in a type that holds it.
struct Word {
  DoubleWord<float> word;
  long double value = 0;
};
Word word(Numbers& numbers) {
  const float hi = numbers.full(-4, 4);
  const float lo = std::ldexp(numbers.full(-3, 0), -25) * 0.5f;
  const DoubleWord<float> sum = gjk::exact_sum(hi, lo);
  return {sum, static_cast<long double>(sum.hi) + static_cast<long double>(sum.lo)};
}
long double value_of(const DoubleWord<float>& a) {
  return static_cast<long double>(a.hi) + static_cast<long double>(a.lo);
}
long double size_of(const Word& a) { return a.value < 0 ? -a.value : a.value; }

TEST(double_words, "sums, differences and products keep about twice the digits of a float") {
  Numbers numbers;
  constexpr long double kRounding = 0x1p-46L;
  for (int i = 0; i < kCases; ++i) {
    const check::Context context("seed", kSeed, "case", i);
    const Word a = word(numbers);
    const Word b = word(numbers);
    const long double size = size_of(a) + size_of(b);
    CHECK_NEAR(a.value + b.value, value_of(a.word + b.word), kRounding * size);
    CHECK_NEAR(a.value - b.value, value_of(a.word - b.word), kRounding * size);
    CHECK_NEAR(a.value * b.value, value_of(a.word * b.word), kRounding * size_of(a) * size_of(b));
    CHECK_EQ(-a.value, value_of(-a.word));
    for (const DoubleWord<float>& c : {a.word + b.word, a.word - b.word, a.word * b.word}) {
      CHECK_EQ(c.hi, c.hi + c.lo);  // the first is the whole, rounded
    }
  }
}

TEST(cancellation, "what is left when the first halves cancel is exact") {
  const DoubleWord<double> a{1.0, 0x1p-60};
  const DoubleWord<double> b{1.0, -0x1p-70};
  const DoubleWord<double> difference = a - b;
  CHECK_EQ(0x1p-60 + 0x1p-70, difference.hi);
  CHECK_EQ(0.0, difference.lo);
  // (1 + 2^-60) (1 - 2^-60) = 1 - 2^-120
  const DoubleWord<double> product = a * DoubleWord<double>{1.0, -0x1p-60};
  CHECK_EQ(1.0, product.hi);
  CHECK_EQ(0.0, product.lo);
}

}  // namespace error_free_test
