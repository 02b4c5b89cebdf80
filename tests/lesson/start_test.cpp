// Runs of lessons and cases begin at the same vertices whatever scalar they compute in.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "lesson/case.hpp"
#include "lessons.hpp"
#include "subjects/second_run/second_run.hpp"

namespace gjkscope {
namespace start_test {

constexpr ScalarKind kScalars[] = {ScalarKind::half, ScalarKind::single, ScalarKind::double_,
                                   ScalarKind::exact};

template <int D>
int compare_scalars(const CaseIn<D>& shapes) {
  const gjk::WarmStart in_double =
      run_case(shapes, ScalarKind::double_).trace.initial.simplex.as_start();
  int answered = 0;
  for (const ScalarKind scalar : kScalars) {
    const PositionedRun run = run_case(shapes, scalar);
    if (run.trace.result.error != gjk::Error::none) continue;  // too large or small for half
    ++answered;
    EXPECT_TRUE(run.trace.initial.simplex.as_start() == in_double) << static_cast<int>(scalar);
  }
  return answered;
}

TEST(Start, IsTheSameInEveryScalarInAllHardCases) {
  int cases = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(GJKSCOPE_SOURCE_DIR "/tests/hard-cases")) {
    SCOPED_TRACE(file.path());
    std::ostringstream text;
    text << std::ifstream(file.path()).rdbuf();
    for (const ReadCase& read : parse_cases(text.str(), file.path().string(), 3)) {
      ++cases;
      ASSERT_TRUE(read.value || read.in_space);
      EXPECT_GE(read.value ? compare_scalars(*read.value) : compare_scalars(*read.in_space), 2);
    }
  }
  EXPECT_GE(cases, 36);
}

TEST(Start, IsTheSameInEveryScalarInAllLessons) {
  int compared = 0;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    SCOPED_TRACE(lesson.id);
    const auto first_run = [&](ScalarKind scalar) {
      Lesson in = lesson;
      in.scalar = scalar;
      return run_lesson(in).runs.front().trace;
    };
    const gjk::WarmStart in_double = first_run(ScalarKind::double_).initial.simplex.as_start();
    for (const ScalarKind scalar : {ScalarKind::half, ScalarKind::single, ScalarKind::exact}) {
      const WideTrace trace = first_run(scalar);
      if (trace.steps.empty()) continue;  // refused, or another algorithm
      ++compared;
      EXPECT_TRUE(trace.initial.simplex.as_start() == in_double) << static_cast<int>(scalar);
    }
  }
  EXPECT_GE(compared, 100);
}

TEST(Start, OfASecondRunIsThatOfTheFirstAtEachPositionOfAWarmPath) {
  int compared = 0;
  for (Lesson lesson : testing::shipped_lessons()) {
    if (!lesson.warm_start || lesson.settings.kind()) continue;
    lesson.settings = TourSettings(LessonSecond{
        .scalar = lesson.scalar == ScalarKind::exact ? ScalarKind::double_ : ScalarKind::exact});
    const LessonRun run = run_lesson(lesson);
    if (run.tour->algorithm->takes_outlines) continue;
    EffectGraph graph(run);
    for (int i = 0; i < static_cast<int>(run.runs.size()); ++i) {
      ++compared;
      EXPECT_TRUE(graph.get<SecondRun>(Frame{i, 0}).run.trace.initial.simplex.as_start() ==
                  run.runs[static_cast<std::size_t>(i)].trace.initial.simplex.as_start())
          << lesson.id << ", position " << i;
    }
  }
  EXPECT_GE(compared, 5);
}

}  // namespace start_test
}  // namespace gjkscope
