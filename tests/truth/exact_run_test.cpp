// GJK in rationals against the oracle, and GJK's certificates in floating point against GJK in
// rationals.

#include <gtest/gtest.h>

#include <cmath>

#include "gjk/gjk.hpp"
#include "oracle.hpp"
#include "study/families.hpp"

namespace gjkscope {
namespace {

using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using gjk::Verdict;

struct ExactQuery {
  std::vector<RationalPoint> x;
  std::vector<RationalPoint> y;
  gjk::Pose<Rational, 2> x_pose;
  gjk::Pose<Rational, 2> y_pose;
  [[nodiscard]] gjk::Query<Rational, 2> query() const { return {{x, x_pose}, {y, y_pose}}; }
};

template <class S>
ExactQuery exact(const families::Pair<S>& pair) {
  ExactQuery out;
  for (const auto& v : pair.x) out.x.push_back(rational(v[0], v[1]));
  for (const auto& v : pair.y) out.y.push_back(rational(v[0], v[1]));
  for (int i = 0; i < 2; ++i) {
    out.x_pose.translation[i] = Rational(pair.x_pose.translation[i]);
    out.y_pose.translation[i] = Rational(pair.y_pose.translation[i]);
  }
  const auto exact_rotation = [](const auto& rotation) {
    Eigen::Matrix<Rational, 2, 2> matrix;
    for (int i = 0; i < 4; ++i) matrix(i / 2, i % 2) = Rational(rotation(i / 2, i % 2));
    return matrix;
  };
  out.x_pose.rotation = exact_rotation(pair.x_pose.rotation);
  out.y_pose.rotation = exact_rotation(pair.y_pose.rotation);
  return out;
}

std::vector<RationalPoint> world(std::span<const RationalPoint> vertices,
                                 const gjk::Pose<Rational, 2>& pose) {
  std::vector<RationalPoint> out;
  for (const RationalPoint& vertex : vertices)
    out.push_back(pose.rotated(vertex) + pose.translation);
  return out;
}

TEST(ExactRun, EqualsTheOracle) {
  constexpr std::uint64_t kSeed = 31;
  families::Source random(kSeed);
  int separated = 0;
  int touching = 0;
  int overlapping = 0;
  for (int i = 0; i < 3000; ++i) {
    const int family = i % 3 == 0 ? i / 3 % kFamilyCount : static_cast<int>(Family::grid);
    SCOPED_TRACE(testing::Message()
                 << "seed " << kSeed << " pair " << i << ' ' << kFamilyNames[family]);
    if (static_cast<Family>(family) == Family::clouds) continue;  // 12 points each: slow
    const ExactQuery pair = exact(random.pair<double>(static_cast<Family>(family)));
    const auto x = world(pair.x, pair.x_pose);
    const auto y = world(pair.y, pair.y_pose);
    const ExactAnswer answer = exact_answer(x, y);
    const auto result = gjk::distance(pair.query());
    ASSERT_EQ(answer.distance_sq, result.distance_sq);
    ASSERT_EQ(answer.overlap, result.verdict != Verdict::separated);
    ASSERT_NE(Verdict::undecided, result.verdict);
    ASSERT_NE(gjk::StopReason::iteration_cap, result.stop);
    const RationalPoint difference = result.y - result.x;
    ASSERT_EQ(answer.distance_sq, gjk::dot(difference, difference));
    if (answer.overlap) {
      ASSERT_EQ(0.0, result.lower);
      ASSERT_EQ(0.0, result.upper);
      ASSERT_EQ(answer.touching, result.verdict == Verdict::touching);
    } else {
      ASSERT_TRUE(is_nearest_pair(x, y, result.x, result.y));
    }
    ++(answer.touching ? touching : answer.overlap ? overlapping : separated);
  }
  EXPECT_GT(separated, 1000);
  EXPECT_GT(touching, 100);
  EXPECT_GT(overlapping, 300);
}

TEST(ExactRun, ItsBoundsMeet) {
  constexpr std::uint64_t kSeed = 32;
  families::Source random(kSeed);
  int separated = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " pair " << i);
    const ExactQuery pair = exact(random.pair<double>(static_cast<Family>(i % kFamilyCount)));
    const auto trace = gjk::trace(pair.query());
    const auto& last = trace.steps.back().after;
    if (trace.result.verdict == Verdict::separated) {
      ++separated;
      ASSERT_EQ(last.best_sq, last.plane_distance_sq);
    } else {
      ASSERT_EQ(0, last.best_sq);
      ASSERT_EQ(0, last.plane_distance_sq);
    }
    ASSERT_LE(trace.result.lower, trace.result.distance);
    ASSERT_LE(trace.result.distance, trace.result.upper);
    ASSERT_LE(trace.result.upper, std::nextafter(trace.result.lower, INFINITY));
  }
  EXPECT_GT(separated, 500);
}

struct CertificateCounts {
  long separated = 0;
  long zero = 0;  ///< Verdict touching or overlapping.
  long undecided = 0;
};

template <class S>
CertificateCounts check_certificates(Family family, int pairs, std::uint64_t seed,
                                     const gjk::Options& options) {
  families::Source random(seed);
  CertificateCounts counts;
  for (int i = 0; i < pairs; ++i) {
    const auto pair = random.pair<S>(family);
    const ExactQuery exact_pair = exact(pair);
    const gjk::Query<Rational, 2> query = exact_pair.query();
    const auto truth = gjk::distance(query);
    const auto found = gjk::distance(pair.query(), options);
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << " pair " << i << " family "
                 << kFamilyNames[static_cast<int>(family)] << " bytes " << sizeof(S) << "\nlower "
                 << found.lower << " exact " << truth.distance << " upper " << found.upper);
    const Rational lower(found.lower);
    const Rational upper(found.upper);
    EXPECT_LE(lower * lower, truth.distance_sq);
    EXPECT_GE(upper * upper, truth.distance_sq);
    EXPECT_LE(found.lower, found.distance);
    EXPECT_LE(found.distance, found.upper);
    if (found.verdict == Verdict::undecided) {
      ++counts.undecided;
      continue;
    }
    EXPECT_EQ(truth.verdict == Verdict::separated, found.verdict == Verdict::separated);
    ++(found.verdict == Verdict::separated ? counts.separated : counts.zero);
  }
  return counts;
}

TEST(Certificate, EnclosesTheExactDistanceInEveryFamily) {
  gjk::Options towards_origin;
  towards_origin.direction_rule = gjk::DirectionRule::towards_origin;
  gjk::Options early;
  early.iteration_cap = 2;
  std::uint64_t seed = 40;
  CertificateCounts all;
  const auto add = [&](const CertificateCounts& counts) {
    all.separated += counts.separated;
    all.zero += counts.zero;
    all.undecided += counts.undecided;
  };
  constexpr int kPairs = 320;  // times 2 scalars, 3 options, 11 families: 21,120 queries
  for (int family = 0; family < kFamilyCount; ++family) {
    for (const gjk::Options& options : {gjk::Options{}, towards_origin, early}) {
      const auto kind = static_cast<Family>(family);
      add(check_certificates<float>(kind, kPairs, ++seed, options));
      add(check_certificates<double>(kind, kPairs, ++seed, options));
    }
  }
  EXPECT_GT(all.separated, 10000);
  EXPECT_GT(all.zero, 2000);
  EXPECT_GT(all.undecided, 1000);
}

}  // namespace
}  // namespace gjkscope
