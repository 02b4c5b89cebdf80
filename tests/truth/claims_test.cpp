// Claims of runs, held to the exact truth: in every scalar, whatever the options, and in rationals
// all that runs say. truth-sweep does the same for the default options and more pairs.

#include <gtest/gtest.h>

#include "bars.hpp"
#include "exact_run.hpp"
#include "study/families.hpp"

namespace gjkscope::study {
namespace claims_test {

using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using gjk::Verdict;
using Pair = families::Pair<double>;

constexpr std::uint64_t kSeed = 31;

struct Asked {
  const char* name;
  gjk::Options options;
  bool decides = true;  ///< Verdicts are never left open, where exact arithmetic can run on.
};
std::vector<Asked> ways_to_ask() {
  std::vector<Asked> out;
  const auto add = [&](const char* name, bool decides, auto change) {
    out.push_back({name, {}, decides});
    change(out.back().options);
  };
  add("default", true, [](gjk::Options&) {});
  add("bounds alone", false, [](auto& o) { o.proof = gjk::Proof::bounds; });
  add("towards O", true, [](auto& o) { o.direction_rule = gjk::DirectionRule::towards_origin; });
  add("edges first", true, [](auto& o) { o.region_order = gjk::RegionOrder::edges_first; });
  add("unchecked", true, [](auto& o) { o.region_order = gjk::RegionOrder::unchecked; });
  add("first vertices", true, [](auto& o) { o.start.count = 1; });
  add("tolerance", true, [](auto& o) { o.tolerance = 0.05; });
  add("never repeats", true, [](auto& o) { o.stop_on_repeated_support = false; });
  for (const int cap : {1, 2, 3}) add("cap", false, [&](auto& o) { o.iteration_cap = cap; });
  return out;
}

struct Tally {
  long asked = 0;
  long undecided = 0;
};

/// Pairs of each family, rounded to S, asked about in S.
template <class S>
Tally ask(const Asked& how, int pairs) {
  constexpr bool kCanSettle = std::numeric_limits<S>::digits <= 53;
  Tally out;
  families::Source random(kSeed);
  for (int i = 0; i < pairs * kFamilyCount; ++i) {
    const int family = i % kFamilyCount;
    const auto pair = families::converted<S>(random.pair<double>(static_cast<Family>(family)));
    const auto result = gjk::distance<S>(pair.query(), how.options);
    if (result.error != gjk::Error::none) continue;  // denormals; in half, what is large or small
    const Truth truth = truth_of(families::converted<double>(pair), result.warm());
    const Judgement found = judge(claim_of(result), {truth, truth});
    const bool open = how.decides && kCanSettle && found.undecided;
    ++out.asked;
    out.undecided += found.undecided;
    EXPECT_FALSE(found.failed || found.wrong || found.wrong_contact || found.broken_bounds || open)
        << how.name << ", seed " << kSeed << " pair " << i << ' ' << kFamilyNames[family]
        << " digits " << std::numeric_limits<S>::digits << "\nverdict "
        << static_cast<int>(result.verdict) << ", exact " << truth.distance << ", found "
        << double(result.distance) << " in [" << double(result.lower) << ", "
        << double(result.upper) << ']';
    if (::testing::Test::HasFailure()) break;
  }
  return out;
}

TEST(Claims, HoldWhateverTheScalarAndTheOptions) {
  for (const Asked& how : ways_to_ask()) {
    const Tally tallies[] = {ask<Eigen::half>(how, 100), ask<float>(how, 300),
                             ask<double>(how, 300), ask<long double>(how, 100)};
    for (const Tally& tally : tallies) {
      EXPECT_GT(tally.asked, 1900) << how.name;
      EXPECT_GE(tally.undecided, how.decides ? 0 : tally.asked / 8) << how.name;
    }
  }
}

/// At most: pairs in percent that exact arithmetic settles, and the mean width of the other bounds,
/// in u * scale; a little more than was measured.
struct Shares {
  double settled;
  double width;
};
constexpr std::array<Shares, kFamilyCount> kMost = {{
    {0.2, 4.93},    // random
    {0.1, 7.37},    // points
    {19.0, 6.92},   // collinear
    {0.1, 4.53},    // clouds
    {0.3, 7.21},    // duplicates
    {12.1, 5.12},   // grid
    {66.0, 0.02},   // identical
    {0.4, 0.5},     // inside
    {0.1, 7.2},     // posed
    {0.1, 6.55},    // needle
    {0.5, 3.95},    // needle-polygon
    {23.2, 3.84},   // parallel
    {26.3, 0.48},   // gap
    {111.2, 0.23},  // speck
    {30.5, 0.29},   // shallow
    {113.7, 0.02},  // touching
    {85.0, 0.02},   // grazing
    {1.0, 5.82},    // tiny
    {0.9, 5.81},    // huge
    {60.9, 0.04},   // ratio
    {1.1, 6.27},    // offset
    {4.6, 5.8},     // denormals
}};

TEST(Claims, AreSeldomSettledAndTheirBoundsAreClose) {
  constexpr int kPairs = 4000;
  for (std::size_t family = 0; family < kFamilyCount; ++family) {
    families::Source random(kSeed);
    Shares found = {};
    for (int i = 0; i < kPairs; ++i) {
      const auto pair = random.pair<float>(static_cast<Family>(family));
      const auto result = gjk::distance<float>(pair.query());
      const double unit = std::max<double>(0x1p-24 * families::scale_of(pair),
                                           std::numeric_limits<float>::denorm_min());
      found.settled += result.settled ? 100.0 / kPairs : 0.0;
      if (result.error != gjk::Error::none || result.settled) continue;
      found.width += (double{result.upper} - double{result.lower}) / unit / kPairs;
    }
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << ' ' << kFamilyNames[family]);
    EXPECT_LE(found.settled, kMost[family].settled);
    EXPECT_LE(found.width, kMost[family].width);
  }
}

TEST(RunsInRationals, ProveWhatTheySay) {
  gjk::Options short_of_breath;
  short_of_breath.iteration_cap = 1;
  std::array<int, 3> verdicts = {};
  std::array<int, 4> cut_verdicts = {};
  families::Source random(kSeed);
  for (int i = 0; i < 200 * kFamilyCount; ++i) {
    const int family = i % 2 == 0 ? i / 2 % kFamilyCount : static_cast<int>(Family::grid);
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " pair " << i << kFamilyNames[family]);
    const Pair pair = random.pair<double>(static_cast<Family>(family));
    const Truth truth = truth_of(pair);
    const ExactPair<2> both = exact(pair);
    const auto result = gjk::distance(both.query());
    ASSERT_EQ(truth.touching  ? Verdict::touching
              : truth.overlap ? Verdict::overlapping
                              : Verdict::separated,
              result.verdict);
    ASSERT_EQ(root_nearest(result.distance_sq), result.distance);
    ASSERT_EQ(root_down(result.distance_sq), result.lower);
    ASSERT_EQ(root_up(result.distance_sq), result.upper);
    expect_proved(both, result);
    ++verdicts[static_cast<std::size_t>(result.verdict)];

    const auto cut = gjk::distance(both.query(), short_of_breath);
    ASSERT_TRUE(cut.verdict == result.verdict || cut.verdict == Verdict::undecided);
    ASSERT_LE(cut.lower, result.upper);
    ASSERT_GE(cut.upper, result.lower);
    ASSERT_TRUE(cut.verdict == Verdict::separated || cut.lower == 0);
    ++cut_verdicts[static_cast<std::size_t>(cut.verdict)];
  }
  for (const int count : verdicts) EXPECT_GT(count, 200);
  EXPECT_GT(cut_verdicts[static_cast<std::size_t>(Verdict::separated)], 200);
  EXPECT_GT(cut_verdicts[static_cast<std::size_t>(Verdict::undecided)], 200);
}

}  // namespace claims_test
}  // namespace gjkscope::study
