// Voronoi regions of features, held to the closest points that GJK finds.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "gjk/gjk.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "subjects/feature_regions/lesson_trace.hpp"

namespace gjkscope {
namespace feature_regions_test {

using cells::Feature;
using cells::Kind;
using Eigen::Vector3d;
using Phase = RegionsTrace::Phase;
using Points = std::vector<Vector3d>;

class Bodies {
 public:
  explicit Bodies(int seed) : bits_(static_cast<unsigned>(seed)) {}
  Vector3d point(double size) {
    Vector3d out;
    for (double& each : out) each = std::uniform_real_distribution<double>(-size, size)(bits_);
    return out;
  }
  Points body(int count, const Vector3d& shift = Vector3d::Zero()) {
    Points points;
    for (int i = 0; i < count; ++i) points.emplace_back(point(1.0) + shift);
    return points;
  }

 private:
  std::mt19937 bits_;
};

double distance(const Points& x, const Points& y) {
  return gjk::distance<double>(gjk::Query<double, 3>{{x}, {y}}).distance;
}

double to_feature(const Feature& feature, const Points& points, const Vector3d& q) {
  Points corners;
  for (const int vertex : feature.vertices)
    corners.push_back(points[static_cast<std::size_t>(vertex)]);
  return distance({q}, corners);
}

TEST(FeatureRegions, HoldThePointsWhoseClosestPointLiesOnTheFeature) {
  Bodies random(26);
  std::array<int, 3> held = {};
  for (int round = 0; round < 60; ++round) {
    const Points points = random.body(4 + round % 12);
    const Polyhedron hull = exact_hull(points);
    const std::vector<Feature> features = cells::features_of(hull, points);
    ASSERT_EQ(features.size(), 2 * hull.edges.size() + 2);  // V - E + F = 2
    for (int i = 0; i < 60; ++i) {
      const Vector3d q = random.point(3.0);
      const double expected = distance({q}, points);
      if (expected < 1e-6) continue;
      const Feature& found = features[static_cast<std::size_t>(cells::holding(features, q))];
      EXPECT_GE(found.tightest(q).depth(q), -1e-9) << "round " << round;
      EXPECT_NEAR(to_feature(found, points, q), expected, 1e-9) << "round " << round;
      ++held[static_cast<std::size_t>(found.kind())];
      for (const Feature& other : features) {
        if (&other == &found) continue;
        EXPECT_LE(other.tightest(q).depth(q), 1e-9) << "round " << round;
      }
    }
  }
  for (const int count : held) EXPECT_GT(count, 200);
}

TEST(FeatureRegions, BeyondAPlaneOfAVertexTheEdgeIsCloser) {
  Bodies random(7);
  for (int round = 0; round < 40; ++round) {
    const Points points = random.body(4 + round % 12);
    const std::vector<Feature> features = cells::features_of(exact_hull(points), points);
    const Vector3d q = random.point(3.0);
    if (distance({q}, points) < 1e-6) continue;
    for (const Feature& feature : features) {
      if (feature.kind() != Kind::vertex) continue;
      for (const cells::Border& border : feature.borders) {
        if (border.depth(q) > -1e-6) continue;
        const Feature& beyond = features[static_cast<std::size_t>(border.beyond)];
        EXPECT_LT(to_feature(beyond, points, q), to_feature(feature, points, q));
      }
    }
  }
}

TEST(FeatureRegions, OfABoxAreSixPrismsTwelveWedgesAndEightCones) {
  const LessonRun run = run_lesson(testing::shipped_lesson("regions-of-a-box"));
  const RegionsTrace& trace = regions_trace(*run.algorithm_traces[0]);
  EXPECT_EQ(trace.count(Kind::face), 6);
  EXPECT_EQ(trace.count(Kind::edge), 12);
  EXPECT_EQ(trace.count(Kind::vertex), 8);
  for (const Feature& feature : trace.features[1]) {
    const std::size_t planes = feature.kind() == Kind::vertex ? 3
                               : feature.kind() == Kind::edge ? 4
                                                              : 5;
    EXPECT_EQ(feature.borders.size(), planes);
  }
  EXPECT_EQ(trace.answer("regions"), 26.0);
}

TEST(LocalVerification, HoldsForTheClosestPointsAndRefutesOthers) {
  const Lesson shipped = testing::shipped_lesson("local-verification");
  Bodies random(5);
  int refuted = 0;
  for (int round = 0; round < 60; ++round) {
    Lesson lesson = shipped;
    lesson.questions.clear();
    lesson.expect = {};
    lesson.bodies[0].vertices = random.body(5, Vector3d(-2.5, 0.0, 0.0));
    lesson.bodies[1].vertices = random.body(5, Vector3d(1.0, 0.0, 0.0));
    const LessonRun run = run_lesson(std::move(lesson));
    const RegionsTrace& trace = regions_trace(*run.algorithm_traces[0]);
    for (const RegionsTrace::Step& step : trace.all) {
      if (step.phase != Phase::region) continue;
      const double depth = trace.border(step).depth(trace.point(step));
      if (step.pair == 0) {
        refuted += depth < 0.0 ? 1 : 0;
      } else {
        EXPECT_GE(depth, -1e-9) << "round " << round;
      }
    }
    ASSERT_EQ(trace.pairs.size(), 2u);
    EXPECT_LE(trace.pairs[1].distance(), trace.pairs[0].distance() + 1e-12);
    EXPECT_EQ(trace.reaches.empty(), trace.all.back().phase != Phase::pair);
  }
  EXPECT_GT(refuted, 30);
}

TEST(FeatureRegions, HaveWordsAndPicturesForAnyShapes) {
  Bodies random(4);
  int flat = 0;
  for (int round = 0; round < 40; ++round) {
    Lesson lesson =
        testing::shipped_lesson(round % 2 == 0 ? "regions-of-a-box" : "local-verification");
    lesson.questions.clear();
    lesson.options.start = {};
    const double size = round % 8 > 5 ? 1e15 : round % 8 > 3 ? 1e-100 : 1.0;
    for (std::size_t i = lesson.bodies[0].vertices.size() == 1 ? 1 : 0; i < 2; ++i) {
      LessonShape& shape = lesson.bodies[i];
      shape.vertices = random.body(1 + (round + 3 * static_cast<int>(i)) % 9,
                                   round % 3 == 0 ? Vector3d::Zero() : Vector3d(2.0 * i, 0.0, 0.0));
      shape.vertex_names.clear();
      for (std::size_t k = 0; k < shape.vertices.size(); ++k) {
        shape.vertices[k] *= size;
        shape.vertex_names.push_back(fmt::format("{}{}", i == 0 ? "x" : "y", k));
      }
    }
    LessonRun run = run_lesson(std::move(lesson));
    if (!why_not_drawn(run.runs[0]).empty()) continue;
    flat += regions_trace(*run.algorithm_traces[0]).pairs.empty() ? 1 : 0;
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, testing::fonts()))
      EXPECT_FALSE(frame.text.caption.empty());
  }
  EXPECT_GT(flat, 3);
}

TEST(FeatureRegions, AreOfSpaceAlone) {
  std::string text = lesson_toml(testing::shipped_lesson("stop-vertex"));
  text.insert(text.find("[[views]]"), "[steps]\ntour = \"feature-regions\"\n\n");
  const LoadedLesson loaded = parse_lesson(text, "lessons/plane.toml", vocabulary());
  EXPECT_NE(to_string(loaded.problems).find("tour 'feature-regions' in the plane"),
            std::string::npos)
      << to_string(loaded.problems);
}

}  // namespace feature_regions_test
}  // namespace gjkscope
