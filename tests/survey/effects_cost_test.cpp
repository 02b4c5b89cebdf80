#include "survey/effects_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "run/effect_info.hpp"
#include "run/graph.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace effects_cost_test {

const Fonts& fonts() {
  static const Fonts loaded(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  return loaded;
}

const LessonRun& lesson() {
  static const LessonRun run = run_lesson(testing::shipped_lesson("minkowski-distance"));
  return run;
}

const std::vector<EffectCost>& costs() {
  static const std::vector<EffectCost> rows = effects_cost(lesson(), fonts(), 0.2);
  return rows;
}

TEST(EffectsCost, HasALineForEachEffectThatIsCalledFor) {
  EffectGraph effects(lesson());
  static_cast<void>(lesson_pictures(lesson(), effects, fonts()));
  std::set<std::string> called;
  for (const EffectInfo* info : registered_effects()) {
    if (effects.count(info->name).pulls > 0) called.insert(std::string(info->name));
  }
  ASSERT_FALSE(called.empty());
  ASSERT_EQ(costs().size(), called.size() + 1);
  for (std::size_t i = 0; i + 1 < costs().size(); ++i) {
    const EffectCost& row = costs()[i];
    EXPECT_EQ(called.erase(row.effect), 1u) << row.effect;
    EXPECT_EQ(row.pulls, effects.count(row.effect).pulls);
    EXPECT_EQ(row.runs, effects.count(row.effect).runs);
    EXPECT_EQ(row.lesson, "minkowski-distance");
    EXPECT_EQ(row.frames, static_cast<int>(lesson().frames.size()));
  }
}

TEST(EffectsCost, WithoutAnEffectNothingAsksForIt) {
  int timed = 0;
  for (const EffectCost& row : costs()) {
    EXPECT_EQ(row.pulls_off > 0, row.ratio.median == 0.0) << row.effect;
    if (row.effect.empty() || row.pulls_off > 0) continue;
    EXPECT_FALSE(row.off.empty()) << row.effect;
    EXPECT_GT(row.pulls, 0) << row.effect;
    ++timed;
  }
  EXPECT_GT(timed, 0);
}

TEST(EffectsCost, TheLastRowIsTheLessonAgainstItself) {
  const EffectCost& row = costs().back();
  EXPECT_EQ(row.effect, "");
  EXPECT_EQ(row.pulls, 0);
  EXPECT_GE(row.repetitions, 5);
  EXPECT_GT(row.ratio.low, 0.0);
  EXPECT_LE(row.ratio.low, row.ratio.median);
  EXPECT_LE(row.ratio.median, row.ratio.high);
}

TEST(EffectsCost, InterruptedHasNothing) {
  EXPECT_TRUE(effects_cost(lesson(), fonts(), 1.5, [] { return false; }).empty());
}

TEST(EffectsCost, EachRowIsALineOfTheFileAndOfTheTable) {
  const std::string csv = effects_csv(costs());
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), costs().size() + 1);
  EXPECT_EQ(std::count(csv.begin(), csv.begin() + static_cast<long>(csv.find('\n')), ','), 17);
  const std::string table = effects_table(costs());
  for (const EffectCost& row : costs()) {
    EXPECT_NE(table.find(row.effect), std::string::npos);
  }
  EXPECT_NE(table.find("(all others)"), std::string::npos);
  EXPECT_EQ(effects_table({}), "Nothing was measured.\n");
}

}  // namespace effects_cost_test
}  // namespace gjkscope
