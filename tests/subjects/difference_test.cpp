// Effects around the Minkowski difference: what they compute, held against brute force.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lessons.hpp"
#include "outlines/polygon.hpp"
#include "subjects/answer/cold_start.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/subjects.hpp"
#include "subjects/support/slab.hpp"
#include "subjects/support/touched_points.hpp"

namespace gjkscope {
namespace difference_test {

using Eigen::Vector2d;
using testing::shipped_lesson;

double distance_to(const std::vector<Vector2d>& polygon, const Vector2d& point) {
  double least = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    least = std::min(least, segment_distance(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  return least;
}

TEST(ColdStart, IsARunOfItsOwnThatCostsMoreAlongASlowMotion) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-motion"));
  EffectGraph graph(run);
  int cold = 0;
  int warm = 0;
  for (const Frame& frame : run.frames) {
    const ColdStart::Value& afresh = graph.get<ColdStart>(frame);
    cold += afresh.support_calls;
    warm += support_calls(run.run(frame).trace);
    EXPECT_GE(afresh.iterations, 1);
  }
  EXPECT_EQ(graph.count("cold-start").runs, static_cast<long>(run.runs.size()));
  EXPECT_LT(2 * warm, cold + 10) << "warm starts need about half of the support points or fewer";
}

/// The indices of the vertices that lie as far along a direction as the one that a scan kept.
std::set<int> tied(const std::vector<gjk::ScanEntry<double>>& scan, int kept) {
  double largest = 0.0;
  for (const auto& entry : scan)
    if (entry.index == kept) largest = entry.value;
  std::set<int> out;
  for (const auto& entry : scan)
    if (std::abs(entry.value - largest) < 1e-6) out.insert(entry.index);
  return out;
}

TEST(ColdStart, NoPositionOfTheMotionIsDecidedByTheLastBit) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-motion"));
  for (const PositionedRun& at : run.runs) {
    for (const auto& step : at.trace.steps) {
      if (step.phase != gjk::Phase::support) continue;
      // Along an edge that holds P both of its ends are equally far, and either ends the run.
      const auto& simplex = step.after.simplex;
      std::set<int> of_x = {step.after.support.pair.x};
      std::set<int> of_y = {step.after.support.pair.y};
      const bool repeated =
          std::any_of(simplex.vertices.begin(), simplex.vertices.begin() + simplex.count,
                      [&](const auto& vertex) { return vertex.pair == step.after.support.pair; });
      for (int i = 0; repeated && i < simplex.count; ++i) {
        of_x.insert(simplex.vertices[i].pair.x);
        of_y.insert(simplex.vertices[i].pair.y);
      }
      for (const int x : tied(step.record.scan_x, step.after.support.pair.x))
        EXPECT_TRUE(of_x.contains(x)) << "at " << at.time << " s";
      for (const int y : tied(step.record.scan_y, step.after.support.pair.y))
        EXPECT_TRUE(of_y.contains(y)) << "at " << at.time << " s";
    }
  }
}

TEST(TouchedPoints, AreThoseOfTheStartAndTheSupportPointsEachOnce) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-gjk"));
  EffectGraph graph(run);
  std::size_t last = 0;
  for (const Frame& frame : run.frames) {
    const TouchedPoints::Value& touched = graph.get<TouchedPoints>(frame);
    EXPECT_GE(touched.size(), last) << "what was touched stays touched";
    last = touched.size();
    std::set<std::pair<int, int>> pairs;
    for (const auto& point : touched) {
      pairs.insert({point.pair.x, point.pair.y});
      const PositionedRun& at = run.run(frame);
      EXPECT_LT((point.w - (at.y().world[point.pair.y] - at.x().world[point.pair.x])).norm(),
                1e-14);
    }
    EXPECT_EQ(pairs.size(), touched.size());
  }
  // N-C to start from; L-D, K-C and K-D found, K-C once more.
  EXPECT_EQ(last, 4u);
}

TEST(Slab, HoldsNothingOfXAndYAndIsAsWideAsTheDistanceInTheEnd) {
  const LessonRun run = run_lesson(shipped_lesson("slab-certificate"));
  EffectGraph graph(run);
  double last = 0.0;
  int slabs = 0;
  for (const Frame& frame : run.frames) {
    const Slab::Value& strip = graph.get<Slab>(frame);
    if (!strip) continue;
    ++slabs;
    const PositionedRun& at = run.run(frame);
    const Vector2d y_side = in_plane(at.y().world[strip->support.pair.y]);
    const Vector2d x_side = in_plane(at.x().world[strip->support.pair.x]);
    const Vector2d normal = in_plane(strip->normal);
    EXPECT_NEAR(normal.norm(), 1.0, 1e-15);
    EXPECT_NEAR(normal.dot(x_side - y_side), strip->width, 1e-14);
    for (const Vector2d& y : in_plane(at.y().world)) EXPECT_LE(normal.dot(y - y_side), 1e-14);
    for (const Vector2d& x : in_plane(at.x().world)) EXPECT_GE(normal.dot(x - x_side), -1e-14);
    EXPECT_GE(strip->width, last) << "the widest so far";
    EXPECT_NEAR(strip->width, run.bounds(frame).lower, 1e-12);
    last = strip->width;
  }
  EXPECT_GT(slabs, 3);
  EXPECT_NEAR(last, run.runs[0].trace.result.distance, 1e-14);
}

TEST(LastPosition, ShapesThatDoNotTurnSlideTheDifference) {
  const LessonRun run = run_lesson(shipped_lesson("minkowski-translate"));
  EffectGraph graph(run);
  EXPECT_FALSE(graph.get<LastPosition>(run.frames[0]));
  std::set<std::string> kinds;
  for (std::size_t i = 1; i < run.frames.size(); ++i) {
    const Frame& frame = run.frames[i];
    const LastPosition::Value& last = graph.get<LastPosition>(frame);
    ASSERT_TRUE(last);
    EXPECT_FALSE(last->turned);
    const MinkowskiHull::Value& hull = graph.get<MinkowskiHull>(frame);
    ASSERT_EQ(hull.size(), last->z.size());
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Vector2d slid = last->z[k] + last->y_by - last->x_by;
      EXPECT_LT((hull[k].z - slid).norm(), 1e-14);
    }
    kinds.insert(last->x_by == last->y_by       ? "both"
                 : last->y_by == Vector2d(0, 0) ? "robot"
                 : last->x_by == Vector2d(0, 0) ? "obstacle"
                                                : "each its own way");
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"both", "robot", "obstacle", "each its own way"}));
}

