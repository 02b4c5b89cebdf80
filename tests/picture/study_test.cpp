// The lesson that shows the study of accuracy: dots, captions and the pairs behind them.

#include <gtest/gtest.h>

#include <algorithm>

#include "effects/worst_pair.hpp"
#include "lessons.hpp"
#include "picture/frame.hpp"
#include "picture/study_plot.hpp"

namespace gjkscope {
namespace {

struct Shown {
  Shown() : run(run_lesson(testing::shipped_lesson("accuracy-cost"))), effects(run) {}
  [[nodiscard]] const LessonStudy& study() const { return *run.lesson.study; }
  /// The frame of a configuration; the one after the last is the outcome.
  [[nodiscard]] int frame_of(std::size_t configuration) const {
    return static_cast<int>(run.frames.size() - study().configurations.size() - 1 + configuration);
  }
  LessonRun run;
  EffectGraph effects;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StudyPicture, EachDotWithAnErrorIsAMarkThatKnowsWhichItIs) {
  Shown shown;
  const std::vector<StudyDot> family = of_family(shown.study().dots, shown.study().family);
  const Plot plot = study_plot(family);
  std::size_t points = 0;
  for (const PlotSeries& series : plot.series) {
    if (!series.has_symbols) continue;
    ASSERT_EQ(series.points.size(), series.subjects.size());
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const StudyDot& dot = family[static_cast<std::size_t>(series.subjects[i].x)];
      EXPECT_EQ(series.points[i], place_of(dot)) << dot.configuration;
      EXPECT_EQ(series.style, style_of(dot)) << dot.configuration;
    }
    points += series.points.size();
  }
  EXPECT_EQ(points, std::count_if(family.begin(), family.end(),
                                  [](const StudyDot& dot) { return dot.error.has_value(); }));
}

TEST(StudyPicture, TheFrontGoesDownToTheRightThroughDotsThatNothingBeats) {
  Shown shown;
  const std::vector<StudyDot> family = of_family(shown.study().dots, shown.study().family);
  const std::vector<StudyDot> front = front_of(family);
  ASSERT_GE(front.size(), 3u);
  for (std::size_t i = 1; i < front.size(); ++i) {
    EXPECT_LT(front[i - 1].ns, front[i].ns);
    EXPECT_GT(*front[i - 1].error, *front[i].error);
  }
  const Plot plot = study_plot(family);
  const PlotSeries& line = plot.series.back();
  EXPECT_FALSE(line.has_symbols);
  ASSERT_EQ(line.points.size(), front.size());
  EXPECT_EQ(line.points.front(), place_of(front.front()));
}

TEST(StudyPicture, FramesTellTheirConfigurationAndItsWorstPair) {
  Shown shown;
  const std::vector<FrameText> texts = lesson_texts(shown.run, shown.effects);
  for (std::size_t i = 0; i < shown.study().configurations.size(); ++i) {
    const StudyDot& dot = shown.study().dot(shown.study().configurations[i]);
    const int index = shown.frame_of(i);
    const FrameText& text = texts[static_cast<std::size_t>(index)];
    SCOPED_TRACE(text.caption);
    EXPECT_TRUE(holds(text.caption, dot.configuration + ":"));
    EXPECT_TRUE(holds(text.caption, time_text(dot.ns)));
    EXPECT_EQ(holds(text.caption, "nothing is both faster and more accurate"), dot.on_front);
    EXPECT_EQ(holds(text.detail, "it says wrongly"), dot.wrong > 0);
    const WorstPair::Value& pair =
        shown.effects.get<WorstPair>(shown.run.frames[static_cast<std::size_t>(index)]);
    EXPECT_NEAR((pair.on_y - pair.on_x).norm(), dot.distance, 1e-12 * (1.0 + dot.distance));
  }
  const FrameText& outcome = texts.back();
  EXPECT_TRUE(holds(outcome.caption, "Pareto front"));
}

TEST(StudyPicture, OtherLessonsLookAtNoWorstPair) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  EffectGraph effects(run);
  static_cast<void>(lesson_texts(run, effects));
  EXPECT_EQ(effects.count(WorstPair::kName).runs, 0);
}

}  // namespace
}  // namespace gjkscope
