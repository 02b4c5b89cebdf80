#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lessons.hpp"
#include "subjects/issues/numerical_issue.hpp"

namespace gjkscope {
namespace issues_test {

using testing::shipped_lesson;

TEST(NumericalIssue, TheMapHasEachKindInTheOrderOfTheSlides) {
  using enum NumericalIssue::Kind;
  const LessonRun run = run_lesson(shipped_lesson("numerics-map"));
  EffectGraph graph(run);
  std::vector<NumericalIssue::Kind> kinds;
  for (int i = 0; i < static_cast<int>(run.runs.size()); ++i)
    kinds.push_back(graph.get<NumericalIssue>({.run = i}).kind);
  EXPECT_EQ(kinds, (std::vector{direction, repeated, contained, vertex, edge, interior, notch,
                                collinear}));
}

TEST(NumericalIssue, TheRoundedDirectionIsNotPerpendicularToItsEdge) {
  const LessonRun run = run_lesson(shipped_lesson("numerics-map"));
  EffectGraph graph(run);
  const double dot = graph.get<NumericalIssue>({.run = 0}).dot_with_edge;
  EXPECT_NE(dot, 0.0);
  EXPECT_LT(std::abs(dot), 1e-5);
}

TEST(NumericalIssue, ThreeVerticesOnALineAreSupportPointsTogether) {
  const LessonRun run = run_lesson(shipped_lesson("numerics-map"));
  EffectGraph graph(run);
  EXPECT_EQ(graph.get<NumericalIssue>({.run = 7}).support, (std::vector{4, 5, 6}));
}

}  // namespace issues_test
}  // namespace gjkscope
