// Hulls in space: convex, closed, and all of the points in them.

#include "outlines/polyhedron.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace gjkscope {
namespace polyhedron_test {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

Points box(const Vector3d& size) {
  Points out;
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) out.emplace_back(size.cwiseProduct(Vector3d(x, y, z)));
    }
  }
  return out;
}

/// Points that are not above any face, as far as merged faces are flat; Euler's formula.
void expect_hull(const Points& points, const Polyhedron& hull, double slack) {
  for (const Polyhedron::Face& face : hull.faces) {
    const Vector3d& on = points[static_cast<std::size_t>(face.vertices[0])];
    for (const Vector3d& point : points) EXPECT_LE(face.normal.dot(point - on), slack);
  }
  EXPECT_EQ(hull.vertices.size() + hull.faces.size(), hull.edges.size() + 2);
  for (const Polyhedron::Edge& edge : hull.edges) EXPECT_NE(edge.left, edge.right);
}

TEST(HullInSpace, ABoxHasSixFacesThoughTheyAreMadeOfTriangles) {
  const Points points = box({1.0, 2.0, 0.1});
  const Polyhedron hull = hull_in_space(points);
  EXPECT_EQ(hull.faces.size(), 6u);
  EXPECT_EQ(hull.edges.size(), 12u);
  EXPECT_EQ(hull.vertices.size(), 8u);
  for (const Polyhedron::Face& face : hull.faces) EXPECT_EQ(face.vertices.size(), 4u);
  expect_hull(points, hull, 0.0);
}

TEST(HullInSpace, OfManyPointsItHoldsAll) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const int count : {4, 5, 12, 60, 400}) {
    Points points;
    for (int i = 0; i < count; ++i)
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    expect_hull(points, hull_in_space(points), 1e-6);
  }
}

TEST(HullInSpace, OfPointsOfAGridWithManyInOnePlane) {
  Points points;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) points.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
    }
  }
  const Polyhedron hull = hull_in_space(points);
  EXPECT_EQ(hull.faces.size(), 6u);
  expect_hull(points, hull, 1e-12);
}

TEST(HullInSpace, FlatStraightAndSinglePointsHaveWhatIsLeft) {
  const Polyhedron square =
      hull_in_space(Points{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1}});
  EXPECT_EQ(square.faces.size(), 2u);
  EXPECT_EQ(square.vertices.size(), 4u);
  EXPECT_EQ(square.edges.size(), 4u);
  EXPECT_LT((square.faces[0].normal + square.faces[1].normal).norm(), 1e-15);

  const Polyhedron line =
      hull_in_space(Points{{0, 0, 0}, {1, 1, 1}, {-2, -2, -2}, {0.5, 0.5, 0.5}});
  EXPECT_TRUE(line.faces.empty());
  EXPECT_EQ(line.vertices, (std::vector<int>{1, 2}));
  EXPECT_EQ(line.edges.size(), 1u);

  const Polyhedron point = hull_in_space(Points{{3, 4, 5}, {3, 4, 5}});
  EXPECT_TRUE(point.edges.empty());
  EXPECT_EQ(point.vertices.size(), 1u);
}

TEST(Orientation, IsExactWhereDoublesAreNot) {
  // d lies on the plane of a, b and c but for the last bit of one coordinate.
  const Vector3d a(12.0, 12.0, 12.0);
  const Vector3d b(24.0, 24.0, 24.5);
  const Vector3d c(0.5, 0.25, 0.125);
  for (const double step : {-1.0, 0.0, 1.0}) {
    Vector3d d = a + (b - a) + (c - a);
    const int exact = orientation(a, b, c, d);
    EXPECT_EQ(exact, 0);
    if (step == 0.0) continue;
    d.z() = std::nextafter(d.z(), step * 1e9);
    EXPECT_NE(orientation(a, b, c, d), 0);
    EXPECT_EQ(orientation(a, b, c, d), -orientation(b, a, c, d));
  }
}

}  // namespace polyhedron_test
}  // namespace gjkscope