TEST(LastPosition, ATurnDoesMoreThanSlide) {
  const LessonRun run = run_lesson(shipped_lesson("polygons-motion"));
  EffectGraph graph(run);
  EXPECT_TRUE(graph.get<LastPosition>(run.frames[1])->turned);
}

TEST(GrownObstacle, IsAsFarFromThePointAsTheObstacleFromTheRobot) {
  const LessonRun run = run_lesson(shipped_lesson("minkowski-translate"));
  EffectGraph graph(run);
  for (const Frame& frame : run.frames) {
    const GrownObstacle::Value& grown = graph.get<GrownObstacle>(frame);
    EXPECT_GT(signed_area(grown), 0.0);
    const PositionedRun& at = run.run(frame);
    double least = INFINITY;
    const std::vector<Vector2d> xs = in_plane(at.x().world);
    const std::vector<Vector2d> ys = in_plane(at.y().world);
    for (const Vector2d& x : xs) least = std::min(least, distance_to(ys, x));
    for (const Vector2d& y : ys) least = std::min(least, distance_to(xs, y));
    EXPECT_NEAR(distance_to(grown, in_plane(at.x().placement.translate)), least, 1e-13);
    EXPECT_NEAR(at.trace.result.distance, least, 1e-13);
  }
}

}  // namespace difference_test
}  // namespace gjkscope
