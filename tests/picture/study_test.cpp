// The lesson that shows the study of accuracy: one pair, its plot, and what captions and panels
// say.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/decimal.hpp"
#include "frames/frame.hpp"
#include "lessons.hpp"
#include "subjects/study/dot_words.hpp"
#include "subjects/study/plot.hpp"
#include "subjects/study/rounded_pair.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace study_test {

struct Shown {
  Shown() : run(run_lesson(testing::shipped_lesson("accuracy-cost"))), effects(run) {}
  [[nodiscard]] const LessonStudy& study() const { return *run.lesson.settings.as<LessonStudy>(); }
  [[nodiscard]] std::vector<StudyDot> family() const {
    return of_family(study().dots(), study().family);
  }
  LessonRun run;
  EffectGraph effects;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StudyPicture, EachDotWithAnErrorIsAMarkThatKnowsWhichItIs) {
  const Shown shown;
  const std::vector<StudyDot> family = shown.family();
  const Plot plot = study_plot(family);
  std::size_t points = 0;
  for (const PlotSeries& series : plot.series) {
    if (!series.has_symbols) continue;
    ASSERT_EQ(series.points.size(), series.subjects.size());
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const StudyDot& dot = family[static_cast<std::size_t>(series.subjects[i].x)];
      EXPECT_EQ(series.points[i], plotted(dot)) << dot.configuration;
      EXPECT_EQ(series.style, style_of(dot)) << dot.configuration;
    }
    points += series.points.size();
  }
  EXPECT_EQ(points, std::count_if(family.begin(), family.end(),
                                  [](const StudyDot& dot) { return dot.error.has_value(); }));
}

TEST(StudyPicture, TheFrontGoesDownToTheRight) {
  const Shown shown;
  const std::vector<StudyDot> front = front_of(shown.family());
  ASSERT_GE(front.size(), 3u);
  for (std::size_t i = 1; i < front.size(); ++i) {
    EXPECT_LT(front[i - 1].ns, front[i].ns);
    EXPECT_GT(*front[i - 1].error, *front[i].error);
  }
  const Plot plot = study_plot(shown.family());
  const PlotSeries& line = plot.series.back();
  EXPECT_FALSE(line.has_symbols);
  ASSERT_EQ(line.points.size(), front.size());
  EXPECT_EQ(line.points.front(), plotted(front.front()));
}

TEST(StudyPicture, MarksComeOneByOneAndStayWhereTheyAre) {
  const Shown shown;
  std::size_t named = 0;
  std::set<std::string> names;
  for (const Frame& frame : shown.run.frames) {
    const StudyStage stage = study_frame(shown.run, frame)->stage;
    if (frame.question >= 0 || (stage != StudyStage::time_axis && stage != StudyStage::mark))
      continue;
    const Plot plot = study_plot(shown.study(), *study_frame(shown.run, frame));
    ASSERT_EQ(plot.notes.size(), std::max<std::size_t>(2, named + 1));
    named = plot.notes.size();
    for (const PlotNote& note : plot.notes) {
      EXPECT_EQ(note.at, plotted(shown.study().dot(note.text)));
      names.insert(note.text);
    }
  }
  EXPECT_EQ(names.size(), shown.study().marks.size());
}

TEST(StudyPicture, TheFrameOfAllShowsEveryDotAndTheWholeFront) {
  const Shown shown;
  const std::vector<StudyDot> family = shown.family();
  const Plot plot =
      study_plot(shown.study(), {StudyStage::all, static_cast<int>(shown.study().marks.size())});
  std::set<int> dots;
  for (const PlotSeries& series : plot.series) {
    for (const Subject& subject : series.subjects) dots.insert(subject.x);
  }
  EXPECT_EQ(dots.size(), std::count_if(family.begin(), family.end(),
                                       [](const StudyDot& dot) { return dot.error.has_value(); }));
  EXPECT_EQ(plot.notes.size(), front_of(family).size());
}

TEST(StudyPicture, FramesTellTimesAsTheyWereMeasured) {
  Shown shown;
  const std::vector<FrameText> texts = lesson_texts(shown.run, shown.effects);
  int count = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Frame& frame = shown.run.frames[i];
    if (frame.question >= 0 || study_frame(shown.run, frame)->stage != StudyStage::mark) continue;
    const StudyDot dot = introduced(shown.study(), study_frame(shown.run, frame)->marks).back();
    SCOPED_TRACE(texts[i].caption);
    EXPECT_TRUE(
        holds(texts[i].caption, dot.configuration + ": " + time_text(dot.ns) + " for a pair"));
    EXPECT_TRUE(holds(texts[i].caption, error_words(dot)));
    EXPECT_EQ(holds(texts[i].detail, "\"overlap or not\" wrong"), dot.wrong > 0);
    ++count;
  }
  EXPECT_EQ(count, static_cast<int>(shown.study().marks.size()) - 2);
  for (const FrameText& text : texts) {
    EXPECT_FALSE(holds(text.caption + text.detail, "at most"));
    EXPECT_FALSE(holds(text.caption + text.detail, "Pareto"));
  }
}

