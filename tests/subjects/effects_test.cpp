#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <sstream>

#include "lessons.hpp"
#include "run/effect_info.hpp"
#include "run/facts.hpp"
#include "subjects/difference/minkowski.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/run/history.hpp"
#include "subjects/run/other_normal.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/run/voronoi.hpp"
#include "subjects/scalars/every_scalar.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/shape_hull/shape_hull.hpp"
#include "subjects/subjects.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope {
namespace effects_test {

using Eigen::Vector2d;
using testing::shipped_lesson;

Lesson point_and_triangle(const Vector2d& q) {
  Lesson lesson;
  lesson.x() = {"Q", {"Q"}, {{0.0, 0.0, 0.0}}, in_space(q), 0.0};
  lesson.y() = {"ABC",
                {"A", "B", "C"},
                {{-1.0, -1.0, 0.0}, {2.0, -0.5, 0.0}, {0.5, 1.5, 0.0}},
                Eigen::Vector3d::Zero(),
                0.0};
  lesson.options.start = {{{{0, 0}, {0, 1}, {0, 2}, {}}}, 3};
  lesson.tour = "path";
  return lesson;
}

TEST(EffectGraph, ComputesAValueWhenItIsFirstPulledAndNeverOtherwise) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  EffectGraph graph(run);
  for (const EffectInfo* effect : registered_effects())
    EXPECT_EQ(graph.count(effect->name).runs, 0) << effect->name;
  for (const Frame& frame : run.frames) (void)graph.get<MinkowskiHull>(frame);
  EXPECT_EQ(graph.count("minkowski-hull").pulls, static_cast<long>(run.frames.size()));
  EXPECT_EQ(graph.count("minkowski-hull").runs, 1) << "the hull does not depend on the step";
  for (const Frame& frame : run.frames) (void)graph.get<GrownObstacle>(frame);
  EXPECT_EQ(graph.count("grown-obstacle").runs, 1);
  EXPECT_EQ(graph.count("minkowski-hull").pulls, static_cast<long>(run.frames.size()) + 1)
      << "pulled by the grown obstacle, once";
  EXPECT_EQ(graph.count("voronoi-regions").pulls, 0);
}

/// The parts of a support step that a tour outside the program shows.
enum class Half { before, after };

TEST(FramePart, ATourTakesStepsApartByNumbersOfItsOwn) {
  const Tour halves{
      .name = "halves",
      .meaning = "half of a support step",
      .add_frames =
          [](LessonRun& run, int index) {
            const WideTrace& trace = run.runs[static_cast<std::size_t>(index)].trace;
            for (int i = 0; i < static_cast<int>(trace.steps.size()); ++i) {
              if (trace.steps[i].phase != gjk::Phase::support) continue;
              for (const Half half : {Half::before, Half::after})
                run.frames.push_back({.run = index, .step = i, .part = static_cast<int>(half)});
            }
          },
      .algorithm = &kGjkAlgorithm};
  Lesson lesson = shipped_lesson("polygons-gjk");
  lesson.questions.clear();
  const LessonRun run = run_lesson(std::move(lesson), halves);
  ASSERT_EQ(run.frames.size(), 2u * run.runs[0].trace.result.iterations);
  EffectGraph graph(run);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const Frame& frame = run.frames[i];
    const auto half = i % 2 == 0 ? Half::before : Half::after;
    EXPECT_EQ(part_of<Half>(halves, run, frame), half);
    EXPECT_EQ(frame.part, static_cast<int>(half));
    EXPECT_FALSE(support_part(run, frame)) << "the parts of another tour";
    EXPECT_EQ(run.info(frame).phase, "support");
    EXPECT_TRUE(graph.get<FrameFacts>(frame).support);
  }
  EXPECT_EQ(graph.count("facts").runs, static_cast<long>(run.frames.size()))
      << "each part has facts of its own";
  EXPECT_EQ(Frame().part, -1);
}

TEST(EffectRegistry, EffectsHaveNamesOfTheirOwnAndNeedOnlyWhatIsRegistered) {
  std::set<std::string_view> known;
  for (const EffectInfo* effect : registered_effects())
    EXPECT_TRUE(known.insert(effect->name).second) << effect->name;
  for (const EffectInfo* effect : registered_effects()) {
    std::istringstream needs{std::string(effect->needs)};
    for (std::string name; std::getline(needs, name, ',');)
      EXPECT_TRUE(known.contains(name)) << effect->name << " needs " << name;
    EXPECT_FALSE(effect->summary.empty());
  }
}

