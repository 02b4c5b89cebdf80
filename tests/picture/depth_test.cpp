// Frames of the expanding polygon: what they say is what the trace found.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <random>

#include "frames/frame.hpp"
#include "frames/stage.hpp"
#include "lesson/names.hpp"
#include "lessons.hpp"
#include "picture/words.hpp"
#include "subjects/depth/lesson_trace.hpp"
#include "texts.hpp"

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
    const std::vector<FrameText> texts = testing::texts_of(run);
    EXPECT_EQ(texts.front().phase, "start");
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      EXPECT_EQ(texts[i + 1].iteration, trace.steps[i].iteration);
      EXPECT_EQ(texts[i + 1].phase,
                run.tour->algorithm->phases[static_cast<std::size_t>(trace.steps[i].phase)]);
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
    const std::vector<FrameText> texts = testing::texts_of(run);
    int asked = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].question || texts[i].question->ask != "edge") continue;
      ++asked;
      const FrameQuestion& question = *texts[i].question;
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
    EXPECT_EQ(run.frames.size(), 11u) << "with two questions";
  }
}

using Eigen::Vector3d;

const std::vector<std::string> kLessonsInSpace = {"depth-in-space", "depth-boxes"};

TEST(DepthFramesInSpace, GoThroughEveryStepAndEndWithTheAnswer) {
  for (const std::string& id : kLessonsInSpace) {
    SCOPED_TRACE(id);
    Lesson lesson = testing::shipped_lesson(id);
    lesson.questions.clear();
    const LessonRun run = run_lesson(lesson);
    const DepthTraceInSpace& trace = *depth_trace_in_space(run, 0);
    EXPECT_EQ(depth_trace(run, 0), nullptr);
    ASSERT_EQ(run.frames.size(), trace.steps.size() + 2);
    const std::vector<FrameText> texts = testing::texts_of(run);
    double upper = HUGE_VAL;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const auto& step = trace.steps[i];
      EXPECT_EQ(texts[i + 1].iteration, step.iteration);
      EXPECT_EQ(value_of_text(texts[i + 1], "lower"), Numbers(lesson)(step.bounds.lower));
      EXPECT_LE(step.bounds.lower, trace.result.upper);
      if (!(step.bounds.upper >= 0.0)) continue;
      EXPECT_GE(step.bounds.upper, trace.result.lower);
      EXPECT_LE(step.bounds.upper, upper);
      upper = step.bounds.upper;
    }
    EXPECT_EQ(value_of_text(texts.back(), "depth"),
              Numbers(lesson)(lesson.expect.answers.at(0).second));
  }
}

/// Beyond the plane of a face, counter-clockwise seen from outside.
bool lies_beyond(const depth::space::State<double>& state, int face, const Vector3d& p) {
  const auto& of = state.polytope.faces[static_cast<std::size_t>(face)];
  const Vector3d& a = state.polytope.at(of, 0);
  return (state.polytope.at(of, 1) - a).cross(state.polytope.at(of, 2) - a).dot(p - a) > 1e-9;
}

TEST(DepthFramesInSpace, DropTheFacesThatTheSupportPointLiesBeyond) {
  int expansions = 0;
  for (const std::string& id : kLessonsInSpace) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    const DepthTraceInSpace& trace = *depth_trace_in_space(run, 0);
    for (std::size_t i = 0; i + 1 < trace.steps.size(); ++i) {
      if (trace.steps[i + 1].phase != depth::Phase::expand) continue;
      ++expansions;
      const auto& before = trace.steps[i].after;
      const auto& gone = trace.steps[i + 1].record.outgrown;
      for (std::size_t face = 0; face < before.polytope.faces.size(); ++face) {
        if (before.polytope.faces[face].is_outgrown) continue;
        const bool is_gone =
            std::find(gone.begin(), gone.end(), static_cast<int>(face)) != gone.end();
        EXPECT_EQ(is_gone, lies_beyond(before, static_cast<int>(face), before.support.w));
      }
    }
  }
  EXPECT_GE(expansions, 4);
}

