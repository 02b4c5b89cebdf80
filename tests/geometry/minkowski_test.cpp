#include "geometry/minkowski.hpp"

#include <gtest/gtest.h>

namespace gjkscope {
namespace {

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

}  // namespace
}  // namespace gjkscope
