// The lessons that compare methods for general models: what frames say, ask and answer is what was
// counted, and timed.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/words.hpp"
#include "subjects/general_growth/lesson_trace.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/methods/lesson_trace.hpp"

namespace gjkscope {
namespace costs_test {

/// Two sizes, with times.
Lesson small_lesson() {
  Lesson lesson = testing::shipped_lesson("general-growth");
  lesson.settings.edit<LessonGrowth>().vertices = {10, 30};
  lesson.settings.edit<LessonGrowth>().times = {"a processor", {2e3, 9e6}, {7e3},
                                                {4e3, 5e3},    {3e3, 8e3}, {4e3, 15e2},
                                                {1e3, 11e2},   {2e4, 6e4}};
  lesson.questions.clear();
  return lesson;
}

struct RunTexts {
  explicit RunTexts(Lesson lesson)
      : run(run_lesson(std::move(lesson))), effects(run), texts(lesson_texts(run, effects)) {}
  LessonRun run;
  EffectGraph effects;
  std::vector<FrameText> texts;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The frames that ask.
std::vector<FrameText> asked(const RunTexts& shown) {
  std::vector<FrameText> out;
  std::copy_if(shown.texts.begin(), shown.texts.end(), std::back_inserter(out),
               [](const FrameText& text) { return text.question.has_value(); });
  return out;
}

TEST(CostFrames, SayWhatWasTimed) {
  const RunTexts shown(small_lesson());
  ASSERT_EQ(shown.texts.size(), 1u + 2 + 1 + kClaims + 1);
  const FrameText& times = shown.texts[3];
  EXPECT_EQ(times.phase, "time");
  EXPECT_TRUE(holds(times.caption, "all pairs take 9 ms, trees of boxes 5 µs")) << times.caption;
  EXPECT_TRUE(holds(times.detail, "takes 60 µs: from n = 30 on one distance repays it"))
      << times.detail;
  EXPECT_TRUE(holds(times.detail, "a processor")) << times.detail;
  EXPECT_TRUE(holds(shown.texts[4].caption, "It agrees.")) << shown.texts[4].caption;
  Lesson other = small_lesson();
  LessonGrowth& swapped = other.settings.edit<LessonGrowth>();
  std::swap(swapped.times->boxes, swapped.times->pairs);
  EXPECT_TRUE(holds(RunTexts(other).texts[4].caption, "It does not agree here."));
  other.settings.edit<LessonGrowth>().times.reset();
  EXPECT_EQ(RunTexts(other).texts.size(), 1u + 2 + kClaims + 1)
      << "without times no frame is of them";
}

TEST(CostFrames, TheShippedTimesBelongToTheSizes) {
  const Lesson lesson = testing::shipped_lesson("general-growth");
  ASSERT_TRUE(lesson.settings.as<LessonGrowth>()->times);
  const GrowthTimes& times = *lesson.settings.as<LessonGrowth>()->times;
  EXPECT_TRUE(std::is_sorted(times.pairs.begin(), times.pairs.end()));
  EXPECT_LT(1000.0 * times.boxes.back(), times.pairs.back()) << "a thousand times faster";
}

TEST(CostFrames, AskHowVisitsGrowAndWhetherLarsenAgrees) {
  const RunTexts shown(testing::shipped_lesson("general-growth"));
  const std::vector<FrameText> all = asked(shown);
  ASSERT_EQ(all.size(), 4u);
  const GeneralGrowthTrace& trace = general_growth_trace(*shown.run.algorithm_traces[0]);
  const auto& samples = trace.samples;
  const double ratio = samples[8].boxes / samples[7].boxes;
  ASSERT_LT(ratio, 1.5);
  EXPECT_EQ(all[0].question->choices.size(), 3u);
  EXPECT_EQ(all[0].question->answer, all[0].question->choices[0]);
  EXPECT_FALSE(holds(all[0].caption + all[0].detail, grouped(samples[8].boxes)));
  EXPECT_EQ(all[1].question->answer, "trees of boxes");
  EXPECT_EQ(all[2].question->answer, "yes");
  EXPECT_EQ(all[3].question->answer, "yes");
  // All pairs of nodes are visited, or nearly, when there are few segments.
  Lesson small = small_lesson();
  small.questions = {{"visits", 2}, {"agrees", 1}};
  LessonGrowth& swapped = small.settings.edit<LessonGrowth>();
  std::swap(swapped.times->boxes, swapped.times->pairs);
  const std::vector<FrameText> of_small = asked(RunTexts(small));
  ASSERT_EQ(of_small.size(), 2u);
  EXPECT_EQ(of_small[0].question->answer, "3.0 times, as n");
  EXPECT_EQ(of_small[1].question->answer, "no");
}

TEST(MethodFrames, AskWhatMemorySaves) {
  Lesson lesson = testing::shipped_lesson("methods-motion");
  lesson.questions = {{"front", {}}, {"memory", {}}};
  const RunTexts shown(lesson);
  const std::vector<FrameText> all = asked(shown);
  const std::size_t positions = shown.run.runs.size();
  ASSERT_EQ(all.size(), positions);
  std::set<std::string> answers;
  long cold = 0;
  long warm = 0;
  for (std::size_t i = 0; i < positions; ++i) {
    const MethodsTrace& at = *methods_trace(shown.run, static_cast<int>(i));
    cold += at.at(Method::gjk_cold);
    warm += at.at(Method::gjk_warm);
    if (i == 0) continue;
    const long saved = at.at(Method::tree_cold) - at.at(Method::tree_front);
    const std::string expected = saved > 0 ? "fewer" : saved == 0 ? "as many" : "more";
    EXPECT_EQ(all[i - 1].question->answer, expected) << i;
    answers.insert(expected);
  }
  EXPECT_EQ(answers.size(), 3u);
  EXPECT_LT(2 * warm, cold);
  EXPECT_EQ(all.back().question->answer, name_of(Method::gjk_warm));
}

}  // namespace costs_test
}  // namespace gjkscope
