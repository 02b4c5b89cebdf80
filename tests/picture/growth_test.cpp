// The lesson whose polygons grow: plots and captions say what was measured.

#include "subjects/growth/growth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/words.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace growth_test {

Lesson small_lesson() {
  Lesson lesson = testing::shipped_lesson("lazy-hull");
  lesson.settings.edit<LessonGrowth>().vertices = {3, 10, 100, 1000, 3000};
  lesson.settings.edit<LessonGrowth>().runs = 20;
  lesson.questions.clear();
  return lesson;
}

struct RunTexts {
  explicit RunTexts(Lesson lesson)
      : run(run_lesson(std::move(lesson))), effects(run), texts(lesson_texts(run, effects)) {}
  /// The text of a size, of the outcome, or of slow runs.
  [[nodiscard]] const FrameText& at(int detail) const {
    const std::vector<int>& sizes = run.lesson.settings.as<LessonGrowth>()->vertices;
    const std::size_t slow = sizes.front() <= SlowGrowth::kMost ? 1 : 0;
    return texts[texts.size() - 1 - slow - sizes.size() + static_cast<std::size_t>(detail)];
  }
  [[nodiscard]] const Growth::Value& measured() { return effects.get<Growth>(run.frames.back()); }

  LessonRun run;
  EffectGraph effects;
  std::vector<FrameText> texts;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(GrowthPicture, CaptionsOfSizesAreTheMeasuredNumbers) {
  RunTexts shown(small_lesson());
  for (int i = 0; i < 5; ++i) {
    const Growth::Sample& sample = shown.measured()[static_cast<std::size_t>(i)];
    const FrameText& text = shown.at(i);
    SCOPED_TRACE(text.caption + " " + text.detail);
    EXPECT_TRUE(holds(text.caption, "n = " + grouped(sample.vertices) + ":"));
    EXPECT_TRUE(holds(text.caption, fixed(sample.iterations, 1) + " iterations on average"));
    EXPECT_TRUE(holds(text.caption, "3 to 6"));
    EXPECT_TRUE(holds(text.detail, fixed(sample.touched_points, 1)));
    EXPECT_TRUE(holds(text.detail, grouped(sample.seen_vertices)));
    EXPECT_EQ(holds(text.detail, "scanning at " + grouped(sample.scanned_vertices)),
              sample.is_climbed);
  }
}

TEST(GrowthPicture, TheOutcomeSaysWhereLarsensNumbersEnd) {
  RunTexts shown(small_lesson());
  const FrameText& outcome = shown.at(5);
  EXPECT_EQ(outcome.position,
            fmt::format("outcome · {} of {}", shown.texts.size() - 1, shown.texts.size()));
  const Growth::Value& measured = shown.measured();
  std::string last_kept;
  for (const Growth::Sample& sample : measured) {
    if (sample.iterations > Growth::kLarsenMost) break;
    last_kept = grouped(sample.vertices);
  }
  EXPECT_TRUE(holds(outcome.caption, "up to n = " + last_kept)) << outcome.caption;

  Lesson easy = small_lesson();
  easy.settings.edit<LessonGrowth>().vertices = {3, 10};
  EXPECT_TRUE(holds(RunTexts(easy).at(2).caption, "no more than Larsen's 6 at any n"))
      << RunTexts(easy).at(2).caption;
  Lesson hard = small_lesson();
  hard.settings.edit<LessonGrowth>().vertices = {1000, 3000};
  EXPECT_TRUE(holds(RunTexts(hard).at(2).caption, "more than Larsen's 3 to 6"))
      << RunTexts(hard).at(2).caption;
}

TEST(GrowthPicture, PlotsShowWhatFramesHaveToldAndSetOffTheFramesOwn) {
  const LessonRun run = run_lesson(small_lesson());
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  EffectGraph effects(run);
  const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts);
  EXPECT_EQ(effects.count(Growth::kName).runs, 1);
  ASSERT_EQ(frames.size(), run.frames.size());
  const auto count = [](const FramePicture& frame, const std::string& role) {
    return std::count_if(frame.picture.marks.begin(), frame.picture.marks.end(),
                         [&](const Mark& mark) { return mark.role == role; });
  };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    SCOPED_TRACE(i);
    const int detail = shown_size(run, run.frames[i]).value_or(-1);
    const int shown = std::min(detail + 1, 5);
    EXPECT_EQ(count(frames[i], "plot.first"), 2 * (shown + 1)) << "in two plots, and by the name";
    // Slow runs are a series of their own, of two sizes.
    EXPECT_EQ(count(frames[i], "plot.fourth"), shown + 1 + (detail == 6 ? 3 : 0));
    EXPECT_EQ(count(frames[i], "plot.first.label"), 2);
    EXPECT_EQ(count(frames[i], "plot.current"), detail >= 0 && detail < 5 ? 2 : 0);
  }
}

TEST(GrowthPicture, APolygonThatIsBuiltToBeSlowTakesAsManyIterationsAsVertices) {
  RunTexts shown(small_lesson());
  const SlowGrowth::Value& slow = shown.effects.get<SlowGrowth>(shown.run.frames.back());
  ASSERT_EQ(slow.size(), 2u);
  for (const SlowGrowth::Run& each : slow) EXPECT_EQ(each.iterations, each.vertices);
  EXPECT_TRUE(holds(shown.at(6).caption, "10 with 10 vertices")) << shown.at(6).caption;
}

TEST(GrowthPicture, AsksHowIterationsGrowAtPlacesOfThePlot) {
  Lesson lesson = small_lesson();
  lesson.questions = {{"iterations", 2}};
  const RunTexts shown(lesson);
  const auto asks = std::find_if(shown.texts.begin(), shown.texts.end(),
                                 [](const FrameText& text) { return text.question.has_value(); });
  ASSERT_NE(asks, shown.texts.end());
  EXPECT_EQ(asks->question->choices.size(), 3u);
  EXPECT_EQ(asks->question->subjects.size(), 3u);
  EXPECT_NE(asks->question->answer, "like n");
  EXPECT_TRUE(holds((asks + 1)->detail, "like n")) << "why not: " << (asks + 1)->detail;
}

TEST(GrowthPicture, OtherLessonsMeasureNothing) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  EffectGraph effects(run);
  (void)lesson_pictures(run, effects, fonts);
  EXPECT_EQ(effects.count(Growth::kName).runs, 0);
}

}  // namespace growth_test
}  // namespace gjkscope
