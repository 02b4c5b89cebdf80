#include "survey/time_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lessons.hpp"
#include "subjects/balance/balance.hpp"
#include "subjects/balance/table.hpp"

namespace gjkscope {
namespace time_steps_test {

const std::vector<TimeStepCost>& beams() {
  static const std::vector<TimeStepCost> rows =
      time_step_costs(testing::shipped_lesson("segment-balance"), 3);
  return rows;
}
const std::vector<TimeStepCost>& motions() {
  static const std::vector<TimeStepCost> rows =
      time_step_costs(testing::shipped_lesson("polygons-motion"), 3);
  return rows;
}

template <class Rows>
int shown(const Rows& rows) {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.is_shown; }));
}

TEST(TimeSteps, SmallerStepsOfABeamErrLess) {
  ASSERT_GT(beams().size(), 4u);
  EXPECT_EQ(shown(beams()), 1);
  for (std::size_t i = 1; i < beams().size(); ++i) {
    EXPECT_LT(beams()[i].step, beams()[i - 1].step);
    EXPECT_LT(beams()[i].error, beams()[i - 1].error);
    EXPECT_GT(beams()[i].error, 0.0);
  }
  for (const TimeStepCost& row : beams()) {
    EXPECT_GT(row.ns.median, 0.0);
    if (row.is_shown) {
      EXPECT_EQ(row.step, kBeamStep);
      EXPECT_LT(row.error, 0.02) << "a degree, which no frame shows";
    }
  }
}

TEST(TimeSteps, TheStepThatLessonsShowIsTheOneThatTheyAreSimulatedWith) {
  const LessonTime time{2.0, 5};
  const std::vector<Beam> a = swing({0.25, 0.75}, 0.75, time);
  const std::vector<Beam> b = swing({0.25, 0.75}, 0.75, time, 0, kBeamStep);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].angle, b[i].angle);
  EXPECT_NE(swing({0.25, 0.75}, 0.75, time, 0, 0x1p-6).back().angle, a.back().angle);
}

TEST(TimeSteps, AMotionStandsWhereItStandsWhateverTheStep) {
  ASSERT_GT(motions().size(), 4u);
  EXPECT_EQ(shown(motions()), 1);
  for (const TimeStepCost& row : motions()) {
    EXPECT_LE(row.error, 1e-14);
    EXPECT_LE(row.iterations, row.cold_iterations);
    EXPECT_GT(row.iterations, 0.0);
  }
  EXPECT_LE(motions().back().iterations, motions().front().iterations)
      << "smaller steps are better guesses";
}

TEST(TimeSteps, ALessonWithoutAClockHasNone) {
  EXPECT_TRUE(time_step_costs(testing::shipped_lesson("polygons-gjk"), 3).empty());
  EXPECT_TRUE(
      time_step_costs(testing::shipped_lesson("segment-balance"), 3, [] { return false; }).empty());
}

TEST(TimeSteps, EachRowIsALineOfTheFile) {
  const std::string csv = time_steps_csv(motions());
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            motions().size() + 1);
  EXPECT_NE(time_steps_table(beams()).find("\n* segment-balance"), std::string::npos);
  EXPECT_EQ(time_steps_table({}), "Nothing was measured: no lesson has a clock.\n");
}

}  // namespace time_steps_test
}  // namespace gjkscope
