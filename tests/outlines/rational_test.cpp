#include "exact/rational.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gjkscope {
namespace rational_test {

/// A number and what GMP, which shares no code with it, says that it is.
struct Both {
  Rational ours;
  mpq_class theirs;
};

class Numbers {
 public:
  Both any() {
    switch (random_() % 6) {
      case 0:
        return {Rational(0), 0};
      case 1:
        return of_double(std::ldexp(signed_digits(), static_cast<int>(random_() % 300) - 150));
      case 2:
        return of_double(signed_digits());
      case 3:  // of some hundreds of digits, beyond what an Integer keeps in itself
        return power(fraction(), 5 + static_cast<int>(random_() % 10));
      default:
        return fraction();
    }
  }

 private:
  double signed_digits() { return static_cast<double>(static_cast<int>(random_() % 2001) - 1000); }
  static Both of_double(double value) { return {Rational(value), mpq_class(value)}; }
  Both fraction() {
    const auto a = static_cast<long>(random_() >> (1 + random_() % 60)) - 5;
    const auto b = static_cast<long>(random_() >> (1 + random_() % 60)) + 1;
    Both out{Rational(Integer(a), Integer(b)), mpq_class(a, b)};
    out.theirs.canonicalize();
    return out;
  }
  static Both power(const Both& base, int exponent) {
    Both out{1, 1};
    for (int i = 0; i < exponent; ++i) out = {out.ours * base.ours, out.theirs * base.theirs};
    return out;
  }

  std::mt19937_64 random_{1};
};

void expect_same(const mpq_class& theirs, const Rational& ours) {
  ASSERT_EQ(theirs.get_str(), to_string(ours));
}

TEST(Rational, CountsAsGmpDoes) {
  Numbers numbers;
  int fractions = 0;
  int equal = 0;
  for (int i = 0; i < 20000; ++i) {
    const Both a = numbers.any();
    const Both b = i % 10 == 0 ? a : numbers.any();
    expect_same(a.theirs, a.ours);
    expect_same(a.theirs + b.theirs, a.ours + b.ours);
    expect_same(a.theirs - b.theirs, a.ours - b.ours);
    expect_same(a.theirs * b.theirs, a.ours * b.ours);
    if (b.theirs != 0) expect_same(a.theirs / b.theirs, a.ours / b.ours);
    expect_same(-a.theirs, -a.ours);
    expect_same(abs(a.theirs), abs(a.ours));
    EXPECT_EQ(sgn(a.theirs), a.ours.sign());
    EXPECT_EQ(cmp(a.theirs, b.theirs) < 0, a.ours < b.ours);
    EXPECT_EQ(a.theirs == b.theirs, a.ours == b.ours);
    EXPECT_EQ(a.theirs == b.theirs, (a.ours <=> b.ours) == 0);
    equal += a.ours == b.ours ? 1 : 0;
    fractions += mpz_popcount(a.theirs.get_den_mpz_t()) > 1 ? 1 : 0;
  }
  EXPECT_GT(fractions, 5000);
  EXPECT_GT(equal, 2000);
}

TEST(Rational, PowersOfTwoAreExact) {
  EXPECT_EQ(Rational(Integer(3), Integer(8)), Rational(3).times_power_of_two(-3));
  EXPECT_EQ(Rational(24), Rational(3).times_power_of_two(3));
  EXPECT_EQ(Rational(0), Rational(0).times_power_of_two(7));
}

TEST(Rational, ToDoubleRoundsToNearestTiesToEven) {
  EXPECT_EQ(0.0, to_double(Rational(0)));
  EXPECT_EQ(0.1, to_double(Rational(1) / 10));
  EXPECT_EQ(-1.0 / 3.0, to_double(Rational(-1) / 3));
  EXPECT_EQ(2.0 / 3.0, to_double(Rational(2) / 3));  // truncation gives the double below
  EXPECT_EQ(0x1p53, to_double(Rational(Integer("9007199254740993"))));
  EXPECT_EQ(0x1.0000000000002p53, to_double(Rational(Integer("9007199254740995"))));
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const double value =
        std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 600) - 300);
    EXPECT_EQ(value, to_double(Rational(value)));
  }
}

TEST(Rational, ToDoubleKnowsDenormalsAndTheLargest) {
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(smallest, to_double(Rational(smallest)));
  EXPECT_EQ(0.0, to_double(Rational(smallest) / 4));
  EXPECT_EQ(smallest, to_double(Rational(smallest) * 3 / 4));
  EXPECT_EQ(1e-310, to_double(Rational(1e-310)));
  EXPECT_EQ(std::numeric_limits<double>::max(),
            to_double(Rational(std::numeric_limits<double>::max())));
}

TEST(Rational, RootsEncloseTheRootAsCloselyAsDoublesCan) {
  Numbers numbers;
  for (int i = 0; i < 5000; ++i) {
    const Rational value = abs(numbers.any().ours);
    const double below = root_down(value);
    const double above = root_up(value);
    const double nearest = root_nearest(value);
    const Rational low(below);
    const Rational high(above);
    EXPECT_LE(low * low, value);
    EXPECT_GE(high * high, value);
    EXPECT_TRUE(below == above || std::nextafter(below, above) == above) << to_string(value);
    EXPECT_TRUE(nearest == below || nearest == above);
    const Rational middle = (low + high) / 2;
    if (middle * middle != value) {
      EXPECT_EQ(middle * middle < value ? above : below, nearest);
    }
  }
}

TEST(Rational, ExactRootsAreExact) {
  for (const double root : {0.0, 1.0, 0.1, 3.0, 1e-100, 1e150, 0x1p-300}) {
    const Rational square = Rational(root) * Rational(root);
    EXPECT_EQ(root, root_down(square));
    EXPECT_EQ(root, root_up(square));
    EXPECT_EQ(root, root_nearest(square));
  }
}

TEST(Integer, RootsAreGmps) {
  gmp_randclass random(gmp_randinit_default);
  for (int i = 0; i < 20000; ++i) {
    mpz_class theirs = random.get_z_bits(static_cast<mp_bitcnt_t>(i % 1000));
    if (i % 3 == 0) theirs = theirs * theirs - (i % 2);
    if (theirs < 0) continue;
    ASSERT_EQ(mpz_class(sqrt(theirs)).get_str(), root_down(Integer(theirs.get_str())).str());
  }
}

}  // namespace rational_test
}  // namespace gjkscope
