#include "geometry/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gjkscope {
namespace {

TEST(Rational, ToDoubleRoundsToNearestTiesToEven) {
  EXPECT_EQ(0.0, to_double(Rational(0)));
  EXPECT_EQ(0.1, to_double(Rational(1, 10)));
  EXPECT_EQ(-1.0 / 3.0, to_double(Rational(-1, 3)));
  EXPECT_EQ(2.0 / 3.0, to_double(Rational(2, 3)));  // truncation gives the double below
  EXPECT_EQ(0x1p53, to_double(Rational("9007199254740993")));
  EXPECT_EQ(0x1.0000000000002p53, to_double(Rational("9007199254740995")));
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
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Rational value(mpz_class(static_cast<unsigned long>(random() >> (random() % 60))),
                         mpz_class(static_cast<unsigned long>(random() >> (random() % 60)) | 1ul));
    Rational canonical = value;
    canonical.canonicalize();
    const double below = root_down(canonical);
    const double above = root_up(canonical);
    const double nearest = root_nearest(canonical);
    const Rational low(below);
    const Rational high(above);
    EXPECT_LE(low * low, canonical);
    EXPECT_GE(high * high, canonical);
    EXPECT_TRUE(below == above || std::nextafter(below, above) == above) << canonical.get_str();
    EXPECT_TRUE(nearest == below || nearest == above);
    const Rational middle = (low + high) / 2;
    const int side = cmp(middle * middle, canonical);
    if (side != 0) {
      EXPECT_EQ(side < 0 ? above : below, nearest);
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

}  // namespace
}  // namespace gjkscope
