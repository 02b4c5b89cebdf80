// The exact truth against the slow oracle, and the judge against claims that are wrong by little.

#include "exact.hpp"

#include <gtest/gtest.h>

#include "claim.hpp"
#include "oracle.hpp"
#include "study/families.hpp"

namespace truth {
namespace {

using Eigen::Vector2d;
using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using families::Pair;
using families::Representation;
using gjkscope::Rational;
using gjkscope::RationalPoint;

constexpr std::uint64_t kSeed = 2010;
constexpr Representation kRepresentations[] = {Representation::float_values,
                                               Representation::full_doubles};

/// Calls `check` with so many pairs of each family and representation.
template <class Check>
void for_each_pair(int count, const Check& check) {
  families::Source random(kSeed);
  for (int family = 0; family < kFamilyCount; ++family) {
    for (const Representation representation : kRepresentations) {
      for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(testing::Message()
                     << "seed " << kSeed << ' ' << kFamilyNames[family] << " values "
                     << static_cast<int>(representation) << " pair " << i);
        check(random.pair<double>(static_cast<Family>(family), representation), random);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

std::vector<RationalPoint> world(const gjk::Shape<double, 2>& shape) {
  std::vector<RationalPoint> out;
  for (const Vector2d& v : shape.vertices) {
    RationalPoint at;
    for (int i = 0; i < 2; ++i) {
      at[i] = Rational(shape.pose.rotation(i, 0)) * Rational(v[0]) +
              Rational(shape.pose.rotation(i, 1)) * Rational(v[1]) +
              Rational(shape.pose.translation[i]);
    }
    out.push_back(at);
  }
  return out;
}

std::vector<gjk::VertexPair> random_guess(const Pair<double>& pair, families::Source& random) {
  std::vector<gjk::VertexPair> guess(static_cast<std::size_t>(random.among(0, 3)));
  for (gjk::VertexPair& vertices : guess) {
    vertices.x = random.among(0, static_cast<int>(pair.x.size()) - 1);
    vertices.y = random.among(0, static_cast<int>(pair.y.size()) - 1);
  }
  return guess;
}

TEST(Exact, EqualsTheOracleWhateverTheGuess) {
  int apart = 0;
  int touching = 0;
  int overlapping = 0;
  for_each_pair(40, [&](const Pair<double>& pair, families::Source& random) {
    const auto query = pair.query();
    const auto x = world(query.x);
    const auto y = world(query.y);
    const gjkscope::ExactAnswer answer = gjkscope::exact_answer(x, y);
    const ExactPair exact(query);
    const Truth truth = exact.truth(random_guess(pair, random));
    ASSERT_EQ(answer.overlap, truth.overlap);
    ASSERT_EQ(answer.touching, truth.overlap && exact.touching());
    ++(answer.touching ? touching : answer.overlap ? overlapping : apart);
    if (answer.overlap) return;
    const double below = gjkscope::root_down(answer.distance_sq);
    const double above = gjkscope::root_up(answer.distance_sq);
    ASSERT_LE(below, static_cast<double>(truth.distance));
    ASSERT_GE(above, static_cast<double>(truth.distance));
    ASSERT_EQ(below == above ? 0 : -1, exact.compare(below, truth));
    ASSERT_EQ(below == above ? 0 : 1, exact.compare(above, truth));
    ASSERT_EQ(-1, exact.compare(std::nextafter(below, 0.0), truth));
    ASSERT_EQ(1, exact.compare(std::nextafter(above, INFINITY), truth));
  });
  EXPECT_GT(apart, 500);
  EXPECT_GT(touching, 100);
  EXPECT_GT(overlapping, 300);
}

TEST(Exact, LiesInTheBoundsOfLongDoubles) {
  constexpr long double kGoodTo = 0x1p-60L;
  int settled = 0;
  for_each_pair(60, [&](const Pair<double>& pair, families::Source&) {
    const auto query = pair.query();
    const Truth truth = ExactPair(query).truth({});
    const auto result = gjk::distance<long double>(query);
    ASSERT_EQ(gjk::Error::none, result.error);
    ASSERT_LE(result.lower, truth.distance * (1 + kGoodTo));
    ASSERT_GE(result.upper, truth.distance * (1 - kGoodTo));
    settled += result.settled && !truth.overlap ? 1 : 0;
  });
  EXPECT_GT(settled, 10);
}

TEST(Exact, ScaleIsTheLargestDistanceOfVertices) {
  for_each_pair(10, [&](const Pair<double>& pair, families::Source&) {
    Rational largest = 0;
    for (const RationalPoint& x : world(pair.query().x)) {
      for (const RationalPoint& y : world(pair.query().y)) {
        const RationalPoint z = y - x;
        const Rational length_sq = gjk::dot(z, z);
        largest = std::max(largest, length_sq);
      }
    }
    const double scale = static_cast<double>(ExactPair(pair.query()).scale());
    ASSERT_LE(gjkscope::root_down(largest), scale);
    ASSERT_GE(gjkscope::root_up(largest), scale);
  });
}

TEST(Exact, DistanceFromAHullIsThatOfAPointQuery) {
  int inside = 0;
  for_each_pair(60, [&](const Pair<double>& pair, families::Source& random) {
    const Vector2d centre = pair.x_pose.rotated(pair.x[0]) + pair.x_pose.translation;
    const long double size = ExactPair(pair.query()).scale();
    const Vector2d q =
        centre + static_cast<double>(size) * Vector2d(random.between(-1, 1), random.between(-1, 1));
    const Pair<double> from_q{{q}, pair.x, {}, pair.x_pose};
    const Truth truth = ExactPair(from_q.query()).truth({});
    const long double found = ExactPair(pair.query()).distance_from_x(q);
    ASSERT_LE(std::abs(truth.distance - found), 0x1p-59L * size);
    const long double same = ExactPair(families::swapped(pair).query()).distance_from_y(q);
    ASSERT_LE(std::abs(truth.distance - same), 0x1p-59L * size);
    inside += truth.overlap;
  });
  EXPECT_GT(inside, 50);
}

/// A claim without an error: the truth, rounded. Only for pairs without poses near the origin.
struct Perfect {
  explicit Perfect(const Pair<double>& pair) : exact(pair.query()), truth(exact.truth({})) {
    const gjkscope::ExactAnswer answer =
        gjkscope::exact_answer(world(pair.query().x), world(pair.query().y));
    scale = exact.scale();
    unit = 0x1p-53 * static_cast<double>(scale);
    claim.stop = gjk::StopReason::repeated_support;
    claim.verdict = gjk::Verdict::separated;
    claim.distance = gjkscope::root_nearest(answer.distance_sq);
    claim.lower = gjkscope::root_down(answer.distance_sq);
    claim.upper = gjkscope::root_up(answer.distance_sq);
    for (int i = 0; i < 2; ++i) {
      claim.x[i] = gjkscope::to_double(answer.x[i]);
      claim.y[i] = gjkscope::to_double(answer.y[i]);
    }
    claim.unit_roundoff = 0x1p-53;
    claim.smallest = std::numeric_limits<double>::denorm_min();
  }
  [[nodiscard]] Judgement judged() const { return judge(exact, truth, scale, claim); }

  ExactPair exact;
  Truth truth;
  long double scale = 0;
  double unit = 0;
  Claim claim;
};

const Pair<double> kApart = {{{-1, -1}, {1, -1}, {1, 0.75}, {-1, 1}},
                             {{-2, 5}, {5, 7}, {0.25, 1.5}}};
const Pair<double> kTouching = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{1, 0}, {3, 2}, {3, -3}}};
const Pair<double> kOverlap = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{0.5, 0}, {3, 2}, {3, -3}}};

TEST(Judge, AcceptsThePerfectClaimInEveryFamily) {
  int apart = 0;
  for_each_pair(20, [&](const Pair<double>& pair, families::Source&) {
    if (ExactPair(pair.query()).truth({}).overlap) return;
    ++apart;
    const Judgement found = Perfect(pair).judged();
    ASSERT_FALSE(found.not_a_number || found.wrong_verdict || found.broken_certificate);
    ASSERT_LE(found.distance_error, 1);
    ASSERT_LE(found.outside, 1.5);
    ASSERT_LE(found.apart, 3);
    ASSERT_LE(found.width, 2);
  });
  EXPECT_GT(apart, 300);
}

TEST(Judge, RejectsBoundsThatAreWrongByOneUlp) {
  const Perfect perfect(kApart);
  ASSERT_FALSE(perfect.judged().broken_certificate);
  ASSERT_LT(perfect.claim.lower, perfect.claim.upper);
  for (const auto wrong : {&Claim::lower, &Claim::upper}) {
    Perfect other = perfect;
    other.claim.lower = other.claim.distance = other.claim.upper =
        wrong == &Claim::lower ? perfect.claim.upper : perfect.claim.lower;
    EXPECT_TRUE(other.judged().broken_certificate);
  }
  Perfect outside = perfect;
  outside.claim.distance = std::nextafter(perfect.claim.upper, INFINITY);
  EXPECT_TRUE(outside.judged().broken_certificate);
  outside.claim.distance = std::nextafter(perfect.claim.lower, 0.0);
  EXPECT_TRUE(outside.judged().broken_certificate);
}

TEST(Judge, RejectsABoundAboveZeroWhereTheShapesOverlap) {
  Perfect perfect(kOverlap);
  perfect.claim.verdict = gjk::Verdict::overlapping;
  EXPECT_FALSE(perfect.judged().broken_certificate);
  perfect.claim.lower = perfect.claim.distance = perfect.claim.upper =
      std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE(perfect.judged().broken_certificate);
}

TEST(Judge, RejectsWrongVerdicts) {
  using gjk::Verdict;
  const auto wrong = [](const Pair<double>& pair, Verdict verdict, double distance) {
    Perfect perfect(pair);
    perfect.claim.verdict = verdict;
    perfect.claim.distance = distance;
    return perfect.judged().wrong_verdict;
  };
  EXPECT_TRUE(wrong(kApart, Verdict::overlapping, 0));
  EXPECT_TRUE(wrong(kApart, Verdict::touching, 0));
  EXPECT_TRUE(wrong(kOverlap, Verdict::separated, 0));
  EXPECT_TRUE(wrong(kOverlap, Verdict::touching, 0));
  EXPECT_FALSE(wrong(kOverlap, Verdict::overlapping, 0));
  EXPECT_FALSE(wrong(kTouching, Verdict::touching, 0));
  EXPECT_FALSE(wrong(kTouching, Verdict::overlapping, 0));
  const double unit = Perfect(kTouching).unit;
  EXPECT_FALSE(wrong(kTouching, Verdict::separated, 4 * unit));
  EXPECT_TRUE(wrong(kTouching, Verdict::separated, 4.01 * unit));
  EXPECT_TRUE(wrong(kApart, Verdict::none, 0));
}

TEST(Judge, MeasuresErrorsInUnitsOfRoundOffTimesScale) {
  const Perfect perfect(kApart);
  Perfect other = perfect;
  other.claim.distance += 8 * perfect.unit;
  EXPECT_NEAR(8, other.judged().distance_error, 0.6);
  EXPECT_NEAR(8 * perfect.unit / perfect.claim.distance, other.judged().relative_error, 1e-16);
  EXPECT_NEAR(8, other.judged().apart, 1.6);
  other = perfect;
  other.claim.upper += 32 * perfect.unit;
  EXPECT_NEAR(32, other.judged().width, 1);
  const Vector2d along = (perfect.claim.y - perfect.claim.x).normalized();
  for (const auto witness : {&Claim::x, &Claim::y}) {
    other = perfect;
    other.claim.*witness += (witness == &Claim::x ? 16 : -16) * perfect.unit * along;
    EXPECT_NEAR(16, other.judged().outside, 1.6);
    EXPECT_NEAR(16, other.judged().apart, 1.6);
    other = perfect;
    other.claim.*witness -= (witness == &Claim::x ? 16 : -16) * perfect.unit * along;
    EXPECT_LE(other.judged().outside, 0.6);
    EXPECT_NEAR(16, other.judged().apart, 1.6);
  }
}

TEST(Judge, ForgivesOnlyTheRoundingOfWitnessesFarAway) {
  constexpr double kFar = 0x1p40;
  Pair<double> pair = kApart;
  for (auto* points : {&pair.x, &pair.y}) {
    for (Vector2d& p : *points) p += Vector2d(kFar, kFar);
  }
  Perfect perfect(pair);
  const double grid = 0x1p-12;
  EXPECT_LE(perfect.judged().outside, 4);
  perfect.claim.x += Vector2d(2 * grid, 2 * grid);
  EXPECT_GT(perfect.judged().outside, 1e9);
}

TEST(Judge, NotesWhatIsNoNumberOrNoAnswer) {
  for (const auto number : {&Claim::distance, &Claim::lower, &Claim::upper}) {
    Perfect perfect(kApart);
    perfect.claim.*number = NAN;
    EXPECT_TRUE(perfect.judged().not_a_number);
  }
  for (const auto witness : {&Claim::x, &Claim::y}) {
    Perfect perfect(kApart);
    (perfect.claim.*witness)[1] = INFINITY;
    EXPECT_TRUE(perfect.judged().not_a_number);
  }
  Perfect perfect(kApart);
  perfect.claim.verdict = gjk::Verdict::undecided;
  perfect.claim.stop = gjk::StopReason::iteration_cap;
  EXPECT_TRUE(perfect.judged().undecided);
  EXPECT_TRUE(perfect.judged().capped);
  perfect.claim.error = gjk::Error::overflow;
  EXPECT_TRUE(perfect.judged().refused);
}

}  // namespace
}  // namespace truth
