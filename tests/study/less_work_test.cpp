// The rule by which one configuration does part of another's work, on made-up counts and times.

#include "study/less_work.hpp"

#include <gtest/gtest.h>

namespace gjkscope::study {
namespace less_work_test {

constexpr Work kWork = {3.5, 4.0, 1.0, 0.0};
constexpr Work kFewer = {2.5, 3.0, 1.0, 0.0};

Contender contender(const Configuration& configuration, const Work& work = kWork) {
  return {configuration, work};
}

Configuration with(auto change) {
  Configuration out;
  change(out);
  return out;
}

bool less(const Configuration& a, const Configuration& b) {
  return does_less(contender(a), contender(b), false);
}

/// Holds one way round, and not the other.
void expect_less(const Configuration& a, const Configuration& b) {
  EXPECT_TRUE(less(a, b)) << name_of(a) << " does less than " << name_of(b);
  EXPECT_FALSE(less(b, a)) << name_of(b) << " does less than " << name_of(a);
}

void expect_unrelated(const Configuration& a, const Configuration& b) {
  EXPECT_FALSE(less(a, b)) << name_of(a) << " does less than " << name_of(b);
  EXPECT_FALSE(less(b, a)) << name_of(b) << " does less than " << name_of(a);
}

const Configuration kDefault;
const Configuration kCap3 = with([](Configuration& c) { c.options.iteration_cap = 3; });
const Configuration kCap5 = with([](Configuration& c) { c.options.iteration_cap = 5; });
const Configuration kTight = with([](Configuration& c) { c.options.tolerance = 1e-6; });
const Configuration kLoose = with([](Configuration& c) { c.options.tolerance = 1e-2; });
const Configuration kOneStop =
    with([](Configuration& c) { c.options.stop_on_no_progress = false; });
const Configuration kWarm = with([](Configuration& c) { c.start = Start::warm; });
const Configuration kFirst = with([](Configuration& c) { c.start = Start::first_vertices; });
const Configuration kLoop = configuration(Arithmetic::double_, gjk::Proof::none);
const Configuration kBounds = configuration(Arithmetic::double_, gjk::Proof::bounds);

TEST(LessWork, IsWhatEachSettingLeavesOut) {
  expect_less(kLoop, kBounds);
  expect_less(kBounds, kDefault);
  expect_less(kLoop, kDefault);
  expect_less(kCap3, kDefault);
  expect_less(kCap3, kCap5);
  expect_less(kTight, kDefault);
  expect_less(kLoose, kTight);
  expect_less(kOneStop, kDefault);
  EXPECT_FALSE(less(kDefault, kDefault)) << "the same work is not less";
}

TEST(LessWork, HoldsForSeveralSettingsAtOnceIfNoneAsksForMore) {
  Configuration capped_loop = kLoop;
  capped_loop.options.iteration_cap = 3;
  expect_less(capped_loop, kDefault);
  expect_less(capped_loop, kLoop);
  expect_less(capped_loop, kCap3);
  expect_unrelated(kLoop, kCap3);
  expect_unrelated(kCap3, kLoose);
}

TEST(LessWork, IsNotComparedAcrossArithmeticRulesAndStarts) {
  expect_unrelated(configuration(Arithmetic::single, gjk::Proof::none), kDefault);
  expect_unrelated(with([](Configuration& c) {
                     c.options.direction_rule = gjk::DirectionRule::towards_origin;
                     c.options.proof = gjk::Proof::none;
                   }),
                   kDefault);
  expect_unrelated(with([](Configuration& c) {
                     c.options.region_order = gjk::RegionOrder::edges_first;
                     c.options.iteration_cap = 3;
                   }),
                   kDefault);
  expect_unrelated(kFirst, kDefault);
}

TEST(LessWork, NeedsNoMoreIterationsAndSupportQueries) {
  EXPECT_TRUE(does_less(contender(kOneStop, kFewer), contender(kDefault), false));
  EXPECT_FALSE(does_less(contender(kOneStop, kWork), contender(kDefault, kFewer), false));
  Work more_queries = kFewer;
  more_queries.support_queries = 4.5;
  EXPECT_FALSE(does_less(contender(kCap3, more_queries), contender(kDefault), false));
}

TEST(LessWork, OfAWarmStartNeedsMotionAndFewerIterations) {
  EXPECT_TRUE(does_less(contender(kWarm, kFewer), contender(kDefault), true));
  EXPECT_TRUE(does_less(contender(kWarm, kFewer), contender(kFirst), true));
  EXPECT_FALSE(does_less(contender(kWarm, kFewer), contender(kDefault), false));
  EXPECT_FALSE(does_less(contender(kWarm), contender(kDefault), true)) << "as many iterations";
  EXPECT_FALSE(does_less(contender(kDefault, kFewer), contender(kWarm), true));
}

TEST(LessWork, ReasonsAreWhatWasCounted) {
  const auto reason = [](Contender a, Contender b) { return reason_for(a, b); };
  EXPECT_EQ(reason(contender(kTight, {3.25, 4.0, 1.0, 0.0}), contender(kDefault)),
            "the tolerance is one more stop test in each of 3.25 iterations, and saves 0.25 "
            "iterations");
  EXPECT_EQ(
      reason(contender(kCap3, {2.5, 3.0, 1.0, 0.5}), contender(kDefault, {3.5, 4.0, 1.0, 0.25})),
      "exact arithmetic settles 50 % of its answers, 25 % of the other's");
  EXPECT_EQ(reason(contender(kWarm, {1.5, 1.5, 1.75, 0.0}), contender(kDefault)),
            "its first simplex has 1.75 vertices, the other's 1.00");
  EXPECT_EQ(reason(contender(kLoop, {3.5, 4.0, 1.0, 0.0, 120.0}),
                   contender(kDefault, {3.5, 4.0, 1.0, 0.0, 100.0})),
            "it takes 120 instructions, the other 100");
  EXPECT_EQ(reason(contender(kLoop, {3.5, 4.0, 1.0, 0.0, 90.0}),
                   contender(kDefault, {3.5, 4.0, 1.0, 0.0, 100.0})),
            "no count explains it: 3.50 against 3.50 iterations, 90 against 100 instructions");
  EXPECT_EQ(reason(contender(kCap3, kFewer), contender(kDefault)),
            "no count explains it: 2.50 against 3.50 iterations");
}

/// Times of the default are 100; those of the loop alone `loop`, those of cap 3 `capped`.
Study compared(const std::vector<double>& loop, const std::vector<double>& capped,
               const std::string& family = "random") {
  Study study;
  const Timing of_default{0.0, std::vector<double>(loop.size(), 100.0)};
  compare_work({contender(kDefault), contender(kLoop), contender(kCap3, kFewer)},
               {of_default, {0.0, loop}, {0.0, capped}}, {family, "", {}}, study);
  return study;
}

TEST(Costlier, IsListedIfThreeQuartersOfTheRepetitionsSaySo) {
  const std::vector<double> faster(5, 90.0);
  const Study none = compared(faster, faster);
  EXPECT_EQ(none.compared, 2);
  EXPECT_TRUE(none.costlier.empty());
  // The lower quartile is that of the second smallest.
  EXPECT_TRUE(compared({90.0, 105.0, 120.0, 120.0, 120.0}, faster).costlier.empty());
  const Study one = compared({90.0, 106.0, 120.0, 130.0, 140.0}, faster);
  ASSERT_EQ(one.costlier.size(), 1u);
  EXPECT_EQ(one.costlier[0].less, "double, loop only");
  EXPECT_EQ(one.costlier[0].more, "double");
  EXPECT_EQ(one.costlier[0].family, "random");
  EXPECT_DOUBLE_EQ(one.costlier[0].ratio.low, 1.06);
  EXPECT_DOUBLE_EQ(one.costlier[0].ratio.median, 1.2);
}

TEST(Costlier, PairsOfAllFamiliesAreToldTogetherTheLargestFirst) {
  Study study = compared(std::vector<double>(4, 110.0), std::vector<double>(4, 130.0), "a");
  const Study other = compared(std::vector<double>(4, 140.0), std::vector<double>(4, 90.0), "b");
  study.costlier.insert(study.costlier.end(), other.costlier.begin(), other.costlier.end());
  const std::vector<CostlierPair> pairs = costlier_pairs(study);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].less, "double, loop only");
  EXPECT_EQ(pairs[0].families, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(ratios_text(pairs[0]), "1.10 to 1.40");
  EXPECT_EQ(ratios_text(pairs[1]), "1.30");
}

TEST(Costlier, TheReportSaysSoIfThereIsNone) {
  Study study = compared({90.0}, {80.0});
  EXPECT_NE(costlier_about(study).find("That gave 2 comparisons."), std::string::npos);
  EXPECT_TRUE(costlier_about(study).ends_with("None does.")) << costlier_about(study);
  study = compared({110.0}, {80.0});
  EXPECT_TRUE(costlier_about(study).ends_with("One pair does:")) << costlier_about(study);
  study = compared({110.0}, {120.0});
  EXPECT_TRUE(costlier_about(study).ends_with("2 pairs do:")) << costlier_about(study);
}

TEST(Costlier, CoversCapsTolerancesProofLevelsAndWarmStarts) {
  // Everything takes as many iterations, a warm start fewer: then the rule alone decides.
  std::vector<Contender> all;
  for (const Configuration& each : configurations(false))
    all.push_back(contender(each, each.start == Start::warm ? kFewer : kWork));
  const auto is_less = [&](std::string_view a, std::string_view b) {
    const auto named = [&](std::string_view name) -> const Contender& {
      for (const Contender& each : all) {
        if (name_of(each.configuration) == name) return each;
      }
      ADD_FAILURE() << "no configuration " << name;
      return all.front();
    };
    return does_less(named(a), named(b), true);
  };
  for (const char* name : {"double, cap 1", "double, cap 20", "double, tolerance 1e-01",
                           "double, tolerance 1e-15", "double, loop only", "double, bounds only",
                           "double, warm start", "double, stop: no progress"}) {
    EXPECT_TRUE(is_less(name, "double")) << name;
  }
  EXPECT_TRUE(is_less("double, loop only, warm start", "double, loop only"));
  EXPECT_TRUE(is_less("float, loop only", "float"));
  EXPECT_TRUE(is_less("quad, loop only", "quad, bounds only"));
  EXPECT_FALSE(is_less("float, loop only", "double"));
  EXPECT_FALSE(is_less("double, loop only, towards O", "double"));
}

}  // namespace less_work_test
}  // namespace gjkscope::study
