#include "outlines/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gjkscope {
namespace polygon_test {

using Eigen::Vector2d;

TEST(ConvexHull, LeavesOutInnerCollinearAndRepeatedPoints) {
  const std::vector<Vector2d> points = {{0, 0}, {2, 0}, {1, 0}, {2, 2},
                                        {0, 2}, {1, 1}, {0, 0}, {0, 1}};
  EXPECT_EQ(convex_hull(points), (std::vector<int>{0, 1, 3, 4}));
}

TEST(ConvexHull, OfOnePointAndOfALine) {
  EXPECT_EQ(convex_hull(std::vector<Vector2d>{{1, 1}, {1, 1}}).size(), 1u);
  EXPECT_EQ(convex_hull(std::vector<Vector2d>{{0, 0}, {1, 1}, {3, 3}, {2, 2}}),
            (std::vector<int>{0, 2}));
}

TEST(Triangles, FillAPolygonThatIsNotConvex) {
  // An arrow head, a comb with two teeth, and a square with a vertex on an edge; both ways round.
  const std::vector<std::vector<Vector2d>> polygons = {
      {{0, 0}, {4, -2}, {1, 0}, {4, 2}},
      {{0, 0}, {6, 0}, {6, 3}, {5, 3}, {5, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {0, 1}},
      {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}};
  for (std::vector<Vector2d> polygon : polygons) {
    for (int round = 0; round < 2; ++round) {
      double area = 0.0;
      for (const auto& [a, b, c] : triangles(polygon)) {
        const double part = signed_area(std::vector<Vector2d>{polygon[a], polygon[b], polygon[c]});
        EXPECT_GT(part * signed_area(polygon), 0.0) << "turns as the polygon does";
        area += part;
      }
      EXPECT_DOUBLE_EQ(area, signed_area(polygon));
      std::reverse(polygon.begin(), polygon.end());
    }
  }
}

TEST(Triangles, ThereAreNoneWhereAPolygonCrossesItself) {
  EXPECT_TRUE(triangles(std::vector<Vector2d>{{0, 0}, {2, 2}, {2, 0}, {0, 2}}).size() < 2u);
}

TEST(ConvexHull, IsCounterClockwiseConvexAndHoldsAllPoints) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vector2d> points(3 + round % 40);
    for (Vector2d& point : points) point = {coordinate(random), coordinate(random)};
    std::vector<Vector2d> hull;
    for (const int index : convex_hull(points)) hull.push_back(points[index]);
    EXPECT_GT(signed_area(hull), 0.0);
    EXPECT_TRUE(is_convex(hull));
    for (const Vector2d& point : points) {
      for (std::size_t i = 0; i < hull.size(); ++i) {
        const std::vector<Vector2d> side = {hull[i], hull[(i + 1) % hull.size()], point};
        EXPECT_GE(signed_area(side), -1e-15);
      }
    }
  }
}

TEST(IsConvex, RefusesReflexCornersAndTurningTwice) {
  EXPECT_TRUE(is_convex(std::vector<Vector2d>{{0, 0}, {1, 0}, {2, 0}, {2, 1}}));
  EXPECT_FALSE(is_convex(std::vector<Vector2d>{{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(is_convex(std::vector<Vector2d>{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}))
      << "pentagram";
}

TEST(Clip, KeepsTheHalfThatIsAskedFor) {
  const std::vector<Vector2d> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_DOUBLE_EQ(signed_area(clip(square, {{0.5, 0.0}, {1.0, 0.0}})), 1.0);
  EXPECT_DOUBLE_EQ(signed_area(clip(square, {{0.5, 0.0}, {-1.0, 0.0}})), 3.0);
  EXPECT_TRUE(clip(square, {{-1.0, 0.0}, {1.0, 0.0}}).empty());
}

TEST(SegmentDistance, IsToTheNearestPointOfTheSegment) {
  EXPECT_DOUBLE_EQ(segment_distance({1, 1}, {0, 0}, {2, 0}), 1.0);
  EXPECT_DOUBLE_EQ(segment_distance({5, 4}, {0, 0}, {2, 0}), 5.0);
  EXPECT_DOUBLE_EQ(segment_distance({3, 4}, {0, 0}, {0, 0}), 5.0);
  EXPECT_EQ(closest_on_segment({1, 1}, {0, 0}, {2, 0}), Eigen::Vector2d(1, 0));
  EXPECT_EQ(closest_on_segment({5, 4}, {0, 0}, {2, 0}), Eigen::Vector2d(2, 0));
}

}  // namespace polygon_test
}  // namespace gjkscope