TEST(VoronoiRegions, EachPointLiesInTheRegionThatTheCoreFinds) {
  std::mt19937_64 random(20101);
  std::uniform_real_distribution<double> coordinate(-4.0, 4.0);
  std::set<gjk::Face> seen;
  for (int i = 0; i < 2000; ++i) {
    const Vector2d q(coordinate(random), coordinate(random));
    const LessonRun run = run_lesson(point_and_triangle(q));
    EffectGraph graph(run);
    const gjk::Face taken = run.state(run.frames[0]).region;
    seen.insert(taken);
    int holders = 0;
    for (const VoronoiRegions::Region& region : graph.get<VoronoiRegions>(run.frames[0])) {
      bool inside = true;
      for (const HalfPlane& plane : region.half_planes)
        inside = inside && plane.normal.dot(-plane.point) <= 0.0;
      if (!inside) continue;
      ++holders;
      EXPECT_EQ(region.face, taken) << "Q = " << q.transpose();
    }
    EXPECT_EQ(holders, 1) << "Q = " << q.transpose();
  }
  EXPECT_EQ(seen.size(), 7u) << "all seven regions occur";
}

TEST(BarycentricWeights, AreFractionalAreasAndAddUpToOne) {
  std::mt19937_64 random(20102);
  std::uniform_real_distribution<double> coordinate(-4.0, 4.0);
  int negative = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector2d q(coordinate(random), coordinate(random));
    const LessonRun run = run_lesson(point_and_triangle(q));
    EffectGraph graph(run);
    const std::vector<double>& weights = graph.get<BarycentricWeights>(run.frames[0]).weights;
    ASSERT_EQ(weights.size(), 3u);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-14);
    const std::vector<Vector2d> y = in_plane(run.runs[0].y().world);
    const Vector2d back = weights[0] * y[0] + weights[1] * y[1] + weights[2] * y[2];
    EXPECT_LT((back - q).norm(), 1e-13);
    const double whole = signed_area(y);
    for (const BarycentricParts::Part& part : graph.get<BarycentricParts>(run.frames[0])) {
      EXPECT_NEAR(signed_area(in_plane(part.points)) / whole, part.weight, 1e-13);
      negative += part.weight < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(negative, 1000) << "most points lie outside";
}

TEST(BarycentricParts, OfASegmentAreItsFractionalLengths) {
  const LessonRun run = run_lesson(shipped_lesson("segment-regions"));
  EffectGraph graph(run);
  for (const Frame& frame : run.frames) {
    const double length = (run.run(frame).y().world[1] - run.run(frame).y().world[0]).norm();
    for (const BarycentricParts::Part& part : graph.get<BarycentricParts>(frame)) {
      ASSERT_EQ(part.points.size(), 2u);
      EXPECT_NEAR((part.points[1] - part.points[0]).norm() / length, std::abs(part.weight), 1e-14);
    }
  }
}

TEST(MinkowskiHull, HoldsTheWholeCloud) {
  const LessonRun run = run_lesson(shipped_lesson("minkowski-build"));
  EffectGraph graph(run);
  const MinkowskiCloud::Value& cloud = graph.get<MinkowskiCloud>(run.frames[0]);
  const MinkowskiHull::Value& hull = graph.get<MinkowskiHull>(run.frames[0]);
  EXPECT_EQ(cloud.size(), 12u);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d a = hull[i].z;
    const Vector2d edge = hull[(i + 1) % hull.size()].z - a;
    for (const CloudPoint& point : cloud) {
      const Vector2d to = point.z - a;
      EXPECT_GE(edge.x() * to.y() - edge.y() * to.x(), -1e-12);
    }
  }
}

TEST(OtherNormal, IsThereWhereQLiesOnTheSegmentAndFindsTheFarthestTheOtherWay) {
  const LessonRun run = run_lesson(shipped_lesson("stop-either-normal"));
  EffectGraph graph(run);
  int found = 0;
  for (const Frame& frame : run.frames) {
    const OtherNormal::Value& other = graph.get<OtherNormal>(frame);
    if (!other) continue;
    ++found;
    EXPECT_EQ(other->d, -run.state(frame).d);
    const std::vector<Vector2d> y = in_plane(run.run(frame).y().world);
    const Vector2d d = in_plane(other->d);
    for (const Vector2d& vertex : y) EXPECT_LE(vertex.dot(d), y[other->support.y].dot(d));
  }
  EXPECT_GT(found, 4);
}

TEST(OtherNormal, IsNotThereWhereTheSideOfQIsKnown) {
  const LessonRun run = run_lesson(shipped_lesson("polygon-evolution"));
  EffectGraph graph(run);
  for (const Frame& frame : run.frames) EXPECT_FALSE(graph.get<OtherNormal>(frame));
}

TEST(History, GrowsByOneEntryAnIteration) {
  const LessonRun run = run_lesson(shipped_lesson("polygon-evolution"));
  EffectGraph graph(run);
  for (const Frame& frame : run.frames) {
    EXPECT_EQ(static_cast<int>(graph.get<History>(frame).size()), run.state(frame).iteration - 1);
  }
}

TEST(DirectionRules, GiveTheSlidesDigitsInSinglePrecision) {
  const LessonRun run = run_lesson(shipped_lesson("direction-roundoff"));
  EffectGraph graph(run);
  const Frame frame = run.frames.back();
  const DirectionRules::Value& rules = graph.get<DirectionRules>(frame);
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_EQ(rules[0].rule, gjk::DirectionRule::towards_origin);
  EXPECT_EQ(rules[0].dot_with_edge, static_cast<double>(3.2457051e-06F));
  EXPECT_EQ(rules[1].dot_with_edge, 0.0);
}

