#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "subjects/regions/region_orders.hpp"
#include "subjects/regions/sign_map.hpp"
#include "subjects/subjects.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope {
namespace maps_test {

using Eigen::Vector2d;

/// Q among the corners of an acute or an obtuse triangle.
LessonRun triangle_and(const Vector2d& q, bool obtuse) {
  Lesson lesson;
  lesson.x() = {"Q", {"Q"}, {{0.0, 0.0, 0.0}}, in_space(q), 0.0};
  const Vector2d c = obtuse ? Vector2d(3.5, 1.5) : Vector2d(0.5, 1.5);
  lesson.y() = {"ABC",
                {"A", "B", "C"},
                {{-1.0, -1.0, 0.0}, {2.0, -0.5, 0.0}, in_space(c)},
                Eigen::Vector3d::Zero(),
                0.0};
  lesson.options.start = {{{{0, 0}, {0, 1}, {0, 2}, {}}}, 3};
  lesson.tour = "orders";
  return run_lesson(lesson);
}

bool holds_origin(const std::vector<HalfPlane>& half_planes) {
  return std::all_of(half_planes.begin(), half_planes.end(), [](const HalfPlane& half_plane) {
    return half_plane.normal.dot(-half_plane.point) <= 0.0;
  });
}

class Maps : public ::testing::TestWithParam<bool> {
 protected:
  /// Calls `check` for many positions of Q.
  template <class Check>
  void each_position(Check check) {
    std::mt19937_64 random(20114);
    std::uniform_real_distribution<double> coordinate(-5.0, 5.0);
    for (int i = 0; i < 2000; ++i) {
      const LessonRun run = triangle_and({coordinate(random), coordinate(random)}, GetParam());
      EffectGraph graph(run);
      check(run, graph, run.frames.back());
    }
  }
};

gjk::Face positive_face(const std::vector<double>& weights) {
  gjk::Face face = 0;
  for (int i = 0; i < 3; ++i) {
    if (weights[i] > 0.0) face = static_cast<gjk::Face>(face | gjk::face_of(i));
  }
  return face;
}

TEST_P(Maps, EachPointLiesInTheRegionOfItsSigns) {
  each_position([](const LessonRun&, EffectGraph& graph, const Frame& frame) {
    const gjk::Face positive = positive_face(graph.get<BarycentricWeights>(frame).weights);
    int holders = 0;
    for (const SignMap::Region& region : graph.get<SignMap>(frame)) {
      if (!holds_origin(region.half_planes)) continue;
      ++holders;
      EXPECT_EQ(region.positive, positive);
    }
    EXPECT_EQ(holders, 1);
  });
}

TEST_P(Maps, DifferWhereSignsAndClosestFeatureDo) {
  int differences = 0;
  int vertex_by_signs = 0;
  each_position([&](const LessonRun& run, EffectGraph& graph, const Frame& frame) {
    const gjk::Face positive = positive_face(graph.get<BarycentricWeights>(frame).weights);
    const gjk::Face closest = run.state(frame).region;
    int holders = 0;
    for (const MapDifference::Part& part : graph.get<MapDifference>(frame)) {
      if (!holds_origin(part.half_planes)) continue;
      ++holders;
      EXPECT_EQ(part.by_signs, positive);
      EXPECT_EQ(part.closest, closest);
    }
    EXPECT_EQ(holders, positive == closest ? 0 : 1);
    differences += holders;
    vertex_by_signs += holders > 0 && gjk::vertex_count(positive) == 1;
  });
  EXPECT_GT(differences, 200);
  // Two negative coordinates mislead only at an obtuse corner.
  EXPECT_EQ(vertex_by_signs > 0, GetParam());
}

TEST_P(Maps, WholeTestsAreRightInAnyOrder) {
  each_position([](const LessonRun& run, EffectGraph& graph, const Frame& frame) {
    const RegionOrders::Chain& whole = graph.get<RegionOrders>(frame)[2];
    EXPECT_TRUE(whole.whole);
    EXPECT_EQ(whole.region, run.state(frame).region);
    EXPECT_EQ(whole.error, 0.0);
    EXPECT_TRUE(whole.tests.back().holds);
  });
}

TEST_P(Maps, ShortTestsAreRightWithVerticesFirstWhereNoCornerIsObtuse) {
  int wrong = 0;
  each_position([&](const LessonRun& run, EffectGraph& graph, const Frame& frame) {
    const RegionOrders::Chain& chain = graph.get<RegionOrders>(frame)[0];
    EXPECT_EQ(chain.error == 0.0, chain.region == run.state(frame).region);
    wrong += chain.error > 0.0;
  });
  EXPECT_EQ(wrong > 0, GetParam());
}

TEST_P(Maps, ShortTestsWithEdgesFirstTakePointsThatAreOffTheEdge) {
  int wrong = 0;
  each_position([&](const LessonRun& run, EffectGraph& graph, const Frame& frame) {
    const RegionOrders::Chain& chain = graph.get<RegionOrders>(frame)[1];
    if (chain.region == run.state(frame).region) return;
    ++wrong;
    EXPECT_EQ(gjk::vertex_count(chain.region), 2);
    EXPECT_NEAR(chain.error, (chain.p - run.state(frame).p).norm(), 1e-15);
    EXPECT_GT(chain.error, 0.0);
    if (!GetParam()) {
      // Off the edge, and nearer to Q than the triangle is.
      EXPECT_TRUE(std::any_of(chain.weights.begin(), chain.weights.end(),
                              [](double weight) { return weight < 0.0; }));
    }
  });
  EXPECT_GT(wrong, 500);
}

INSTANTIATE_TEST_SUITE_P(Corners, Maps, ::testing::Bool(), [](const auto& corner) {
  return std::string(corner.param ? "Obtuse" : "Acute");
});

TEST(RegionOrders, ADegenerateTriangleHasNone) {
  Lesson lesson = triangle_and({1.0, 1.0}, false).lesson;
  lesson.y().vertices[2] = {0.5, -0.75, 0.0};
  const LessonRun run = run_lesson(lesson);
  EffectGraph graph(run);
  EXPECT_TRUE(graph.get<RegionOrders>(run.frames[0]).empty());
}

}  // namespace maps_test
}  // namespace gjkscope
