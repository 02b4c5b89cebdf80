// Two runs beside each other: where they part, which answer is wrong, and by how much.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "mistakes/mistakes.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/subjects.hpp"
#include "subjects/two_runs/lesson_trace.hpp"
#include "subjects/two_runs/log_lesson.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace two_runs_test {

namespace fs = std::filesystem;

const fs::path kLessons = fs::path(GJKSCOPE_SOURCE_DIR) / "lessons";

LessonRun run_of(const LoadedLesson& loaded) {
  EXPECT_TRUE(loaded.lesson) << to_string(loaded.problems);
  return run_lesson(loaded.lesson.value());
}
const TwoRunsTrace& trace_of(const LessonRun& run) { return two_runs_of(run, run.frames.front()); }

std::vector<fs::path> lessons_of_mistakes() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(kLessons)) {
    if (entry.path().filename().string().starts_with("mistake-")) out.push_back(entry.path());
  }
  return out;
}

/// The loop of each lesson goes wrong, the judge says where, a frame asks, and its answer is the
/// judge's.
TEST(TwoRuns, EachLessonOfAMistakeNamesItsStep) {
  std::set<std::string> mistakes_shown;
  for (const fs::path& file : lessons_of_mistakes()) {
    SCOPED_TRACE(file.string());
    const LessonRun run = run_of(load_lesson(file, vocabulary()));
    const TwoRunsTrace& both = trace_of(run);
    EXPECT_TRUE(mistakes_shown.insert(run.lesson.settings.as<LessonSecond>()->mistake).second);
    ASSERT_TRUE(both.judgement && both.judgement->wrong);
    ASSERT_GE(both.parting, 0);
    EXPECT_EQ(both.shown[static_cast<std::size_t>(both.parting)].iteration,
              both.judgement->wrong->iteration);
    // The symptom is a wrong answer, or a run that goes on.
    const int first = both.runs[0].runs[0].trace.result.iterations;
    const int second = both.runs[1].runs[0].trace.result.iterations;
    EXPECT_TRUE(both.answer("error") > 1e-9 * both.exact || second > first);
    const auto asks = std::count_if(run.frames.begin(), run.frames.end(),
                                    [](const Frame& frame) { return frame.question >= 0; });
    EXPECT_EQ(asks, 2);  // what is wrong, and which line
  }
  EXPECT_GE(mistakes_shown.size(), 10u);
}

/// Up to where they part, both runs have the same simplex and closest point.
TEST(TwoRuns, AreTheSameUntilTheyPart) {
  for (const fs::path& file : lessons_of_mistakes()) {
    SCOPED_TRACE(file.string());
    const LessonRun run = run_of(load_lesson(file, vocabulary()));
    const TwoRunsTrace& both = trace_of(run);
    const std::array<const WideTrace*, 2> traces = {&both.runs[0].runs[0].trace,
                                                    &both.runs[1].runs[0].trace};
    for (int i = 0; i < both.parting; ++i) {
      const TwoRunsStep& step = both.shown[static_cast<std::size_t>(i)];
      const WideState& first = traces[0]->steps[static_cast<std::size_t>(step.at[0])].after;
      const WideState& second = traces[1]->steps[static_cast<std::size_t>(step.at[1])].after;
      EXPECT_NEAR((first.p - second.p).norm(), 0.0, 1e-12) << i;
      EXPECT_EQ(first.simplex.count, second.simplex.count) << i;
      if (step.phase == gjk::Phase::support) {
        EXPECT_EQ(first.support.pair, second.support.pair) << i;
      }
    }
  }
}

/// A log as a program would write it: d away from O in the second iteration.
constexpr std::string_view kLog =
    R"({"gjk_log":1,"difference":"b-a","a":[[0,0],[1,0],[1,1],[0,1]],"b":[[3,0],[4,1],[2,3]]}
{"simplex":[[0,0]],"weights":[1],"closest":[3,0],"direction":[-3,0],"support":[1,2]}
{"simplex":[[0,0],[1,2]],"kept":[[1,2],[0,0]],"closest":[2.076923076923077,1.3846153846153846],"direction":[3,2],"support":[0,1]}
{"answer":{"distance":2.4961508830135313}}
)";