TEST(DepthFramesInSpace, AskForFacesBeforeTheyAreTold) {
  int nearest = 0;
  int visible = 0;
  for (const std::string& id : kLessonsInSpace) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    const std::vector<FrameText> texts = testing::texts_of(run);
    const DepthTraceInSpace& trace = *depth_trace_in_space(run, 0);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].question || run.frames[i].answering_step < 0) continue;
      const FrameQuestion& question = *texts[i].question;
      const auto& state = trace.steps[static_cast<std::size_t>(run.frames[i].answering_step)].after;
      const auto face_of = [&](const std::string& name) {
        int face = 0;
        while (face_name(trace, face) != name) ++face;
        return face;
      };
      if (question.ask == "face") {
        ++nearest;
        EXPECT_EQ(question.answer, value_of_text(texts[i + 1], "face"));
        EXPECT_NE(value_of_text(texts[i], "face"), question.answer) << "told too early";
        const auto& faces = state.polytope.faces;
        for (const std::string& choice : question.choices)
          EXPECT_GE(faces[static_cast<std::size_t>(face_of(choice))].distance_sq,
                    faces[static_cast<std::size_t>(state.face)].distance_sq);
      } else if (question.ask == "visible-face") {
        ++visible;
        for (const std::string& choice : question.choices)
          EXPECT_EQ(choice == question.answer,
                    lies_beyond(state, face_of(choice), state.support.w));
      }
    }
  }
  EXPECT_GE(nearest, 1);
  EXPECT_GE(visible, 2);
}

TEST(DepthFramesInSpace, TouchingInAFaceAnEdgeAndAVertexHasDepthZeroExactly) {
  Lesson lesson = testing::shipped_lesson("depth-touching-in-space");
  for (const ScalarKind scalar : {ScalarKind::double_, ScalarKind::exact}) {
    lesson.scalar = scalar;
    const LessonRun run = run_lesson(lesson);
    ASSERT_EQ(run.runs.size(), 3u);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(run.runs[static_cast<std::size_t>(i)].trace.result.simplex.count, 3 - i);
      EXPECT_EQ(depth_result(run, i)->depth, 0.0);
      EXPECT_EQ(depth_result(run, i)->verdict, gjk::Verdict::touching);
    }
  }
}

TEST(DepthFramesInSpace, HaveWordsAndPicturesForAnyShapes) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  std::mt19937 bits(7);
  const auto lattice = [&](int most) {
    return static_cast<double>(bits() % static_cast<unsigned>(2 * most + 1)) - most;
  };
  std::map<std::string, int> seen;
  for (int round = 0; round < 60; ++round) {
    Lesson lesson = testing::shipped_lesson("depth-in-space");
    lesson.questions.clear();
    lesson.options.start = {};
    lesson.scalar = round % 3 == 0 ? ScalarKind::exact : ScalarKind::double_;
    for (std::size_t body = 0; body < 2; ++body) {
      LessonShape& shape = lesson.bodies[body];
      // Often flat, on a line or a single point, and often the same point twice.
      const int most_z = round % 4 == 1 ? 0 : 2;
      shape.vertices.clear();
      shape.vertex_names.clear();
      for (int i = 0; i < 1 + (round + static_cast<int>(body)) % 6; ++i) {
        const double x = lattice(2);
        const double y = lattice(2);
        shape.vertices.emplace_back(x, y, lattice(most_z));
        shape.vertex_names.push_back((body == 0 ? "x" : "y") + std::to_string(i));
      }
    }
    const LessonRun run = run_lesson(std::move(lesson));
    ++seen[std::string(name_of(depth_result(run, 0)->verdict))];
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, fonts))
      EXPECT_FALSE(frame.text.caption.empty());
  }
  for (const char* verdict : {"separated", "touching", "overlapping"})
    EXPECT_GT(seen[verdict], 2) << verdict;
}

}  // namespace depth_test
}  // namespace gjkscope
