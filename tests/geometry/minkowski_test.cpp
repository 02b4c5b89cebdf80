#include "geometry/minkowski.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gjkscope {
namespace minkowski_test {

using Eigen::Vector2d;

TEST(MinkowskiCloud, GoesThroughYForEachVertexOfX) {
  const std::vector<Vector2d> x = {{0, 0}, {1, 0}};
  const std::vector<Vector2d> y = {{5, 5}, {6, 5}, {5, 7}};
  const std::vector<CloudPoint> cloud = minkowski_cloud(x, y);
  ASSERT_EQ(cloud.size(), 6u);
  EXPECT_EQ(cloud[4].pair, (gjk::VertexPair{1, 1}));
  EXPECT_EQ(cloud[4].z, Vector2d(5, 5));
}

TEST(MinkowskiHull, OfTwoSquaresIsASquareOfTheirSides) {
  const std::vector<Vector2d> x = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<CloudPoint> cloud = minkowski_cloud(x, x);
  EXPECT_EQ(minkowski_hull(cloud).size(), 4u);
}

TEST(MinkowskiMerge, OfPolygonsInAnyTurnIsTheHullOfTheirCloud) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(0.1, 0.9);
  const auto polygon = [&](int count) {
    std::vector<Vector2d> corners;
    const double start = 7.0 * part(random);
    for (int i = 0; i < count; ++i) {
      const double angle = start + 2.0 * std::numbers::pi * (i + part(random)) / count;
      corners.emplace_back(std::cos(angle), 0.5 * std::sin(angle));
    }
    return corners;
  };
  for (int i = 0; i < 200; ++i) {
    const std::vector<Vector2d> x = polygon(3 + i % 5);
    const std::vector<Vector2d> y = polygon(3 + i % 7);
    const std::vector<CloudPoint> cloud = minkowski_cloud(x, y);
    const std::vector<Vector2d> merged = minkowski_merge(x, y);
    const std::vector<int> hull = minkowski_hull(cloud);
    ASSERT_EQ(merged.size(), hull.size());
    // The hull starts with the lowest leftmost corner of its own order; both go the same way round.
    const auto first = std::find(merged.begin(), merged.end(), cloud[hull[0]].z) - merged.begin();
    for (std::size_t k = 0; k < hull.size(); ++k)
      EXPECT_EQ(merged[(first + k) % merged.size()], cloud[hull[k]].z);
  }
}

TEST(MinkowskiMerge, JoinsEdgesOfTheSameDirection) {
  const std::vector<Vector2d> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(minkowski_merge(square, square),
            (std::vector<Vector2d>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}));
}

}  // namespace minkowski_test
}  // namespace gjkscope
