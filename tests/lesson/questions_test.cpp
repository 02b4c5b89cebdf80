#include "run/questions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "lesson/load.hpp"
#include "lesson_texts.hpp"
#include "lessons.hpp"
#include "run/facts.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace questions_test {

/// The pentagon of the slides: E; C; CE; D; CDE, E dropped; CD; C again.
std::string pentagon(const std::string& tour, const std::string& questions) {
  return fmt::format(R"(title = "Pentagon"
chapter = 3
order = 1
prose = "Evolution."
steps.tour = "{}"
shapes.X.name = "Q"
shapes.X.vertices = [[2.7, 2.3]]
views = [{{ show = "world" }}]
query.start = ["E"]
expect.stop = "repeated-support"
{}
[shapes.Y]
names = ["A", "B", "C", "D", "E"]
vertices = [[-1.4, -1.6], [1.2, -1.8], [2.4, -0.4], [0.9, 2.2], [-2.0, 0.4]]
)",
                     tour, questions);
}

LoadedLesson parse(const std::string& text) {
  return parse_lesson(text, "pentagon.toml", vocabulary());
}

LessonRun ran(const std::string& tour, const std::string& questions) {
  LoadedLesson loaded = parse(pentagon(tour, questions));
  for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
  return run_lesson(loaded.lesson.value_or(Lesson{}));
}

/// The frames that ask, each with the checks that hold for all of them.
std::vector<Frame> asking(const LessonRun& run) {
  std::vector<Frame> out;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const Frame& frame = run.frames[i];
    if (frame.question < 0) continue;
    out.push_back(frame);
    if (i == 0 || i + 1 == run.frames.size()) {
      ADD_FAILURE() << "a question stands between what is known and what answers it";
      continue;
    }
    EXPECT_EQ(run.frames[i - 1].step, frame.step) << "shows what the last frame showed";
    EXPECT_EQ(run.frames[i - 1].part, frame.part);
    EXPECT_LT(frame.step, frame.answering_step);
  }
  return out;
}

TEST(Questions, EachStandsBeforeTheFrameThatAnswers) {
  const LessonRun plain = ran("phase", "");
  const LessonRun run = ran("phase", R"(questions = [{ ask = "support" }])");
  const std::vector<Frame> asked = asking(run);
  ASSERT_EQ(asked.size(), 2u) << "at last both ends of the closest edge lie equally far";
  EXPECT_EQ(run.frames.size(), plain.frames.size() + 2);
  for (const Frame& frame : asked) {
    const WideStep& step = run.run(frame).trace.steps[frame.answering_step];
    EXPECT_EQ(step.phase, gjk::Phase::support);
    EXPECT_EQ(run.step(frame).phase, gjk::Phase::direction);
  }
  std::size_t at = 0;
  for (const Frame& frame : run.frames) {
    if (frame.question >= 0) continue;
    EXPECT_EQ(frame.step, plain.frames[at].step);
    ++at;
  }
}

TEST(Questions, OfASingleVertexAreNotAsked) {
  // Iteration 1 has a single vertex: one region, and nothing to drop.
  for (const char* ask : {"region", "dropped"}) {
    const std::vector<Frame> asked =
        asking(ran("phase", fmt::format(R"(questions = [{{ ask = "{}" }}])", ask)));
    EXPECT_EQ(asked.size(), 2u) << ask;
  }
}

TEST(Questions, OneIterationMayBeMeant) {
  const LessonRun run = ran("phase", R"(questions = [{ ask = "stop", at = 3 }])");
  const std::vector<Frame> asked = asking(run);
  ASSERT_EQ(asked.size(), 1u);
  const auto& steps = run.run(asked[0]).trace.steps;
  const std::size_t answer = static_cast<std::size_t>(asked[0].answering_step);
  EXPECT_EQ(steps[answer].iteration, 3);
  EXPECT_EQ(steps[answer + 1].after.stop, gjk::StopReason::repeated_support);
}

TEST(Questions, AreAskedBeforeAnyStepTellsTheAnswer) {
  // P shows which vertices it needs, the support point whether the run goes on.
  const LessonRun dropped = ran("phase", R"(questions = [{ ask = "dropped" }])");
  for (const Frame& frame : asking(dropped)) EXPECT_EQ(dropped.step(frame).phase, gjk::Phase::add);
  const LessonRun stop = ran("phase", R"(questions = [{ ask = "stop" }])");
  const std::vector<Frame> asked = asking(stop);
  EXPECT_EQ(asked.size(), 3u);
  for (const Frame& frame : asked) EXPECT_EQ(stop.step(frame).phase, gjk::Phase::direction);
}

