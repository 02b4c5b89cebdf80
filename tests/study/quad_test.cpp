#include "study/quad.hpp"

#include <gtest/gtest.h>

#include "exact/rational.hpp"
#include "study/answer.hpp"
#include "study/families.hpp"
#include "study/truth.hpp"

namespace gjkscope {
namespace quad_test {

using study::difference;
using study::Truth;
using study::truth_of;
using Traits = gjk::ScalarTraits<Quad>;

Truth<2> of_points(double x, double y) {
  families::Pair<double> pair;
  pair.x.emplace_back(0.0, 0.0);
  pair.y.emplace_back(x, y);
  return truth_of(pair);
}

TEST(Quad, RootsAreGoodToTheLastDigit) {
  for (const double value : {2.0, 3.0, 0.1, 1e-300, 1e300, 4.0, 7e-5}) {
    const Quad root = Traits::root(Quad(value));
    const Quad off = root * root - Quad(value);
    EXPECT_LE(off < Quad(0) ? -off : off, Quad(value) * Quad(4) * Traits::unit_roundoff()) << value;
  }
  EXPECT_EQ(Traits::root(Quad(0)), Quad(0));
}

TEST(Quad, LimitsAreThoseOfTheFormat) {
  using Limits = std::numeric_limits<Quad>;
  EXPECT_NE(Quad(1) + Limits::epsilon(), Quad(1));
  EXPECT_EQ(Quad(1) + Traits::unit_roundoff(), Quad(1));
  EXPECT_GT(Limits::denorm_min(), Quad(0));
  EXPECT_EQ(Limits::denorm_min() / Quad(2), Quad(0));
  EXPECT_FALSE(Traits::is_finite(Limits::infinity()));
  EXPECT_FALSE(Traits::is_finite(Limits::quiet_NaN()));
  EXPECT_TRUE(Traits::is_finite(Limits::max()));
  EXPECT_FALSE(Traits::is_finite(Limits::max() * Quad(2)));
  EXPECT_EQ(Quad(0.75).exponent(), -1);
}

TEST(Truth, DistancesAreGoodToQuadsDigits) {
  const Truth two = of_points(1.0, 1.0);
  Rational sum(two.distance);
  Quad rest = two.rest;
  for (int part = 0; part < 3; ++part) {
    const auto rounded = static_cast<double>(rest);
    sum += Rational(rounded);
    rest = rest - Quad(rounded);
  }
  const Rational off = abs(sum * sum - 2);
  EXPECT_LT(to_double(off), 0x1p-148);
  EXPECT_EQ(difference(Quad(5), of_points(3.0, 4.0)), 0.0);
  EXPECT_EQ(difference(Quad(5) + Quad(0x1p-90), of_points(3.0, 4.0)), 0x1p-90);
}

TEST(Quad, RunsErrByRoundingsOfItsOwn) {
  families::Source random(5);
  int apart = 0;
  for (int i = 0; i < 100; ++i) {
    const auto pair = random.pair<double>(families::Family::random);
    study::Family family{"one", "", {pair}};
    const Truth truth = truth_of(pair);
    const study::Answer answer =
        study::ask(study::configuration(study::Arithmetic::quad), family).answers[0];
    EXPECT_EQ(answer.verdict != gjk::Verdict::separated, truth.overlap);
    EXPECT_LE(std::abs(difference(answer.distance, truth)),
              4 * 0x1p-113 * families::scale_of(pair));
    EXPECT_LE(difference(answer.lower, truth), 0.0);
    EXPECT_GE(difference(answer.upper, truth), 0.0);
    apart += truth.overlap ? 0 : 1;
  }
  EXPECT_GT(apart, 20);
  EXPECT_LT(apart, 90);
}

}  // namespace quad_test
}  // namespace gjkscope
