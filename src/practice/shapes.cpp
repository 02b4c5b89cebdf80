#include "practice/shapes.hpp"

#include <numeric>

#include "lesson/plane.hpp"
#include "outlines/polygon.hpp"
#include "outlines/polyhedron.hpp"

namespace gjkscope::practice {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// In units of a picture's grid.
constexpr int kWide = 5;
constexpr int kHigh = 3;
constexpr int kDeep = 2;  // half the height of bodies

/// A point around the middle of the plane, as wide and high as pictures are.
Vector2d point(Draws& draws) {
  const double x = draws.among(-kWide, kWide);
  const double y = draws.among(-kHigh, kHigh);
  return {x, y};
}

Vector3d point_in_space(Draws& draws) {
  const double x = draws.among(-kHigh, kHigh);
  const double y = draws.among(-kHigh, kHigh);
  const double z = draws.among(0, 2 * kDeep);
  return {x, y, z};
}

/// The shortest arrow along `along` between points with whole coordinates.
Vector2d shortest(const Vector2d& along) {
  const int common = std::gcd(static_cast<int>(along.x()), static_cast<int>(along.y()));
  return common == 0 ? along : Vector2d(along / common);
}

Vector2d turned(const Vector2d& v) { return {-v.y(), v.x()}; }

std::vector<std::string> names(const std::string& letters, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) out.emplace_back(1, letters[i]);
  return out;
}

/// A corner that a reader sees: it stands so far out from the line between its neighbours.
bool stands_out(const std::vector<Vector2d>& polygon) {
  constexpr double kLeast = 0.8;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& before = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Vector2d along = polygon[(i + 1) % polygon.size()] - before;
    if (turned(along).dot(before - polygon[i]) < kLeast * along.norm()) return false;
  }
  return true;
}

/// A convex polygon of `least` to `most` vertices, counter-clockwise; `middle` and `half` say
/// where.
std::vector<Vector2d> polygon(Draws& draws, int least, int most, const Vector2d& middle,
                              const Vector2d& half) {
  while (true) {
    std::vector<Vector2d> points;
    for (int i = 0; i < most + 1; ++i) {
      const double x = draws.among(static_cast<int>(-half.x()), static_cast<int>(half.x()));
      const double y = draws.among(static_cast<int>(-half.y()), static_cast<int>(half.y()));
      points.emplace_back(middle + Vector2d(x, y));
    }
    std::vector<Vector2d> out;
    for (const int corner : convex_hull(points)) out.push_back(points[corner]);
    const int count = static_cast<int>(out.size());
    if (count >= least && count <= most && stands_out(out)) return out;
  }
}

void put_query(Lesson& lesson, const Vector3d& q, const std::vector<Vector3d>& vertices) {
  lesson.x().name = "Q";
  lesson.x().vertex_names = {"Q"};
  lesson.x().vertices = {q};
  lesson.y().vertex_names = names("ABCDEF", vertices.size());
  lesson.y().vertices = vertices;
  lesson.y().name.clear();
  for (const std::string& name : lesson.y().vertex_names) lesson.y().name += name;
}
void put_query(Lesson& lesson, const Vector2d& q, const std::vector<Vector2d>& vertices) {
  put_query(lesson, in_space(q), in_space(vertices));
}

void put_pair(Lesson& lesson, const std::vector<Vector2d>& x, const std::vector<Vector2d>& y) {
  lesson.x().name = "X";
  lesson.x().vertex_names = names("ABCDE", x.size());
  lesson.x().vertices = in_space(x);
  lesson.y().name = "Y";
  lesson.y().vertex_names = names("KLMNR", y.size());
  lesson.y().vertices = in_space(y);
}

std::vector<Vector2d> one_of_pair(Draws& draws, double middle) {
  return polygon(draws, 3, 5, {middle, 0.0}, {3.0, 3.0});
}

/// A random corner of a polygon, the one after it, and the shortest arrow from the one to the
/// other.
struct Side {
  Vector2d from;
  Vector2d to;
  Vector2d step;
};
Side side(Draws& draws, const std::vector<Vector2d>& polygon) {
  const std::size_t count = polygon.size();
  const auto i = static_cast<std::size_t>(draws.among(0, static_cast<int>(count) - 1));
  const Vector2d along = polygon[(i + 1) % count] - polygon[i];
  return {polygon[i], polygon[(i + 1) % count], shortest(along)};
}

}  // namespace

void draw_segment(Draws& draws, Lesson& lesson) {
  const Vector2d a = point(draws);
  const Vector2d b = point(draws);
  put_query(lesson, point(draws), std::vector{a, b});
}

