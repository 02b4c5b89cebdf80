// Larsen's proofs about two convex polygons, on random ones: the outline of their Minkowski
// difference edge by edge, and the slab between closest points.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "gjk/gjk.hpp"
#include "outlines/polygon.hpp"
#include "subjects/minkowski_sum/merge.hpp"
#include "subjects/slab_proof/descent.hpp"

namespace proofs_test {

using models::Point;

/// Corners on a grid, so that sums are exact, edges are parallel often, and polygons touch.
std::vector<Point> polygon(std::mt19937& random, const Point& center) {
  for (;;) {
    std::vector<Point> points;
    for (int i = 0; i < 7; ++i) {
      const double x = static_cast<double>(random() % 9);
      const double y = static_cast<double>(random() % 9);
      points.emplace_back(center.x() + x, center.y() + y);
    }
    const std::vector<int> hull = gjkscope::convex_hull(points);
    if (hull.size() < 3) continue;
    std::vector<Point> out;
    for (const int index : hull) out.push_back(points[static_cast<std::size_t>(index)]);
    return out;
  }
}

struct Pair {
  std::vector<Point> x;
  std::vector<Point> y;
};
Pair random_pair(std::mt19937& random, int apart) {
  const double right = static_cast<double>(random() % 12) + apart;
  const double up = static_cast<double>(random() % 12);
  Pair pair;
  pair.x = polygon(random, Point(0.0, 0.0));
  pair.y = polygon(random, Point(right, up));
  return pair;
}

TEST(MinkowskiSum, IsTheHullOfAllDifferences) {
  std::mt19937 random(5);
  int parallel = 0;
  for (int k = 0; k < 5000; ++k) {
    const Pair pair = random_pair(random, 0);
    const minkowski_sum::Merge merge =
        minkowski_sum::merge(models::ring_of({pair.x}), models::ring_of({pair.y}));
    std::vector<Point> all;
    for (const Point& x : pair.x) {
      for (const Point& y : pair.y) all.push_back(y - x);
    }
    const std::vector<int> hull = gjkscope::convex_hull(all);
    ASSERT_EQ(merge.corners.size(), hull.size());
    std::vector<Point> corners;
    for (const int index : hull) corners.push_back(all[static_cast<std::size_t>(index)]);
    const auto first = std::find(corners.begin(), corners.end(), merge.at(merge.corners[0]));
    ASSERT_NE(first, corners.end());
    std::rotate(corners.begin(), first, corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i)
      ASSERT_EQ(merge.at(merge.corners[i]), corners[i]);
    for (const auto source : merge.edges) parallel += source == minkowski_sum::Source::both ? 1 : 0;
  }
  EXPECT_GT(parallel, 1000);
}

TEST(MinkowskiSum, HoldsTheOriginWhereTheShapesMeet) {
  std::mt19937 random(6);
  std::array<int, 3> seen{};
  for (int k = 0; k < 5000; ++k) {
    const Pair pair = random_pair(random, 0);
    const minkowski_sum::Merge merge =
        minkowski_sum::merge(models::ring_of({pair.x}), models::ring_of({pair.y}));
    using minkowski_sum::OriginSide;
    const gjk::Verdict verdict = gjk::distance(pair.x, pair.y).verdict;
    const OriginSide expected = verdict == gjk::Verdict::overlapping ? OriginSide::inside
                                : verdict == gjk::Verdict::touching  ? OriginSide::on_edge
                                                                     : OriginSide::outside;
    ASSERT_EQ(merge.origin, expected);
    ++seen[static_cast<std::size_t>(expected)];
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(SlabProof, EachStepIsCloserAndAnEmptySlabIsTheDistance) {
  std::mt19937 random(7);
  int empty = 0;
  int apart = 0;
  for (int k = 0; k < 5000; ++k) {
    const Pair pair = random_pair(random, 5);
    const double distance = gjk::distance(pair.x, pair.y).distance;
    if (distance == 0.0) continue;
    ++apart;
    const slab_proof::Descent descent = slab_proof::descend(pair.x, pair.y, 0, 0);
    for (const slab_proof::Step& step : descent.steps) {
      if (step.phase == slab_proof::Phase::closer) {
        ASSERT_LT(step.after.distance(), step.before.distance());
      }
    }
    ASSERT_GE(descent.result.distance(), distance * (1.0 - 1e-14));
    if (descent.result.stop != slab_proof::Stop::empty) continue;
    ++empty;
    ASSERT_NEAR(descent.result.distance(), distance, 1e-12 * distance);
  }
  EXPECT_GT(apart, 3000);
  EXPECT_GT(empty, apart / 2);
}

}  // namespace proofs_test
