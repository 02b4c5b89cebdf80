#include "subjects/growth/growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gjk/gjk.hpp"
#include "lessons.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace growth_test {

using Eigen::Vector2d;

const Growth::Value& measured_growth() {
  static const LessonRun run = run_lesson(testing::shipped_lesson("lazy-hull"));
  static EffectGraph graph(run);
  return graph.get<Growth>(run.frames.front());
}

/// The lesson with few small polygons.
Lesson small_lesson() {
  Lesson lesson = testing::shipped_lesson("lazy-hull");
  lesson.settings.edit<LessonGrowth>().vertices = {3, 10, 100};
  lesson.settings.edit<LessonGrowth>().runs = 20;
  return lesson;
}

Growth::Value growth_of(const Lesson& lesson) {
  const LessonRun run = run_lesson(lesson);
  EffectGraph graph(run);
  return graph.get<Growth>(run.frames.front());
}

TEST(Growth, GoesFromTrianglesToAMillionVertices) {
  const LessonGrowth growth = *testing::shipped_lesson("lazy-hull").settings.as<LessonGrowth>();
  ASSERT_EQ(measured_growth().size(), growth.vertices.size());
  EXPECT_EQ(measured_growth().front().vertices, 3);
  EXPECT_EQ(measured_growth().back().vertices, 1'000'000);
  for (std::size_t i = 0; i < growth.vertices.size(); ++i) {
    EXPECT_EQ(measured_growth()[i].vertices, growth.vertices[i]);
    EXPECT_EQ(measured_growth()[i].runs, growth.runs);
  }
}

TEST(Growth, SmallPolygonsAreScannedAndLargeOnesClimbed) {
  for (const Growth::Sample& sample : measured_growth()) {
    SCOPED_TRACE(sample.vertices);
    EXPECT_EQ(sample.is_climbed, sample.vertices >= 32);
    EXPECT_NEAR(sample.scanned_vertices, 2.0 * sample.vertices * sample.support_calls,
                1e-9 * sample.scanned_vertices);
    if (!sample.is_climbed) {
      EXPECT_EQ(sample.seen_vertices, sample.scanned_vertices);
    } else {
      // A climb looks at about two roots of n: the samples, and the way between two of them.
      const double roots = 2.0 * std::sqrt(sample.vertices) * sample.support_calls;
      EXPECT_LT(sample.seen_vertices, std::min(sample.scanned_vertices, 2.5 * roots));
      EXPECT_GT(sample.seen_vertices, 0.5 * roots);
    }
  }
}

/// Corners of one polygon in an order that is no ring, so that they are scanned.
std::vector<Vector2d> shuffled(std::vector<Vector2d> corners) {
  std::swap(corners[0], corners[corners.size() / 2]);
  return corners;
}

TEST(Growth, AScanLooksAtEveryVertexAndFindsWhatAClimbFinds) {
  constexpr int kCount = 500;
  std::vector<Vector2d> x;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2.0 * 3.14159265358979 * (i + 0.3 * std::sin(7.0 * i)) / kCount;
    x.emplace_back(std::cos(angle), 0.6 * std::sin(angle));
  }
  const std::vector<Vector2d> mixed = shuffled(x);
  gjk::Query<double, 2> climbed{{x}, {x}};
  gjk::Query<double, 2> scanned{{mixed}, {mixed}};
  ASSERT_TRUE((gjk::Measures<double, 2>(x).is_ring));
  ASSERT_FALSE((gjk::Measures<double, 2>(mixed).is_ring));
  for (auto* query : {&climbed, &scanned}) query->y.pose.translation = Vector2d(2.5, 1.5);
  const auto by_climb = gjk::trace(climbed, {});
  const auto by_scan = gjk::trace(scanned, {});
  ASSERT_EQ(by_climb.steps.size(), by_scan.steps.size());
  for (std::size_t i = 0; i < by_scan.steps.size(); ++i) {
    if (by_scan.steps[i].phase != gjk::Phase::support) continue;
    EXPECT_EQ(by_scan.steps[i].after.support.w, by_climb.steps[i].after.support.w);
    EXPECT_EQ(by_scan.steps[i].record.scan_x.size(), static_cast<std::size_t>(kCount));
    EXPECT_LT(by_climb.steps[i].record.scan_x.size(), static_cast<std::size_t>(kCount) / 4);
  }
}

