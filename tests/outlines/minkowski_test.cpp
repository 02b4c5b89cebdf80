#include "outlines/minkowski.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "outlines/polygon.hpp"

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
  EXPECT_EQ(minkowski_hull(x, x).size(), 4u);
}

/// As the hull of the whole cloud, with the pairs that are there.
TEST(MinkowskiHull, IsThatOfAllDifferences) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-6, 6);
  std::size_t corners = 0;
  for (int i = 0; i < 300; ++i) {
    const auto points = [&](int count) {
      std::vector<Vector2d> out;
      for (int k = 0; k < count; ++k) out.emplace_back(coordinate(random), coordinate(random));
      return out;
    };
    const std::vector<Vector2d> x = points(1 + i % 7);
    const std::vector<Vector2d> y = points(1 + i % 11);
    std::vector<Vector2d> cloud;
    for (const CloudPoint& point : minkowski_cloud(x, y)) cloud.push_back(point.z);
    const std::vector<CloudPoint> hull = minkowski_hull(x, y);
    const std::vector<int> expected = convex_hull(cloud);
    ASSERT_EQ(hull.size(), expected.size());
    corners += hull.size();
    for (std::size_t k = 0; k < hull.size(); ++k) {
      EXPECT_EQ(hull[k].z, cloud[static_cast<std::size_t>(expected[k])]);
      EXPECT_EQ(hull[k].z, y[static_cast<std::size_t>(hull[k].pair.y)] -
                               x[static_cast<std::size_t>(hull[k].pair.x)]);
    }
  }
  EXPECT_GT(corners, 1500u);
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
    std::vector<Vector2d> cloud;
    for (const CloudPoint& point : minkowski_cloud(x, y)) cloud.push_back(point.z);
    std::vector<Vector2d> merged;
    for (const CloudPoint& corner : minkowski_merge(x, y)) merged.push_back(corner.z);
    const std::vector<int> hull = convex_hull(cloud);
    ASSERT_EQ(merged.size(), hull.size());
    // The hull starts with the lowest leftmost corner of its own order; both go the same way round.
    const auto first = std::find(merged.begin(), merged.end(), cloud[hull[0]]) - merged.begin();
    for (std::size_t k = 0; k < hull.size(); ++k)
      EXPECT_EQ(merged[(first + k) % merged.size()], cloud[hull[k]]);
  }
}

TEST(MinkowskiMerge, JoinsEdgesOfTheSameDirection) {
  const std::vector<Vector2d> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Vector2d> corners;
  for (const CloudPoint& corner : minkowski_merge(square, square)) corners.push_back(corner.z);
  EXPECT_EQ(corners, (std::vector<Vector2d>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}));
}

}  // namespace minkowski_test
}  // namespace gjkscope