TEST(Questions, AFrameForAnIterationIsAskedForAllThatItAnswers) {
  const LessonRun run =
      ran("iteration", R"(questions = [{ ask = "support", at = 2 }, { ask = "dropped", at = 2 }])");
  int asked = 0;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const Frame& frame = run.frames[i];
    if (frame.question < 0) continue;
    ++asked;
    EXPECT_EQ(run.step(frame).iteration, 1);
    EXPECT_EQ(run.run(frame).trace.steps[frame.answering_step].iteration, 2);
  }
  EXPECT_EQ(asked, 2);
}

TEST(Questions, ARegionIsAskedForBeforeTheTestThatHolds) {
  LoadedLesson loaded = parse(R"(title = "Triangle"
chapter = 2
order = 1
prose = "Tests."
steps.tour = "test"
questions = [{ ask = "region" }]
views = [{ show = "world" }]
query.start = ["A", "B", "C"]
expect.stop = "repeated-support"
shapes.X.vertices = [[1.35, 1.45]]
[shapes.Y]
names = ["A", "B", "C"]
vertices = [[-1.85, -1.05], [1.55, -0.75], [0.0, 1.7]]
)");
  ASSERT_TRUE(loaded.lesson);
  const LessonRun run = run_lesson(*loaded.lesson);
  // The weights, regions A, B, C and AB, which fail, the question, and BC.
  ASSERT_EQ(run.frames.size(), 7u);
  EXPECT_EQ(run.frames[5].question, 0);
  ASSERT_TRUE(tried_tests(run, run.frames[5]));
  EXPECT_EQ(*tried_tests(run, run.frames[5]), 4);
  EXPECT_TRUE(run.step(run.frames[6]).record.region_tests[4].holds);
}

TEST(Questions, ThatNoFrameAsksAreAProblem) {
  LoadedLesson loaded =
      parse(pentagon("phase", R"(questions = [{ ask = "stop" }, { ask = "region", at = 1 }])"));
  ASSERT_TRUE(loaded.lesson);
  const std::vector<Problem> problems = unasked_questions(run_lesson(*loaded.lesson));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].what, "no frame asks 'region' in iteration 1");
}

TEST(Questions, AboutSignsAreForTetrahedraThatHaveAVolume) {
  Lesson lesson = testing::shipped_lesson("tetrahedron-volumes");
  EXPECT_TRUE(unasked_questions(run_lesson(lesson)).empty());
  for (Eigen::Vector3d& vertex : lesson.y().vertices) vertex.z() = 0.0;
  EXPECT_EQ(unasked_questions(run_lesson(lesson)).size(), 2u);
}

TEST(Questions, NeedFramesThatAnswer) {
  LoadedLesson loaded = parse(pentagon("answer", R"(questions = [{ ask = "stop" }])"));
  ASSERT_EQ(loaded.problems.size(), 1u);
  EXPECT_EQ(loaded.problems[0].what, "question 'stop' with tour 'answer'");
  EXPECT_EQ(loaded.problems[0].line, 11);
  loaded = parse(pentagon("test", R"(questions = [{ ask = "stop" }])"));
  ASSERT_EQ(loaded.problems.size(), 1u);
  EXPECT_EQ(loaded.problems[0].what, "question 'stop' with tour 'test'");
}

TEST(Questions, AreReadAndMistakesFound) {
  const LessonRun run = ran("phase", R"(questions = [{ ask = "region", at = 2 }])");
  ASSERT_EQ(run.lesson.questions.size(), 1u);
  EXPECT_EQ(run.lesson.questions[0].ask, "region");
  EXPECT_EQ(run.lesson.questions[0].at, 2);

  const auto problems = [](const std::string& questions) {
    const LoadedLesson loaded = parse(pentagon("phase", questions));
    EXPECT_EQ(loaded.problems.size(), 1u) << questions;
    return loaded.problems.empty() ? Problem{} : loaded.problems[0];
  };
  const Problem misspelled = problems(R"(questions = [{ ask = "regoin" }])");
  EXPECT_EQ(misspelled.what, "unknown question 'regoin'");
  EXPECT_EQ(misspelled.nearest, "region");
  EXPECT_EQ((std::pair{misspelled.line, misspelled.column}), (std::pair{11, 22}));
  const Problem twice = problems(R"(questions = [{ ask = "stop" }, { ask = "stop", at = 2 }])");
  EXPECT_EQ(twice.what, "question 'stop' is asked twice");
  EXPECT_EQ(twice.column, 40);
  EXPECT_EQ(problems("questions = [{ at = 2 }]").column, 14);
  EXPECT_EQ(problems(R"(questions = [{ ask = "stop", at = 0 }])").column, 35);
}

}  // namespace questions_test
}  // namespace gjkscope