TEST(TwoRuns, ALogOpensAsALesson) {
  const std::optional<LoadedLesson> loaded = log_as_lesson(kLog, "run.jsonl");
  ASSERT_TRUE(loaded);
  const LessonRun run = run_of(*loaded);
  const TwoRunsTrace& both = trace_of(run);
  ASSERT_TRUE(both.judgement && both.judgement->wrong);
  EXPECT_EQ(both.judgement->wrong->part, judging::Part::direction);
  EXPECT_EQ(both.judgement->wrong->iteration, 2);
  EXPECT_EQ(both.runs[1].runs[0].trace.result.distance, 2.4961508830135313);
  EXPECT_EQ(both.runs[1].runs[0].trace.steps.back().after.support.pair, (gjk::VertexPair{0, 1}));
  EXPECT_EQ(run.lesson.settings.file->path, "run.jsonl");
}

TEST(TwoRuns, WhatIsNoLogIsNone) {
  EXPECT_FALSE(log_as_lesson("title = \"x\"\n", "x.toml"));
  EXPECT_FALSE(log_as_lesson("", "x.jsonl"));
}

TEST(TwoRuns, ABrokenLogIsAProblemInItsPlace) {
  const std::optional<LoadedLesson> loaded =
      log_as_lesson("{\"gjk_log\":1,\"a\":[[0,0]],\"b\":[[1,2]]}\n{\"simplex\":[[0,7]]}\n", "l");
  ASSERT_TRUE(loaded && !loaded->lesson);
  ASSERT_FALSE(loaded->problems.empty());
  EXPECT_EQ(loaded->problems.front().line, 2);
  const std::optional<LoadedLesson> in_space = log_as_lesson(
      "{\"gjk_log\":1,\"difference\":\"b-a\",\"dimension\":3,\"a\":[[0,0,0]],\"b\":[[1,2,3]]}\n",
      "l");
  ASSERT_TRUE(in_space && !in_space->lesson);
  EXPECT_NE(in_space->problems.front().what.find("space"), std::string::npos);
}

/// A hand that moves a shape leaves the log behind; a loop is run again.
TEST(TwoRuns, ALogBelongsToItsShapes) {
  Lesson lesson = log_as_lesson(kLog, "run.jsonl")->lesson.value();
  lesson.y().translate.x() += 0.5;
  const LessonRun moved = run_lesson(lesson);
  EXPECT_FALSE(trace_of(moved).fits);
  EXPECT_NE(testing::texts_of(moved).front().caption.find("where they stood"), std::string::npos);
  Lesson mistake = load_lesson(kLessons / "mistake-sign.toml", vocabulary()).lesson.value();
  mistake.y().translate.x() += 0.5;
  EXPECT_TRUE(trace_of(run_lesson(mistake)).fits);
}

TEST(TwoRuns, ASecondScalarPartsWhereItsDecisionDiffers) {
  std::string text = R"(title = "t"
chapter = 8
order = 1
source = "s"
prose = "p"
[shapes.X]
name = "Q"
vertices = [[0.0, 0.0]]
[shapes.Y]
names = ["A", "B", "C"]
vertices = [[1000.0, 1.0], [-1000.0, 1.0001], [0.5, 1.00003]]
[steps]
tour = "two-runs"
[second]
scalar = "half"
[[views]]
show = "world"
[expect]
stop = "repeated-support"
)";
  const LoadedLesson loaded = parse_lesson(text, "t.toml", vocabulary());
  const LessonRun run = run_of(loaded);
  const TwoRunsTrace& both = trace_of(run);
  EXPECT_FALSE(both.judgement);
  EXPECT_GT(both.answer("error"), 0.0);
  EXPECT_EQ(both.runs[1].runs[0].trace.result.distance, both.answer("second-distance"));
}

/// In half precision these vertices are infinite.
TEST(TwoRuns, AScalarWithoutNumbersForTheShapesHasNoRun) {
  Lesson lesson = load_lesson(kLessons / "mistake-nearest.toml", vocabulary()).lesson.value();
  LessonSecond second;
  second.scalar = ScalarKind::half;
  lesson.settings = TourSettings(second);
  lesson.y().translate.x() = 1e6;
  const LessonRun run = run_lesson(lesson);
  EXPECT_FALSE(trace_of(run).fits);
  EXPECT_NE(testing::texts_of(run).front().caption.find(
                "The run in half has no numbers for these shapes"),
            std::string::npos);
}

