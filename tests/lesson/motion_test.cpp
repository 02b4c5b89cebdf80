// Shapes that move and turn along a clock, and runs that start from the last one's end.

#include <gtest/gtest.h>

#include "lesson/load.hpp"
#include "lesson_texts.hpp"
#include "run/run.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace motion_test {

using Eigen::Vector3d;

const std::string kMotion = R"(title = "Two squares"
chapter = 4
order = 6
prose = "Y comes by."

[shapes.X]
names = ["A", "B", "C", "D"]
vertices = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
rotate = 10

[shapes.Y]
names = ["K", "L", "M"]
vertices = [[-1, -0.5], [1, -0.5], [0, 1]]

[query]
warm = true
start = ["K-A"]

[steps]
tour = "answer"

[path]
points = [[0, 0], [0, 1]]
frames = 9
seconds = 4

[path.Y]
points = [[5, 0], [5, 0], [3, 2]]
turns = [0, 90, -30]

[[views]]
show = "world"

[expect]
stop = "repeated-support"
)";

std::string edited(const std::string& from, const std::string& to) {
  std::string text = kMotion;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

LoadedLesson parse(const std::string& text) {
  return parse_lesson(text, "motion.toml", vocabulary());
}

Lesson motion() {
  const LoadedLesson loaded = parse(kMotion);
  for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
  return loaded.lesson.value_or(Lesson{});
}

TEST(Motion, ReachesTheLesson) {
  const Lesson lesson = motion();
  ASSERT_TRUE(lesson.path_of_shapes);
  const LessonPath& path = *lesson.path_of_shapes;
  EXPECT_EQ(path.seconds, 4.0);
  EXPECT_EQ(path.frames, 9);
  EXPECT_EQ(path.x().points.size(), 2u);
  EXPECT_TRUE(path.x().turns.empty());
  EXPECT_EQ(path.y().points[2], Vector3d(3, 2, 0));
  EXPECT_EQ(path.y().turns, (std::vector<double>{0.0, 90.0, -30.0}));
  EXPECT_TRUE(lesson.warm_start);
}

TEST(Motion, CornersComeAtEqualTimesAndFramesAtEqualStepsOfTime) {
  const LessonRun run = run_lesson(motion());
  ASSERT_EQ(run.runs.size(), 9u);
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(run.runs[i].time, 0.5 * i);
    EXPECT_EQ(run.runs[i].x().placement.translate, Vector3d(0.0, i / 8.0, 0));
    EXPECT_EQ(run.runs[i].x().placement.rotate_degrees, 10.0) << "X moves and keeps its turn";
  }
  // Halfway to the second corner Y has only turned: a leg of no length takes its time, too.
  EXPECT_EQ(run.runs[2].y().placement.translate, Vector3d(5, 0, 0));
  EXPECT_EQ(run.runs[2].y().placement.rotate_degrees, 45.0);
  EXPECT_EQ(run.runs[4].y().placement.rotate_degrees, 90.0);
  EXPECT_EQ(run.runs[6].y().placement.translate, Vector3d(4, 1, 0));
  EXPECT_EQ(run.runs[6].y().placement.rotate_degrees, 30.0);
  // K = (-1, -0.5), turned by 90 degrees and moved to (5, 0).
  EXPECT_LT((in_plane(run.runs[4].y().world[0]) - Eigen::Vector2d(5.5, -1.0)).norm(), 1e-15);
  EXPECT_EQ(run.runs[8].y().placement.translate, Vector3d(3, 2, 0));
  EXPECT_EQ(run.frames.size(), 9u);
}

TEST(Motion, IsTheSameEveryTime) {
  const LessonRun first = run_lesson(motion());
  const LessonRun second = run_lesson(motion());
  for (std::size_t i = 0; i < first.runs.size(); ++i) {
    EXPECT_EQ(first.runs[i].y().world, second.runs[i].y().world);
    EXPECT_EQ(first.runs[i].trace.result.distance, second.runs[i].trace.result.distance);
  }
}

