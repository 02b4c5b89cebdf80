// Frames of the walk on features: what they say is what the trace found.

#include <gtest/gtest.h>

#include <algorithm>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/words.hpp"
#include "subjects/lin_canny/shown.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace walk_test {

const std::vector<std::string> kLessons = {"lin-canny", "lin-canny-overlap", "local-minima"};

TEST(WalkFrames, GoThroughEveryStepAndEndWithTheAnswer) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    Lesson lesson = testing::shipped_lesson(id);
    lesson.questions.clear();
    const LessonRun run = run_lesson(lesson);
    const models::WalkTrace& trace = walk_trace(run, 0)->trace;
    const bool shows_all = trace.result.stop == models::WalkStop::closest;
    ASSERT_EQ(run.frames.size(), trace.steps.size() + (shows_all ? 3 : 2));
    const std::vector<FrameText> texts = testing::texts_of(run);
    EXPECT_EQ(texts.front().phase, "start");
    for (std::size_t i = 0; i < trace.steps.size(); ++i)
      EXPECT_EQ(texts[i + 1].phase, name_of(trace.steps[i].phase));
    EXPECT_EQ(texts.back().phase, "answer");
  }
}

TEST(WalkFrames, AskOnlyWhatAStepAnswers) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    for (const FrameText& text : testing::texts_of(run)) {
      if (!text.question) continue;
      EXPECT_EQ(std::count(text.question->choices.begin(), text.question->choices.end(),
                           text.question->answer),
                1)
          << text.question->answer;
    }
  }
}

TEST(WalkFrames, TheFirstBorderThatAPointLiesBeyondIsTheWay) {
  int crossed = 0;
  for (const char* id : {"lin-canny", "lin-canny-overlap"}) {
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    for (const Frame& frame : run.frames) {
      const walks::Shown shown(run, frame);
      if (!shown.is(models::WalkPhase::regions) || frame.question >= 0) continue;
      std::optional<std::pair<bool, models::RingFeature>> first;
      for (const bool of_x : {true, false}) {
        for (const walks::Border& border : shown.borders(of_x)) {
          const bool is_beyond = border.beyond(of_x ? shown.closest().b : shown.closest().a) > 0.0;
          if (is_beyond && !first) first = {of_x, border.neighbour};
        }
      }
      const models::RegionTest& found = shown.state.found;
      ASSERT_EQ(first.has_value(), found.crossed) << id;
      if (!first) continue;
      ++crossed;
      EXPECT_EQ(first->first, found.of_a) << id;
      EXPECT_EQ(first->second, found.neighbour) << id;
    }
  }
  EXPECT_GE(crossed, 5);
}

TEST(WalkFrames, AlongAPathEachWalkStartsWhereTheLastOneEnded) {
  const LessonRun run = run_lesson(testing::shipped_lesson("lin-canny-motion"));
  ASSERT_GT(run.runs.size(), 2u);
  for (int i = 1; i < static_cast<int>(run.runs.size()); ++i) {
    EXPECT_EQ(walk_trace(run, i)->trace.start.a, walk_trace(run, i - 1)->trace.result.a);
    EXPECT_EQ(walk_trace(run, i)->trace.start.b, walk_trace(run, i - 1)->trace.result.b);
    EXPECT_LE(walk_trace(run, i)->trace.result.steps, 3);
  }
}

TEST(WalkFrames, ALocalMinimumIsToldBesideTheTruth) {
  const LessonRun run = run_lesson(testing::shipped_lesson("local-minima"));
  const TracedWalk& walk = *walk_trace(run, 0);
  ASSERT_EQ(walk.trace.result.stop, models::WalkStop::local_minimum);
  ASSERT_TRUE(walk.truth);
  EXPECT_LT(walk.truth->distance, walk.trace.result.answer.distance);
  const std::string caption = testing::texts_of(run).back().caption;
  EXPECT_NE(caption.find(Numbers(run.lesson)(walk.truth->distance)), std::string::npos) << caption;
}

}  // namespace walk_test
}  // namespace gjkscope