/// openGJK's scan for a support point began at the second vertex, so it missed b0.
TEST(TwoRuns, TheReportedOverlapGoesWrongInItsSupportPoint) {
  const LessonRun run = run_of(load_lesson(kLessons / "reported-overlap.toml", vocabulary()));
  const TwoRunsTrace& both = trace_of(run);
  ASSERT_TRUE(both.judgement && both.judgement->wrong);
  EXPECT_EQ(both.judgement->wrong->part, judging::Part::support);
  EXPECT_EQ(both.judgement->wrong->iteration, 2);
  EXPECT_EQ(both.exact, 0.0);
  EXPECT_NEAR(both.answer("second-distance"), 0.508965, 5e-7);
}

/// In half precision d = Q − P finds the wrong vertex, and a d at a right angle to the edge does
/// not.
TEST(TwoRuns, OtherRulesMakeASecondRun) {
  Lesson lesson = load_lesson(kLessons / "direction-half.toml", vocabulary()).lesson.value();
  lesson.tour = "two-runs";
  lesson.questions.clear();
  lesson.panel = {"both-runs", "two-answers"};
  for (LessonView& view : lesson.views) view.effects.clear();
  lesson.settings = TourSettings(LessonSecond{.direction = gjk::DirectionRule::perpendicular});
  const LessonRun run = run_lesson(lesson);
  const TwoRunsTrace& both = trace_of(run);
  EXPECT_FALSE(both.judgement);
  EXPECT_GE(both.parting, 0);
  EXPECT_EQ(both.runs[0].runs[0].trace.result.iterations, 1);
  EXPECT_EQ(both.runs[1].runs[0].trace.result.iterations, 2);
  EXPECT_NE(testing::texts_of(run).front().caption.find("The run with d across the edge"),
            std::string::npos);
}

/// In space a dropped vertex may lie, rounded, a little farther along d than the face that holds P.
TEST(TwoRuns, InSpaceARunWithoutTheTestForProgressFindsOneVertexAgainAndAgain) {
  const LessonRun run = run_of(load_lesson(kLessons / "progress.toml", vocabulary()));
  const TwoRunsTrace& both = trace_of(run);
  const WideTrace& first = both.runs[0].runs[0].trace;
  const WideTrace& second = both.runs[1].runs[0].trace;
  EXPECT_EQ(first.result.stop, gjk::StopReason::no_progress);
  EXPECT_EQ(second.result.stop, gjk::StopReason::iteration_cap);
  EXPECT_EQ(both.shown[static_cast<std::size_t>(both.parting)].phase, gjk::Phase::stop);
  gjk::VertexPair last{};
  int repeated = 0;
  for (const WideStep& step : second.steps) {
    if (step.phase != gjk::Phase::support) continue;
    repeated = step.after.support.pair == last ? repeated + 1 : 0;
    last = step.after.support.pair;
  }
  EXPECT_GT(repeated, 50);
  EXPECT_NE(testing::texts_of(run).front().caption.find("but goes on"), std::string::npos);
  const auto json = both.json(run.lesson, run.runs[0]);
  EXPECT_EQ(json["steps"][0]["first"]["P"].size(), 3u);
}

TEST(TwoRuns, TheTableSaysOneRun) {
  for (const std::string second : {"", "mistake = \"none\"\nscalar = \"half\"\n"}) {
    const std::string text =
        "title = \"t\"\nchapter = 8\norder = 1\nsource = \"s\"\nprose = "
        "\"p\"\n[shapes.X]\nvertices "
        "= [[0, 0]]\n[shapes.Y]\nvertices = [[1, 1]]\n[steps]\ntour = "
        "\"two-runs\"\n[second]\n" +
        second + "[[views]]\nshow = \"world\"\n[expect]\nstop = \"repeated-support\"\n";
    const LoadedLesson loaded = parse_lesson(text, "t.toml", vocabulary());
    ASSERT_FALSE(loaded.lesson);
    EXPECT_EQ(
        loaded.problems.front().expected,
        "a mistake, a log, or what differs in a run of GJK: scalar, direction, regions, stop");
  }
}

}  // namespace two_runs_test
}  // namespace gjkscope
