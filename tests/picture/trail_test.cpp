// The frame that shows a whole run at a glance.

#include "run/trail.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/tween.hpp"
#include "texts.hpp"

namespace gjkscope::trail_test {

using testing::shipped_lesson;

int cells_in(const Picture& picture) {
  return static_cast<int>(std::count_if(picture.marks.begin(), picture.marks.end(),
                                        [](const Mark& mark) { return mark.role == "card.cell"; }));
}

bool has_text(const Picture& picture, const std::string& text) {
  return std::any_of(picture.marks.begin(), picture.marks.end(), [&](const Mark& mark) {
    const Text* found = std::get_if<Text>(&mark.shape);
    return found && found->text == text;
  });
}

Picture last_picture(const LessonRun& run, const Page& page = {}) {
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, testing::fonts(), page);
  return pictures.picture(static_cast<int>(run.frames.size()) - 1);
}

TEST(Trail, EndsEachSingleRunOfSeveralIterationsThatIsFollowedToItsEnd) {
  int trails = 0;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    SCOPED_TRACE(lesson.id);
    const LessonRun run = run_lesson(lesson);
    const bool steps = lesson.tour == "phase" || lesson.tour == "iteration";
    const bool is_one = run.runs.size() == 1 && !lesson.until;
    const auto last = run.runs.front().trace.steps.size();
    const bool has_end = steps && run.frames.back().step + 1 == static_cast<int>(last);
    const bool wanted = is_one && has_end && run.runs.front().trace.result.iterations > 1;
    EXPECT_EQ(wanted, is_trail(run.frames.back()));
    EXPECT_EQ(std::count_if(run.frames.begin(), run.frames.end(), is_trail), wanted ? 1 : 0);
    trails += wanted ? 1 : 0;
  }
  EXPECT_GT(trails, 20);
}

TEST(Trail, AViewOfZHasACellForEachIterationAndTheOtherBothBounds) {
  for (const auto& [id, first] :
       {std::pair("polygons-gjk", "1: S = {N−C}"), std::pair("polyhedra-gjk", "1: S = {L−D}"),
        std::pair("stop-contained", "1: S = {C, D}")}) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(shipped_lesson(id));
    const Picture picture = last_picture(run);
    EXPECT_EQ(cells_in(picture), run.runs.front().trace.result.iterations);
    EXPECT_TRUE(has_text(picture, first));
    EXPECT_TRUE(has_text(picture, "at least"));
    EXPECT_TRUE(has_text(picture, "at most"));
    for (const Mark& mark : picture.marks) {
      if (mark.clip < 0) continue;
      EXPECT_EQ(mark.subject, Subject()) << "nothing there can be taken";
    }
  }
}

TEST(Trail, EachCellShowsTheStepOfItsIterationThatHasASupportPoint) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  const std::vector<Frame> frames = frames_of_trail(run);
  ASSERT_EQ(frames.size(), 4u);
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    EXPECT_EQ(run.step(frames[i]).phase, gjk::Phase::support);
    EXPECT_EQ(run.step(frames[i]).iteration, static_cast<int>(i) + 1);
  }
  EXPECT_EQ(frames.back().step + 1, static_cast<int>(run.runs.front().trace.steps.size()));
}

TEST(Trail, OfALongRunHasTheFirstIterationsAndTheLast) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  lesson.questions.clear();
  lesson.options.start = {};
  constexpr int kCorners = 1000;
  LessonRun run;
  for (int turn = 0; turn < 60 && run.runs.empty(); ++turn) {
    for (LessonShape& shape : lesson.bodies) {
      shape.vertices.clear();
      shape.vertex_names.clear();
      for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * 3.141592653589793 * i / kCorners;
        shape.vertices.emplace_back(3.0 * std::cos(angle), 0.4 * std::sin(angle), 0.0);
        shape.vertex_names.push_back(fmt::format("{}{}", shape.name, i));
      }
    }
    lesson.bodies[1].translate = {1.0 + 0.1 * turn, 3.5, 0.0};
    lesson.bodies[1].rotate_degrees = 6.0 * turn;
    run = run_lesson(lesson);
    if (run.runs.front().trace.result.iterations <= static_cast<int>(kMostInTrail)) run = {};
  }
  ASSERT_FALSE(run.runs.empty()) << "no run is long";
  const int iterations = run.runs.front().trace.result.iterations;
  const std::vector<Frame> frames = frames_of_trail(run);
  ASSERT_EQ(frames.size(), kMostInTrail);
  EXPECT_EQ(run.step(frames[kMostInTrail - 2]).iteration, static_cast<int>(kMostInTrail) - 1);
  EXPECT_EQ(run.step(frames.back()).iteration, iterations);
  EXPECT_NE(testing::texts_of(run).back().detail.find(
                fmt::format("Iterations {} to {} are left out", kMostInTrail, iterations - 1)),
            std::string::npos);
}

TEST(Trail, SaysHowTheRunWentAndWhereItLeads) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  const FrameText text = testing::texts_of(run).back();
  EXPECT_EQ(text.caption, "GJK took 4 iterations, and stopped because K−C was in S already.");
  EXPECT_TRUE(text.detail.ends_with(run.lesson.next)) << text.detail;
  EXPECT_EQ(text.position, "the run at a glance");
  EXPECT_EQ(text.phase, "trail");
}

TEST(Trail, NothingMovesIntoIt) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, testing::fonts());
  const int last = static_cast<int>(run.frames.size()) - 1;
  const Picture trail = pictures.picture(last);
  EXPECT_EQ(tween(pictures.picture(last - 1), trail, 0.5), trail);
}

}  // namespace gjkscope::trail_test
