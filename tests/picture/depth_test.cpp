// Frames of the expanding polygon: what they say is what the trace found.

#include <gtest/gtest.h>

#include <filesystem>

#include "frames/frame.hpp"
#include "frames/stage.hpp"
#include "lessons.hpp"
#include "picture/words.hpp"
#include "subjects/depth/lesson_trace.hpp"

namespace gjkscope {
namespace depth_test {

const std::vector<std::string> kLessons = {"penetration-depth", "penetration-nested",
                                           "penetration-touching", "penetration-identical"};

std::string value_of_text(const FrameText& text, const std::string& name) {
  for (const auto& [key, value] : text.values) {
    if (key == name) return value;
  }
  return {};
}

TEST(DepthFrames, GoThroughEveryStepAndEndWithTheAnswer) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    Lesson lesson = testing::shipped_lesson(id);
    lesson.questions.clear();
    const LessonRun run = run_lesson(lesson);
    const DepthTrace& trace = *depth_trace(run, 0);
    ASSERT_EQ(run.frames.size(), trace.steps.size() + 2);
    EffectGraph effects(run);
    const std::vector<FrameText> texts = lesson_texts(run, effects);
    EXPECT_EQ(texts.front().phase, "start");
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      EXPECT_EQ(texts[i + 1].iteration, trace.steps[i].iteration);
      EXPECT_EQ(texts[i + 1].phase,
                run.act->algorithm->phases[static_cast<std::size_t>(trace.steps[i].phase)]);
      EXPECT_EQ(value_of_text(texts[i + 1], "lower"), Numbers(lesson)(trace.steps[i].bounds.lower));
    }
    EXPECT_EQ(texts.back().phase, "answer");
    EXPECT_EQ(value_of_text(texts.back(), "depth"),
              Numbers(lesson)(lesson.expect.answers.at(0).second));
  }
}

TEST(DepthFrames, AViewWithoutACameraHasRoomForXMovedByT) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    Lesson lesson = testing::shipped_lesson(id);
    for (LessonView& view : lesson.views) view.camera.reset();
    const LessonRun run = run_lesson(lesson);
    const Rect card{{0.0, 0.0}, {400.0, 400.0}};
    const Camera camera = camera_of(run, run.lesson.views[0], card);
    for (const Eigen::Vector2d& vertex : in_plane(run.runs[0].x().world)) {
      const Eigen::Vector2d at =
          vertex + depth_trace(run, 0)->result.translation - in_plane(camera.center);
      EXPECT_LT(at.cwiseAbs().maxCoeff(), 0.5 * camera.height);
    }
  }
}

TEST(DepthFrames, BoundsCloseInOnTheAnswer) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    const DepthTrace& trace = *depth_trace(run, 0);
    depth::Bounds<double> last;
    for (const depth::Step<double>& step : trace.steps) {
      EXPECT_GE(step.bounds.lower, last.lower);
      if (last.upper >= 0.0) {
        EXPECT_LE(step.bounds.upper, last.upper);
      }
      EXPECT_LE(step.bounds.lower, trace.result.upper);
      if (step.bounds.upper >= 0.0) {
        EXPECT_GE(step.bounds.upper, trace.result.lower);
      }
      last = step.bounds;
    }
  }
}

TEST(DepthFrames, AskForTheNearestEdgeBeforeItIsTold) {
  for (const char* id : {"penetration-depth", "penetration-nested", "penetration-identical"}) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    EffectGraph effects(run);
    const std::vector<FrameText> texts = lesson_texts(run, effects);
    int asked = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].question) continue;
      ++asked;
      const FrameQuestion& question = *texts[i].question;
      EXPECT_EQ(question.ask, "edge");
      EXPECT_EQ(question.answer, value_of_text(texts[i + 1], "edge"));
      EXPECT_NE(value_of_text(texts[i], "edge"), question.answer) << "told too early";
      // No edge that there is to choose from is nearer.
      const depth::Step<double>& step =
          depth_trace(run, 0)->steps[static_cast<std::size_t>(run.frames[i].answering_step)];
      ASSERT_EQ(question.choices.size(), step.record.edges.size());
      for (const depth::Edge<double>& edge : step.record.edges)
        EXPECT_GE(edge.distance_sq, step.after.edge.distance_sq);
    }
    EXPECT_EQ(asked, 2);
  }
}

TEST(DepthFrames, ShapesApartHaveOneFrameThatSaysSo) {
  Lesson lesson = testing::shipped_lesson("penetration-depth");
  lesson.opening.clear();
  lesson.x().translate = {-9.0, 0.0, 0.0};
  const LessonRun run = run_lesson(lesson);
  ASSERT_EQ(run.frames.size(), 1u);
  EXPECT_EQ(depth_trace(run, 0)->result.stop, depth::StopReason::separated);
  EffectGraph effects(run);
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts);
  EXPECT_TRUE(frames[0].text.caption.starts_with("X and Y do not overlap: they are "));
}

TEST(DepthFrames, AreTheSameInEveryScalarThatHoldsTheShapes) {
  Lesson lesson = testing::shipped_lesson("penetration-touching");
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    lesson.scalar = scalar;
    const LessonRun run = run_lesson(lesson);
    EXPECT_EQ(depth_trace(run, 0)->result.depth, 0.0);
    EXPECT_EQ(depth_trace(run, 0)->result.verdict, gjk::Verdict::touching);
    EXPECT_EQ(run.frames.size(), 10u) << "with a question";
  }
}

}  // namespace depth_test
}  // namespace gjkscope
