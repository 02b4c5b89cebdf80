// The exact truth, and the judge against claims that are wrong by little.

#include <gtest/gtest.h>

#include "bars.hpp"
#include "exact_run.hpp"
#include "study/families.hpp"

namespace gjkscope::study {
namespace truth_test {

using Eigen::Vector2d;
using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using families::kSpaceFamilyCount;
using families::Representation;
using gjk::Verdict;
using Pair = families::Pair<double>;

constexpr std::uint64_t kSeed = 2010;

/// Calls `check` with so many pairs of each family and representation.
template <int D = 2, class Check>
void for_each_pair(int count, const Check& check) {
  families::Source random(kSeed);
  for (int family = 0; family < (D == 2 ? kFamilyCount : kSpaceFamilyCount); ++family) {
    for (const auto representation : {Representation::float_values, Representation::full_doubles}) {
      for (int i = 0; i < count; ++i) {
        SCOPED_TRACE(::testing::Message()
                     << "seed " << kSeed << " dimension " << D << ' ' << kFamilyNames[family]
                     << " values " << static_cast<int>(representation) << " pair " << i);
        check(random.pair<double, D>(static_cast<Family>(family), representation), random);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

template <int D>
RationalPoints<D> differences(const families::Pair<double, D>& pair) {
  const ExactPair<D> both = exact(pair);
  RationalPoints<D> out;
  for (const auto& x : world(both.x, both.x_pose)) {
    for (const auto& y : world(both.y, both.y_pose)) out.emplace_back(y - x);
  }
  return out;
}

/// Some line (in space, plane) through O and D - 1 points of Z has all of Z on one side, or Z is
/// flat.
template <int D>
bool has_plane_through_origin(const RationalPoints<D>& z) {
  bool any = false;
  for (std::size_t i = 0; i < z.size(); ++i) {
    for (std::size_t k = i + 1; k < (D == 2 ? i + 2 : z.size()); ++k) {
      gjk::Vec<Rational, D> normal;
      if constexpr (D == 2) {
        normal = gjk::perpendicular<Rational, D>({z[i]});
      } else {
        normal = gjk::perpendicular<Rational, D>({z[i], z[k]});
      }
      if (gjk::is_zero(normal)) continue;
      any = true;
      bool left = false;
      bool right = false;
      for (auto b = z.begin(); b != z.end() && !(left && right); ++b) {
        const int side = (gjk::dot(normal, *b)).sign();
        left = left || side > 0;
        right = right || side < 0;
      }
      if (!(left && right)) return true;
    }
  }
  return !any;
}

template <int D>
gjk::WarmStart random_guess(const families::Pair<double, D>& pair, families::Source& random) {
  gjk::WarmStart guess;
  guess.count = random.among(0, D + 1);
  for (int i = 0; i < guess.count; ++i) {
    guess.pairs[i] = {random.among(0, static_cast<int>(pair.x.size()) - 1),
                      random.among(0, static_cast<int>(pair.y.size()) - 1)};
  }
  return guess;
}

struct Outcomes {
  int apart = 0;
  int touching = 0;
  int overlapping = 0;
};
template <int D>
Outcomes compare_with_runs() {
  Outcomes out;
  for_each_pair<D>(40, [&](const auto& pair, families::Source& random) {
    const Truth truth = truth_of(pair, random_guess(pair, random));
    const ExactPair<D> both = exact(pair);
    const auto run = gjk::distance(both.query());
    expect_proved(both, run);
    ASSERT_EQ(run.distance_sq == 0, truth.overlap);
    ASSERT_EQ(truth.overlap && has_plane_through_origin<D>(differences(pair)), truth.touching);
    ++(truth.touching ? out.touching : truth.overlap ? out.overlapping : out.apart);
    ASSERT_EQ(root_nearest(run.distance_sq), truth.distance);
    const double below = root_down(run.distance_sq);
    const double above = root_up(run.distance_sq);
    ASSERT_EQ(below == above, truth.rest == Quad(0));
    ASSERT_LE(difference(Quad(below), truth), 0.0);
    ASSERT_GE(difference(Quad(above), truth), 0.0);
  });
  return out;
}

TEST(Truth, IsThatOfRunsThatProveThemselvesWhateverTheGuess) {
  for (const Outcomes& found : {compare_with_runs<2>(), compare_with_runs<3>()}) {
    EXPECT_GT(found.apart, 500);
    EXPECT_GT(found.touching, 100);
    EXPECT_GT(found.overlapping, 300);
  }
}

template <int D>
void compare_scales() {
  for_each_pair<D>(10, [&](const auto& pair, families::Source&) {
    Rational largest = 0;
    for (const auto& z : differences(pair)) {
      const Rational length_sq = gjk::dot(z, z);
      largest = std::max(largest, length_sq);
    }
    const auto scale = static_cast<double>(truth_of(pair).scale);
    ASSERT_LE(root_down(largest), scale);
    ASSERT_GE(root_up(largest), scale);
  });
}
TEST(Truth, ScaleIsTheLargestDistanceOfVertices) {
  compare_scales<2>();
  compare_scales<3>();
}

TEST(Truth, HasTheDigitsOfQuad) {
  const Truth two = truth_of<2>({{{0, 0}}, {{1, 1}}});
  const auto high = static_cast<double>(two.rest);
  const auto middle = static_cast<double>(two.rest - Quad(high));
  const Rational sum = Rational(two.distance) + Rational(high) + Rational(middle);
  EXPECT_LT(std::abs(to_double(sum * sum - 2)), 0x1p-148);
  const Truth five = truth_of<2>({{{0, 0}}, {{3, 4}}});
  EXPECT_EQ(difference(Quad(5), five), 0.0);
  EXPECT_EQ(difference(Quad(5) + Quad(0x1p-90), five), 0x1p-90);
}

template <int D>
int measure_witnesses() {
  int inside = 0;
  for_each_pair<D>(60, [&](const auto& pair, families::Source& random) {
    using Point = gjk::Vec<double, D>;
    const families::Pair<double, D> twice{pair.x, pair.x, pair.x_pose, pair.x_pose};
    const Truth truth = truth_of(twice);
    const auto size = static_cast<double>(truth_of(pair).scale);
    Point q = pair.x_pose.rotated(pair.x[0]) + pair.x_pose.translation;
    for (int i = 0; i < D; ++i) q[i] += size * random.between(-1, 1);
    const Truth from_q = truth_of<D>({{q}, pair.x, {}, pair.x_pose});
    Claim<D> claim;
    claim.verdict = Verdict::overlapping;
    for (int i = 0; i < D; ++i) claim.x[i] = claim.y[i] = Quad(q[i]);
    ASSERT_NEAR(from_q.distance, judge(claim, {truth, truth}).witness, 0x1p-51 * size);
    inside += from_q.overlap;
  });
  return inside;
}
TEST(Judge, MeasuresHowFarAWitnessLiesOutside) {
  EXPECT_GT(measure_witnesses<2>(), 50);
  EXPECT_GT(measure_witnesses<3>(), 20);
}

/// A claim without an error: the truth, rounded. Only for pairs without poses near the origin.
struct Perfect {
  explicit Perfect(const Pair& pair) : truth(truth_of(pair)), unit(unit_of<double>(truth)) {
    const auto run = gjk::distance(exact(pair).query());
    claim.verdict = truth.touching  ? Verdict::touching
                    : truth.overlap ? Verdict::overlapping
                                    : Verdict::separated;
    claim.has_bounds = true;
    claim.distance = Quad(root_nearest(run.distance_sq));
    claim.lower = Quad(root_down(run.distance_sq));
    claim.upper = Quad(root_up(run.distance_sq));
    for (int i = 0; i < 2; ++i) {
      claim.x[i] = Quad(to_double(run.x[i]));
      claim.y[i] = Quad(to_double(run.y[i]));
    }
    claim.unit_roundoff = 0x1p-53;
  }
  [[nodiscard]] Judgement judged() const { return judge(claim, {truth, truth}); }
  [[nodiscard]] Errors errors() const { return errors_of(judged(), truth, unit); }

  Truth<2> truth;
  double unit = 0;
  Claim<2> claim;
};

const Pair kApart = {{{-1, -1}, {1, -1}, {1, 0.75}, {-1, 1}}, {{-2, 5}, {5, 7}, {0.25, 1.5}}};
const Pair kTouching = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{1, 0}, {3, 2}, {3, -3}}};
const Pair kOverlap = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{0.5, 0}, {3, 2}, {3, -3}}};

TEST(Judge, AcceptsThePerfectClaimInEveryFamily) {
  int apart = 0;
  for_each_pair(20, [&](const Pair& pair, families::Source&) {
    const Perfect perfect(pair);
    apart += perfect.truth.overlap ? 0 : 1;
    ASSERT_STREQ("", broken_bar(perfect.judged(), perfect.errors(), {1, kNoBar, 3, 2}));
  });
  EXPECT_GT(apart, 300);
}

TEST(Judge, RejectsBoundsThatAreWrongByOneUlp) {
  const Perfect perfect(kApart);
  ASSERT_FALSE(perfect.judged().broken_bounds);
  ASSERT_LT(perfect.claim.lower, perfect.claim.upper);
  for (const auto bound : {&Claim<2>::lower, &Claim<2>::upper}) {
    Perfect other = perfect;
    other.claim.lower = other.claim.distance = other.claim.upper = perfect.claim.*bound;
    EXPECT_TRUE(other.judged().broken_bounds);
  }
  for (const double beyond : {1.0, -1.0}) {
    Perfect other = perfect;
    other.claim.distance =
        (beyond > 0 ? perfect.claim.upper : perfect.claim.lower) + Quad(beyond * 0x1p-100);
    EXPECT_TRUE(other.judged().broken_bounds);
  }
}

TEST(Judge, RejectsABoundAboveZeroWhereTheShapesOverlapAndOneBelow) {
  for (const double bound : {0.0, std::numeric_limits<double>::denorm_min(), -0x1p-1000}) {
    Perfect perfect(kOverlap);
    perfect.claim.lower = perfect.claim.distance = perfect.claim.upper = Quad(bound);
    EXPECT_EQ(bound != 0.0, perfect.judged().broken_bounds);
  }
}

TEST(Judge, RejectsWrongVerdicts) {
  const Verdict verdicts[] = {Verdict::separated, Verdict::touching, Verdict::overlapping};
  const Pair* pairs[] = {&kApart, &kTouching, &kOverlap};
  for (int right = 0; right < 3; ++right) {
    for (int said = 0; said < 3; ++said) {
      Perfect perfect(*pairs[right]);
      perfect.claim.verdict = verdicts[said];
      EXPECT_EQ((right == 0) != (said == 0), perfect.judged().wrong);
      EXPECT_EQ(right != said, perfect.judged().wrong || perfect.judged().wrong_contact);
    }
    Perfect perfect(*pairs[right]);
    perfect.claim.verdict = Verdict::undecided;
    EXPECT_TRUE(perfect.judged().undecided);
    EXPECT_FALSE(perfect.judged().wrong || perfect.judged().wrong_contact);
  }
}

TEST(Judge, MeasuresErrorsInUnitsOfRoundOffTimesScale) {
  const Perfect perfect(kApart);
  const auto units = [&](double count) { return Quad(count * perfect.unit); };
  Perfect other = perfect;
  other.claim.distance = perfect.claim.distance + units(8);
  EXPECT_NEAR(8, other.errors().distance, 0.6);
  EXPECT_NEAR(8 * perfect.unit / perfect.truth.distance, other.errors().relative, 1e-16);
  other = perfect;
  other.claim.upper = perfect.claim.upper + units(32);
  EXPECT_NEAR(32, other.errors().width, 1);
  const auto coordinate = [](const std::array<Quad, 2>& p, int i) {
    return static_cast<double>(p[static_cast<std::size_t>(i)]);
  };
  const Vector2d along = Vector2d(coordinate(perfect.claim.y, 0) - coordinate(perfect.claim.x, 0),
                                  coordinate(perfect.claim.y, 1) - coordinate(perfect.claim.x, 1))
                             .normalized();
  for (const auto witness : {&Claim<2>::x, &Claim<2>::y}) {
    for (const double by : {16.0, -16.0}) {  // one way out of the shape, the other way into it
      other = perfect;
      for (int i = 0; i < 2; ++i) {
        (other.claim.*witness)[i] += units(by * along[i]);
      }
      EXPECT_NEAR(16, other.errors().witness, 1.6);
    }
  }
}

TEST(Judge, ForgivesOnlyTheRoundingOfWitnessesFarAway) {
  constexpr double kFar = 0x1p40;
  Pair pair = kApart;
  for (auto* points : {&pair.x, &pair.y}) {
    for (Vector2d& p : *points) p += Vector2d(kFar, kFar);
  }
  Perfect perfect(pair);
  EXPECT_LE(perfect.errors().witness, 4);
  constexpr double kGrid = 0x1p-12;
  for (Quad& x : perfect.claim.x) x += Quad(2 * kGrid);
  EXPECT_GT(perfect.errors().witness, 1e9);
}

TEST(Judge, NotesWhatIsNoNumberOrNoAnswer) {
  const auto failed = [](const auto& change) {
    Perfect perfect(kApart);
    change(perfect.claim);
    return perfect.judged().failed;
  };
  EXPECT_FALSE(failed([](Claim<2>&) {}));
  for (const auto number : {&Claim<2>::distance, &Claim<2>::lower, &Claim<2>::upper}) {
    EXPECT_TRUE(failed([&](Claim<2>& claim) { claim.*number = Quad(NAN); }));
  }
  for (const auto witness : {&Claim<2>::x, &Claim<2>::y}) {
    EXPECT_TRUE(failed([&](Claim<2>& claim) { (claim.*witness)[1] = Quad(INFINITY); }));
  }
  EXPECT_TRUE(failed([](Claim<2>& claim) { claim.refused = true; }));
  EXPECT_TRUE(failed([](Claim<2>& claim) { claim.verdict = Verdict::none; }));
}

}  // namespace truth_test
}  // namespace gjkscope::study