TEST(SecondRun, TheExactRunOfDirectionHalfIsTheOneThatIsRight) {
  const LessonRun run = run_lesson(shipped_lesson("direction-half"));
  EffectGraph graph(run);
  const SecondRun::Value& second = graph.get<SecondRun>(run.frames.back());
  EXPECT_EQ(second.run.x().world, run.runs[0].x().world);
  EXPECT_EQ(second.run.y().world, run.runs[0].y().world);
  ASSERT_GE(second.parting, 0);
  const Frame parting{0, second.parting};
  EXPECT_EQ(run.step(parting).iteration, 1);
  EXPECT_EQ(run.pair_name(run.state(parting).support.pair), "B");
  const WideStep* beside = step_beside(second, run, parting);
  ASSERT_NE(beside, nullptr);
  EXPECT_EQ(run.pair_name(beside->after.support.pair), "C");

  // By the coordinates: Q projected onto BD, and the vertex farthest along Q - P.
  const std::vector<Vector2d> y = in_plane(run.runs[0].y().world);
  const Vector2d q = in_plane(run.runs[0].x().world[0]);
  const Vector2d edge = y[3] - y[1];
  const Vector2d p = y[1] + (q - y[1]).dot(edge) / edge.squaredNorm() * edge;
  int farthest = 0;
  for (int i = 1; i < 5; ++i) {
    if ((q - p).dot(y[farthest]) < (q - p).dot(y[i])) farthest = i;
  }
  EXPECT_EQ(farthest, 2);
  EXPECT_NEAR((in_plane(beside->after.p) + q - p).norm(), 0.0, 1e-12);
  const Vector2d d = in_plane(run.state(parting).d);
  const double degrees = std::acos(d.normalized().dot((q - p).normalized())) * 180.0 / 3.14159265;
  EXPECT_GT(degrees, 40.0) << "to be seen by eye";
  EXPECT_EQ(second.run.trace.result.stop, gjk::StopReason::origin_inside);
}

TEST(SecondRun, InAScalarThatRoundsAlikeTheRunsDoNotPart) {
  Lesson lesson = shipped_lesson("polygon-evolution");
  lesson.settings = TourSettings(LessonSecond{.scalar = ScalarKind::exact});
  const LessonRun run = run_lesson(lesson);
  EffectGraph graph(run);
  EXPECT_EQ(graph.get<SecondRun>(run.frames.back()).parting, -1);
  EXPECT_EQ(step_beside(graph.get<SecondRun>(run.frames[0]), run, {}), nullptr);
}

TEST(EveryScalar, RoundsTheVerticesOfTheFileAndSaysWhereRunsPart) {
  const LessonRun run = run_lesson(shipped_lesson("far-away"));
  EffectGraph graph(run);
  const EveryScalar::Value& answers = graph.get<EveryScalar>(run.frames.back());
  // B = (3001.3, 2000.2) and K = (3002.7, 2000.4), by Pythagoras; halves there are 2 and 1 apart.
  const double distance = std::hypot(1.4, 0.2);
  EXPECT_NEAR(answers[3].run.trace.result.distance, distance, 1e-12);
  EXPECT_NEAR(answers[2].run.trace.result.distance, distance, 1e-12);
  EXPECT_NEAR(answers[1].run.trace.result.distance, distance, 3e-4);
  EXPECT_GT(std::abs(answers[1].run.trace.result.distance - distance), 1e-6);
  EXPECT_EQ(answers[0].run.x().world[1], Eigen::Vector3d(3002.0, 2000.0, 0.0));
  EXPECT_EQ(answers[0].run.y().world[0], Eigen::Vector3d(3002.0, 2000.0, 0.0));
  EXPECT_EQ(answers[0].run.trace.result.distance, 0.0);
  EXPECT_EQ(answers[0].parting, 2);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(answers[i].parting, 0);
}

TEST(ShapeHull, LeavesOutTheReflexVertexAndKeepsCollinearOnes) {
  const LessonRun reflex = run_lesson(shipped_lesson("nonconvex-vertex"));
  EffectGraph graph(reflex);
  const ShapeHull::Value& hulls = graph.get<ShapeHull>(reflex.frames[0]);
  EXPECT_EQ(hulls.y.inside, (std::vector<int>{1}));
  EXPECT_EQ(hulls.y.corners.size(), 4u);
  // Q = (0.25, 3) and the edge from B = (0.5, 0.25) to C = (2.5, 1.75), by the point-line formula.
  EXPECT_NEAR(hulls.outline_distance,
              std::abs(2.0 * (3.0 - 0.25) - 1.5 * (0.25 - 0.5)) / std::hypot(2.0, 1.5), 1e-12);
  EXPECT_LT(reflex.runs[0].trace.result.distance, hulls.outline_distance);

  const LessonRun line = run_lesson(shipped_lesson("collinear"));
  EffectGraph of_line(line);
  EXPECT_TRUE(of_line.get<ShapeHull>(line.frames[0]).y.inside.empty());
}

}  // namespace effects_test
}  // namespace gjkscope