TEST(StudyPicture, TheMachineIsNamed) {
  Shown shown;
  const std::vector<FrameText> texts = lesson_texts(shown.run, shown.effects);
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [&](const FrameText& text) {
    return holds(text.caption, shown.study().processor());
  }));
}

/// The shipped pair is what the first frames say: nearly parallel, closest at one end, in float at
/// the other, and right in double.
TEST(StudyPicture, ThePairIsHardForFloatAndNotForDouble) {
  Shown shown;
  const auto& pair = shown.effects.get<RoundedPair>(shown.run.frames.front());
  ASSERT_EQ(pair.facing.size(), 4u);
  EXPECT_GT(pair.tilt, 0.0);
  EXPECT_LT(pair.tilt, 1e-7);
  EXPECT_GT(pair.distance(), 0.0);
  EXPECT_EQ(pair.ends[0].exact.length, pair.distance());
  EXPECT_LT(pair.ends[0].exact.length, pair.ends[1].exact.length);
  EXPECT_GT(pair.ends[0].in_float.length, pair.ends[1].in_float.length);
  const double in_float = pair.in_float.trace.result.distance;
  EXPECT_GT(error_of(in_float, pair.distance()), 0.1);
  EXPECT_LT(error_of(pair.in_double.trace.result.distance, pair.distance()), 1e-12);
  EXPECT_GE(pair.magnification(), 1000.0);
  // A frame shows both gaps, and what tells them apart.
  EXPECT_GT(std::abs(in_float - pair.distance()) * pair.magnification(), 0.1);
}

TEST(StudyPicture, ErrorsAreSharesOfTheLarger) {
  EXPECT_EQ(error_of(3.0, 4.0), 0.25);
  EXPECT_EQ(error_of(4.0, 3.0), 0.25);
  EXPECT_EQ(error_of(0.0, 0.0), 0.0);
  EXPECT_EQ(error_of(0.0, 2.0), 1.0);
}

TEST(StudyWords, NumbersHavePowersWhereTheyNeedThem) {
  EXPECT_EQ(power_text(1.987234e-7, 3), "1.99·10⁻⁷");
  EXPECT_EQ(power_text(0.362, 2), "0.36");
  EXPECT_EQ(power_text(0.0, 3), "0");
}

StudyDot dot(const std::string& name, double ns, double error, const std::string& proof = "none") {
  StudyDot out;
  out.configuration = name;
  out.ns = ns;
  out.error = error;
  out.proof = proof;
  return out;
}

TEST(StudyWords, AMarkIsBeatenByTheFastestThatIsNoWorse) {
  const std::vector<StudyDot> dots = {dot("a", 10.0, 1e-3), dot("b", 20.0, 1e-6),
                                      dot("c", 30.0, 1e-5)};
  EXPECT_FALSE(beaten_by(dots[0], dots));
  EXPECT_FALSE(beaten_by(dots[1], dots));
  ASSERT_TRUE(beaten_by(dots[2], dots));
  EXPECT_EQ(beaten_by(dots[2], dots)->configuration, "b");
  EXPECT_EQ(front_among(dots).size(), 2u);
}

TEST(StudyWords, ChoicesAreTheFastestThatDo) {
  const std::vector<Choice> found = choices(
      {dot("slow", 99.0, 1e-16, "exact"), dot("fast", 10.0, 1e-4), dot("good", 20.0, 1e-9)});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].need, "1 to 3 right digits");
  EXPECT_EQ(found[0].dot.configuration, "fast");
  EXPECT_EQ(found[1].need, "4 to 8 right digits");
  EXPECT_EQ(found[1].dot.configuration, "good");
  EXPECT_EQ(found[2].need, "9 to 15 right digits");
  EXPECT_EQ(found[2].dot.configuration, "slow");
  EXPECT_EQ(found[3].dot.configuration, "slow") << "the only one that is proved";
}

TEST(StudyQuestions, AreAnsweredByTheNextFrame) {
  Shown shown;
  const std::vector<FrameText> texts = lesson_texts(shown.run, shown.effects);
  int asked = 0;
  for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
    if (!texts[i].question) continue;
    const FrameQuestion& question = *texts[i].question;
    EXPECT_EQ(std::count(question.choices.begin(), question.choices.end(), question.answer), 1);
    EXPECT_TRUE(texts[i + 1].caption.starts_with("Answer: " + question.answer + ". "))
        << texts[i + 1].caption;
    ++asked;
  }
  EXPECT_EQ(asked, 2);
}

TEST(StudyPicture, OtherLessonsRunNoPairInThreeScalars) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  EffectGraph effects(run);
  static_cast<void>(lesson_texts(run, effects));
  EXPECT_EQ(effects.count(RoundedPair::kName).runs, 0);
}

}  // namespace study_test
}  // namespace gjkscope
