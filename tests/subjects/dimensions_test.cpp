// Views of one, two and three dimensions: the runs on the line and in the plane are those of the
// shapes pressed flat, and weights are fractions of lengths, areas and volumes.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "gjk/gjk.hpp"
#include "lessons.hpp"
#include "subjects/dimensions/runs.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope {
namespace dimensions_test {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::shipped_lesson;

class Places {
 public:
  Vector3d any() { return {coordinate_(random_), coordinate_(random_), coordinate_(random_)}; }

 private:
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> coordinate_{-1.0, 1.0};
};

TEST(Dimensions, RunsAreThoseOfTheShapesPressedFlat) {
  Places places;
  Lesson lesson = shipped_lesson("dimension-m");
  int most = 0;
  for (int round = 0; round < 60; ++round) {
    for (LessonShape& shape : lesson.bodies) {
      for (Vector3d& vertex : shape.vertices) vertex = places.any();
      shape.axis = places.any();
      shape.rotate_degrees = 90.0 * places.any().x();
    }
    lesson.x().translate = 2.0 * places.any();
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    const FlatRuns::Value& flat = effects.get<FlatRuns>(run.frames[0]);
    ASSERT_EQ(flat.size(), 2u);
    const PositionedRun& whole = run.runs.front();
    // Between two intervals.
    const auto [x_low, x_high] =
        std::minmax_element(whole.x().world.begin(), whole.x().world.end(),
                            [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
    const auto [y_low, y_high] =
        std::minmax_element(whole.y().world.begin(), whole.y().world.end(),
                            [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
    const double gap = std::max({0.0, y_low->x() - x_high->x(), x_low->x() - y_high->x()});
    EXPECT_NEAR(flat[0].run->runs.front().trace.result.distance, gap, 1e-12);
    const std::vector<Vector2d> x = in_plane(whole.x().world);
    const std::vector<Vector2d> y = in_plane(whole.y().world);
    EXPECT_NEAR(flat[1].run->runs.front().trace.result.distance,
                gjk::distance(gjk::Query<double, 2>{{x}, {y}}).distance, 1e-12);
    for (std::size_t m = 1; m <= 2; ++m) {
      for (const WideStep& step : flat[m - 1].run->runs.front().trace.steps)
        EXPECT_LE(step.after.simplex.count, static_cast<int>(m) + 1);
    }
    for (const WideStep& step : whole.trace.steps) most = std::max(most, step.after.simplex.count);
  }
  EXPECT_EQ(most, 4);
}

TEST(Dimensions, FramesGoToTheEndOfEachRun) {
  const LessonRun run = run_lesson(shipped_lesson("dimension-m"));
  EffectGraph effects(run);
  for (std::size_t view = 0; view < 3; ++view) {
    const FrameInView in = run.tour->in_view(run, effects, run.frames.back(), view);
    const PositionedRun& positioned = in.run->runs.front();
    EXPECT_EQ(in.frame.step + 1, static_cast<int>(positioned.trace.steps.size()));
    EXPECT_NE(positioned.trace.steps.back().after.stop, gjk::StopReason::running);
  }
}

TEST(Fractions, AreSignedLengthsAreasAndVolumes) {
  Places places;
  Lesson lesson = shipped_lesson("length-area-volume");
  for (int round = 0; round < 60; ++round) {
    for (Vector3d& vertex : lesson.y().vertices) vertex = places.any();
    for (Vector3d& point : lesson.path_of_shapes->x().points) point = 2.0 * places.any();
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    const std::vector<Vector3d>& v = lesson.y().vertices;
    for (const Frame& frame : run.frames) {
      if (frame.part < 0) continue;
      const Vector3d& q = lesson.path_of_shapes->x().points[static_cast<std::size_t>(frame.run)];
      const FirstVertices::Value& lessers = effects.get<FirstVertices>(frame);
      ASSERT_EQ(lessers.size(), 2u);
      const auto weights = [&](std::size_t k) {
        return k < 2 ? lessers[k].effects->get<BarycentricWeights>(frame).weights
                     : effects.get<BarycentricWeights>(frame).weights;
      };
      const Vector3d edge = v[1] - v[0];
      EXPECT_NEAR(weights(0)[0], (v[1] - q).dot(edge) / edge.squaredNorm(), 1e-9);
      const Vector3d normal = edge.cross(v[2] - v[0]);
      EXPECT_NEAR(weights(1)[0], (v[1] - q).cross(v[2] - q).dot(normal) / normal.squaredNorm(),
                  1e-9);
      const auto volume = [](const Vector3d& a, const Vector3d& b, const Vector3d& c,
                             const Vector3d& d) { return (b - a).cross(c - a).dot(d - a); };
      EXPECT_NEAR(weights(2)[0], volume(q, v[1], v[2], v[3]) / volume(v[0], v[1], v[2], v[3]),
                  1e-7);
    }
  }
}

}  // namespace dimensions_test
}  // namespace gjkscope