TEST(Growth, IterationsGrowWithTheLogarithmAndEachMakesOnePoint) {
  for (const Growth::Sample& sample : measured_growth()) {
    SCOPED_TRACE(sample.vertices);
    EXPECT_GE(sample.iterations, 2.0);
    EXPECT_LE(sample.iterations, 3.0 + 2.5 * std::log10(sample.vertices));
    EXPECT_GE(sample.iterations, 1.5 * std::log10(sample.vertices));
    EXPECT_GE(sample.most_iterations, sample.iterations);
    EXPECT_LE(sample.support_calls, sample.iterations);
    EXPECT_GT(sample.touched_points, 1.0);
    EXPECT_LE(sample.touched_points, sample.support_calls + 1.0);
  }
}

TEST(Growth, WithinATenthOfAPercentIterationsDoNotGrow) {
  ASSERT_EQ(testing::shipped_lesson("lazy-hull").settings.as<LessonGrowth>()->tolerance, 0.001);
  for (const Growth::Sample& sample : measured_growth()) {
    SCOPED_TRACE(sample.vertices);
    EXPECT_LE(sample.within_tolerance, std::min(Growth::kLarsenMost + 0.0, sample.iterations));
    if (sample.vertices >= 100) {
      EXPECT_NEAR(sample.within_tolerance, 5.2, 0.7);
    }
  }
}

TEST(Growth, WithinToleranceIsWhereARunWithThatToleranceStops) {
  Lesson lesson = small_lesson();
  lesson.settings.edit<LessonGrowth>().tolerance = 0.01;
  const Growth::Value counted = growth_of(lesson);
  lesson.options.tolerance = 0.01;
  const Growth::Value stopped = growth_of(lesson);
  for (std::size_t i = 0; i < counted.size(); ++i)
    EXPECT_NEAR(counted[i].within_tolerance, stopped[i].iterations, 1e-12);
}

TEST(Growth, FollowsTheLessonsQueryAndSeed) {
  Lesson lesson = small_lesson();
  const Growth::Value before = growth_of(lesson);
  EXPECT_EQ(growth_of(lesson).back().seen_vertices, before.back().seen_vertices);
  ++lesson.settings.edit<LessonGrowth>().seed;
  EXPECT_NE(growth_of(lesson).back().seen_vertices, before.back().seen_vertices);
  --lesson.settings.edit<LessonGrowth>().seed;
  lesson.options.start.count = 0;  // center to center saves an iteration or two
  EXPECT_LT(growth_of(lesson).back().iterations, before.back().iterations - 0.5);
}

TEST(Growth, IsMeasuredOnceAndOnlyWhenAsked) {
  const LessonRun run = run_lesson(small_lesson());
  EffectGraph graph(run);
  EXPECT_EQ(graph.count(Growth::kName).runs, 0);
  EXPECT_EQ(graph.get<Growth>(run.frames.front()).size(), 3u);
  (void)graph.get<Growth>(run.frames.back());
  EXPECT_EQ(graph.count(Growth::kName).runs, 1);
}

TEST(Growth, FramesAreTheSupportStepsThenTheSizesTheOutcomeAndSlowRuns) {
  Lesson lesson = small_lesson();
  lesson.questions.clear();
  const LessonRun run = run_lesson(lesson);
  const auto& steps = run.runs[0].trace.steps;
  const int last = static_cast<int>(steps.size()) - 1;
  const auto sizes = std::find_if(run.frames.begin(), run.frames.end(), [&](const Frame& frame) {
    return shown_size(run, frame).has_value();
  });
  ASSERT_EQ(run.frames.end() - sizes, 5);
  EXPECT_EQ(sizes - run.frames.begin(), support_calls(run.runs[0].trace) + 2);
  EXPECT_EQ(run.frames.front().step, -1);
  EXPECT_EQ((sizes - 1)->step, last);
  for (auto frame = run.frames.begin() + 1; frame != sizes - 1; ++frame)
    EXPECT_EQ(steps[frame->step].phase, gjk::Phase::support);
  for (auto frame = sizes; frame != run.frames.end(); ++frame) EXPECT_EQ(frame->step, last);
}

}  // namespace growth_test
}  // namespace gjkscope