void draw_on_line(Draws& draws, Lesson& lesson) {
  const Vector2d a = point(draws);
  const Vector2d b = point(draws);
  const int steps = draws.among(-kWide, kWide);
  put_query(lesson, Vector2d(a + steps * shortest(b - a)), std::vector{a, b});
}

void draw_above_end(Draws& draws, Lesson& lesson) {
  const Vector2d a = point(draws);
  const Vector2d b = point(draws);
  const int steps = draws.among(-kHigh, kHigh);
  const Vector2d& end = draws.among(0, 1) == 0 ? a : b;
  put_query(lesson, Vector2d(end + steps * turned(shortest(b - a))), std::vector{a, b});
}

void draw_triangle(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> corners = polygon(draws, 3, 3, {0.0, 0.0}, {kWide, kHigh});
  put_query(lesson, point(draws), corners);
}

void draw_triangle_border(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> corners = polygon(draws, 3, 3, {0.0, 0.0}, {kWide, kHigh});
  const Side along = side(draws, corners);
  const int steps = draws.among(1, kHigh);
  const Vector2d& end = draws.among(0, 1) == 0 ? along.from : along.to;
  put_query(lesson, Vector2d(end - steps * turned(along.step)), corners);
}

void draw_polygon(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> corners = polygon(draws, 4, 6, {0.0, 0.0}, {4.0, kHigh});
  const double x = draws.among(-kWide - 2, kWide + 2);
  const double y = draws.among(-kHigh - 1, kHigh + 1);
  put_query(lesson, Vector2d(x, y), corners);
}

void draw_at_vertex(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> corners = polygon(draws, 4, 6, {0.0, 0.0}, {4.0, kHigh});
  put_query(lesson, side(draws, corners).from, corners);
}

void draw_pair(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> x = one_of_pair(draws, -draws.among(1, 4));
  put_pair(lesson, x, one_of_pair(draws, draws.among(1, 4)));
}

void draw_touching(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> x = one_of_pair(draws, -3.0);
  std::vector<Vector2d> y = one_of_pair(draws, 3.0);
  const Vector2d to = side(draws, x).from;
  const Vector2d by = to - side(draws, y).from;
  for (Vector2d& corner : y) corner += by;
  put_pair(lesson, x, y);
}

void draw_parallel(Draws& draws, Lesson& lesson) {
  const std::vector<Vector2d> x = one_of_pair(draws, -3.0);
  const Side of_x = side(draws, x);
  std::vector<Vector2d> y = {{of_x.from.x() + 7.0, -of_x.from.y()}};
  // Edges of −X run as those of X, turned by half a circle.
  y.push_back(y.front() - draws.among(1, 2) * of_x.step);
  const std::vector<Vector2d> more = one_of_pair(draws, 4.0);
  y.insert(y.end(), more.begin(), more.begin() + 2);
  std::vector<Vector2d> hull;
  for (const int corner : convex_hull(y)) hull.push_back(y[corner]);
  put_pair(lesson, x, hull);
}

void draw_tetrahedron(Draws& draws, Lesson& lesson) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 4; ++i) corners.push_back(point_in_space(draws));
  put_query(lesson, point_in_space(draws), corners);
}

void draw_on_face(Draws& draws, Lesson& lesson) {
  draw_tetrahedron(draws, lesson);
  const std::vector<Vector3d>& corners = lesson.y().vertices;
  // The middle of a side and the middle between it and a third vertex.
  const auto at = [&](int i) { return corners[i]; };
  const int left_out = draws.among(0, 3);
  const Vector3d middle = 0.5 * (at((left_out + 1) % 4) + at((left_out + 2) % 4));
  lesson.x().vertices = {0.5 * (middle + at((left_out + 3) % 4))};
}

void draw_polyhedron(Draws& draws, Lesson& lesson) {
  const auto wanted = static_cast<std::size_t>(draws.among(5, 6));
  std::vector<Vector3d> corners;
  Polyhedron hull;
  do {
    corners.clear();
    while (corners.size() < wanted) corners.push_back(point_in_space(draws));
    hull = hull_in_space(corners);
  } while (hull.vertices.size() < wanted || hull.faces.size() < 4);
  const double x = draws.among(-kWide, kWide);
  const double y = draws.among(-kWide, kWide);
  const double z = draws.among(-1, 2 * kDeep + 1);
  put_query(lesson, Vector3d(x, y, z), corners);
}

}  // namespace gjkscope::practice
