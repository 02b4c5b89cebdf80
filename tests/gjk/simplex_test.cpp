// Faces, and barycentric coordinates of the origin.

#include "gjk/simplex.hpp"

#include "check.hpp"

namespace simplex_test {

using gjk::Face;
using gjk::Vec;

template <int D>
gjk::Simplex<double, D> simplex_of(const std::vector<Vec<double, D>>& points) {
  gjk::Simplex<double, D> simplex;
  for (const Vec<double, D>& point : points) simplex.vertices[simplex.count++].w = point;
  return simplex;
}

TEST(faces, "bit i of a face stands for vertex i") {
  CHECK_EQ(0, gjk::vertex_count(Face(0)));
  CHECK_EQ(2, gjk::vertex_count(Face(0b101)));
  CHECK_EQ(1, gjk::vertex_count(Face(0b1000)));
  CHECK_EQ(4, gjk::vertex_count(Face(0b1111)));
  CHECK(gjk::contains(0b101, 2));
  CHECK(!gjk::contains(0b101, 1));
  CHECK_EQ(4, static_cast<int>(gjk::face_of(2)));
  CHECK_EQ(7, static_cast<int>(simplex_of<2>({{0, 0}, {1, 0}, {0, 1}}).all()));
}

TEST(segment, "fractional lengths on a segment are negative outside") {
  // A at -1, B at 3 on the line y = 2: G = (0, 2) lies a quarter of the way from A.
  const auto inside = gjk::barycentric(simplex_of<2>({{-1, 2}, {3, 2}}), 0b11);
  CHECK_EQ(0.75, inside.numerator[0] / inside.denominator);
  CHECK_EQ(0.25, inside.numerator[1] / inside.denominator);
  const auto outside = gjk::barycentric(simplex_of<2>({{1, 2}, {3, 2}}), 0b11);
  CHECK(outside.numerator[1] < 0);
  CHECK_EQ(outside.denominator, outside.numerator[0] + outside.numerator[1]);
}

TEST(triangle, "fractional areas do not depend on the orientation of the triangle") {
  const auto ccw = gjk::barycentric(simplex_of<2>({{-1, -1}, {2, -1}, {-1, 2}}), 0b111);
  const auto cw = gjk::barycentric(simplex_of<2>({{-1, -1}, {-1, 2}, {2, -1}}), 0b111);
  CHECK_EQ(9.0, ccw.denominator);
  CHECK_EQ(9.0, cw.denominator);
  CHECK_EQ(3.0, ccw.numerator[0]);
  CHECK_EQ(3.0, ccw.numerator[1]);
  CHECK_EQ(3.0, cw.numerator[0]);
  CHECK_EQ(3.0, cw.numerator[2]);
}

TEST(triangle_signs, "outside the triangle the areas are signed and still sum to the whole") {
  const auto coordinates = gjk::barycentric(simplex_of<2>({{1, 1}, {4, 1}, {1, 3}}), 0b111);
  CHECK(coordinates.numerator[0] > 0);
  CHECK(coordinates.numerator[1] < 0);
  CHECK(coordinates.numerator[2] < 0);
  CHECK_EQ(coordinates.denominator,
           coordinates.numerator[0] + coordinates.numerator[1] + coordinates.numerator[2]);
}

TEST(degenerate, "a face without length or area counts all its coordinates as not positive") {
  const auto points = gjk::barycentric(simplex_of<2>({{1, 2}, {1, 2}}), 0b11);
  CHECK(!(points.numerator[0] > 0));
  CHECK(!(points.numerator[1] > 0));
  CHECK_EQ(0.0, points.denominator);
  const auto line = gjk::barycentric(simplex_of<2>({{-1, -1}, {0, 0}, {2, 2}}), 0b111);
  for (int i = 0; i < 3; ++i) CHECK_EQ(0.0, line.numerator[i]);
  const auto beside = gjk::barycentric(simplex_of<2>({{-1, 1}, {0, 1}, {2, 1}}), 0b111);
  for (int i = 0; i < 3; ++i) CHECK_EQ(0.0, beside.numerator[i]);
  CHECK_EQ(0.0, beside.denominator);
}

TEST(vertex, "a vertex alone has all the weight") {
  const auto vertex = gjk::barycentric(simplex_of<2>({{9, 9}, {-1, 2}, {3, 2}}), 0b010);
  CHECK_EQ(1.0, vertex.denominator);
  for (int i = 0; i < 3; ++i) CHECK_EQ(i == 1 ? 1.0 : 0.0, vertex.numerator[i]);
}

TEST(subfaces, "coordinates of a sub-face are those of the smaller simplex") {
  const auto triangle = simplex_of<2>({{9, 9}, {-1, 2}, {3, 2}});
  const auto edge = gjk::barycentric(triangle, 0b110);
  CHECK_EQ(0.75, edge.numerator[1] / edge.denominator);
  CHECK_EQ(0.0, edge.numerator[0]);
}

TEST(tetrahedron, "a triangle in space takes Johnson's recursion, a tetrahedron volumes") {
  // O projects to the center of the triangle z = 1.
  const auto simplex = simplex_of<3>({{1, 0, 1}, {-1, 1, 1}, {0, -1, 1}, {0, 0, -1}});
  const auto face = gjk::barycentric(simplex, 0b0111);
  Vec<double, 3> projection = Vec<double, 3>::Zero();
  for (int i = 0; i < 3; ++i) {
    CHECK(face.numerator[i] > 0);
    projection += simplex.vertices[i].w * (face.numerator[i] / face.denominator);
  }
  CHECK_NEAR(0.0, projection[0], 1e-15);
  CHECK_NEAR(0.0, projection[1], 1e-15);
  CHECK_NEAR(1.0, projection[2], 1e-15);
  const auto volume = gjk::barycentric(simplex, 0b1111);
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    CHECK(volume.numerator[i] > 0);
    sum += volume.numerator[i];
  }
  CHECK_EQ(volume.denominator, sum);
}

TEST(weighted, "the weighted point of a vertex is the vertex, to the last bit") {
  auto simplex = simplex_of<2>({{0.1, 0.2}, {0.3, 0.4}});
  simplex.weights[1] = 1.0 / 3.0;
  CHECK(gjk::weighted_point(simplex, 0b10, simplex.weights) == simplex.vertices[1].w);
  simplex.weights[0] = 0.5;
  simplex.weights[1] = 0.5;
  CHECK_NEAR(0.2, gjk::weighted_point(simplex, 0b11, simplex.weights)[0], 1e-16);
  auto triangle = simplex_of<2>({{4, 0}, {0, 8}, {16, 4}});
  triangle.weights = {0.25, 0.5, 0.25};
  CHECK((gjk::weighted_point(triangle, 0b111, triangle.weights) == Vec<double, 2>(5, 5)));
  CHECK((gjk::weighted_point(triangle, 0b101, triangle.weights) == Vec<double, 2>(5, 1)));
}

}  // namespace simplex_test