TEST(WarmStart, StartsEachRunFromTheSimplexThatTheLastEndedWith) {
  const LessonRun run = run_lesson(motion());
  EXPECT_EQ(run.runs[0].trace.initial.simplex.count, 1) << "the first starts as the lesson says";
  int saved = 0;
  for (int i = 1; i < static_cast<int>(run.runs.size()); ++i) {
    const WideSimplex& last = run.runs[i - 1].trace.result.simplex;
    const WideSimplex& start = run.runs[i].trace.initial.simplex;
    ASSERT_EQ(start.count, last.count);
    for (int k = 0; k < start.count; ++k) EXPECT_EQ(start.vertices[k].pair, last.vertices[k].pair);
    const PositionedRun cold = run_afresh(run, i);
    EXPECT_EQ(cold.trace.initial.simplex.count, 1);
    EXPECT_EQ(cold.x().world, run.runs[i].x().world);
    EXPECT_EQ(cold.y().world, run.runs[i].y().world);
    EXPECT_NEAR(cold.trace.result.distance, run.runs[i].trace.result.distance, 1e-14);
    saved += support_calls(cold.trace) - support_calls(run.runs[i].trace);
  }
  EXPECT_GE(saved, 8) << "a slow motion is what warm starts are for";
}

TEST(Motion, WhatDoesNotFitTogetherIsRefusedAtItsPlace) {
  const struct {
    std::string from;
    std::string to;
    std::string what;
  } cases[] = {
      {"seconds = 4\n", "", "'Y' without a clock"},
      {"frames = 9\n", "", "a clock without 'frames'"},
      {"turns = [0, 90, -30]", "turns = [0, 90]", "2 turns for 3 points"},
      {"turns = [0, 90, -30]", "turns = [0, 90, 361]", "entry 3 of 'turns' is 361"},
      {"seconds = 4", "seconds = 0", "'seconds' is 0"},
      {"frames = 9", "frames = 9\nturns = [0, 1]", "'rotate' of X besides turns"},
      {"vertices = [[-1, -0.5], [1, -0.5], [0, 1]]",
       "vertices = [[-1, -0.5], [1, -0.5], [0, 1]]\ntranslate = [1, 0]",
       "'translate' of Y besides a path"},
      {"warm = true", "warm = 1", "'warm' is a number"},
      {"tour = \"answer\"", "tour = \"answer\"\nuntil = \"stop\"", "'until' with tour 'answer'"},
      {"tour = \"answer\"", "tour = \"answer\"\nphases = [\"stop\"]",
       "'phases' with tour 'answer'"},
      {"points = [[5, 0], [5, 0], [3, 2]]\n", "", "missing key 'points'"},
  };
  for (const auto& [from, to, what] : cases) {
    const LoadedLesson loaded = parse(edited(from, to));
    EXPECT_FALSE(loaded.lesson) << what;
    bool found = false;
    for (const Problem& problem : loaded.problems) {
      found = found || problem.what == what;
      EXPECT_GT(problem.line, 1) << to_string(problem);
    }
    EXPECT_TRUE(found) << what;
  }
}

TEST(Motion, APathNeedsAShapeThatMoves) {
  std::string text = edited("points = [[0, 0], [0, 1]]\n", "");
  EXPECT_TRUE(parse(text).lesson) << "Y moves";
  text = text.substr(0, text.find("[path.Y]")) + text.substr(text.find("[[views]]"));
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 1u);
  EXPECT_EQ(loaded.problems[0].what, "a path without a shape that moves");
}

TEST(WarmStart, NeedsAPath) {
  std::string text = kMotion.substr(0, kMotion.find("[path]"));
  text += kMotion.substr(kMotion.find("[[views]]"));
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 1u);
  EXPECT_EQ(to_string(loaded.problems[0]).substr(0, 48),
            "motion.toml:16:8: a warm start without a path; e");
}

TEST(Tour, AnswerWitnessAndSupportMakeTheirFrames) {
  Lesson lesson = motion();
  lesson.tour = "witness";
  EXPECT_EQ(run_lesson(lesson).frames.size(), 4u * 9u);
  lesson.tour = "support";
  const LessonRun run = run_lesson(lesson);
  int calls = 0;
  for (const PositionedRun& positioned : run.runs) calls += support_calls(positioned.trace);
  EXPECT_EQ(static_cast<int>(run.frames.size()), 4 * calls);
  for (const Frame& frame : run.frames) EXPECT_EQ(run.step(frame).phase, gjk::Phase::support);
}

TEST(Tour, PhasesPicksThoseThatGetAFrame) {
  Lesson lesson = motion();
  lesson.tour = "phase";
  lesson.phases = {gjk::Phase::support, gjk::Phase::stop};
  const LessonRun run = run_lesson(lesson);
  for (const Frame& frame : run.frames) {
    if (frame.step < 0) continue;
    const gjk::Phase phase = run.step(frame).phase;
    EXPECT_TRUE(phase == gjk::Phase::support || phase == gjk::Phase::stop);
  }
}

}  // namespace motion_test
}  // namespace gjkscope
