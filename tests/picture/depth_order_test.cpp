// The order of painting in space, held to rays cast at the bodies, planes and simplices
// themselves.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include "lessons.hpp"
#include "outlines/polygon.hpp"
#include "picture/solid.hpp"

namespace gjkscope {
namespace depth_order_test {

using Eigen::Vector3d;

/// A thing that is drawn, as triangles of the world that look outwards.
struct Drawn {
  std::vector<std::array<Vector3d, 3>> triangles;
  bool is_flat = false;
  bool is_opaque = false;
};

/// How deep, as a coordinate towards the eye, the line of sight through a point meets a triangle
/// first (Möller, Trumbore 1997).
std::optional<double> depth_of(const Drawn& drawn, const Vector3d& from, const Vector3d& eye) {
  std::optional<double> nearest;
  for (const auto& [a, b, c] : drawn.triangles) {
    const Vector3d ab = b - a;
    const Vector3d ac = c - a;
    const double volume = ab.dot(eye.cross(ac));
    const double u = (from - a).dot(eye.cross(ac)) / volume;
    const double v = eye.dot((from - a).cross(ab)) / volume;
    if (!(std::min({u, v, 1.0 - u - v}) > 0.0)) continue;
    const double depth = eye.dot(from) + ac.dot((from - a).cross(ab)) / volume;
    if (!nearest || depth > *nearest) nearest = depth;
  }
  return nearest;
}

/// Random bodies, planes, triangles, lines and points, close enough to cut through each other, and
/// the marks that they make.
class RandomScene {
 public:
  RandomScene(std::mt19937& random, const LessonRun& run, EffectGraph& effects)
      : random_(random),
        eye_{180.0 * coordinate(), 80.0 * coordinate()},
        map_({{0.0, 0.0}, {400.0, 400.0}}, {Vector3d::Zero(), 4.0, 1.0, eye_}),
        scene_(run, effects, run.frames[0], run.lesson.views[0], map_) {
    const int count = 2 + static_cast<int>(random() % 4);
    for (int i = 0; i < count; ++i) add(static_cast<int>(random() % 4), fmt::format("t{}", i));
    for (int i = 0; i < 6; ++i) {
      lines_.emplace_back(point(), point());
      scene_.line_in_space(fmt::format("l{}", i), lines_.back().first, lines_.back().second,
                           fmt::format("l{}.hidden", i));
    }
    for (int i = 0; i < 6; ++i) {
      points_.push_back(point());
      scene_.disk_in_space(fmt::format("p{}", i), points_.back(), 3.0);
    }
  }

  [[nodiscard]] std::vector<Mark> marks() const {
    return in_order_of_depth(scene_.out.surfaces, scene_.out.loose_marks);
  }
  /// Surfaces one by one, as they come.
  [[nodiscard]] std::vector<Mark> marks_as_they_come() const {
    std::vector<Mark> out;
    for (const PaintedSurface& surface : scene_.out.surfaces)
      out.push_back({surface.fill, Polygon{surface.shape->outline}});
    return out;
  }

  /// A point of the world that is seen there, and the way from it to the eye.
  [[nodiscard]] Vector3d world_at(const Point& pixel) const {
    const Point d = (pixel - map_.area().center()) / map_.scale();
    return map_.axes().transpose() * Vector3d(d.x(), -d.y(), 0.0);
  }
  /// Surfaces at a pixel, the farthest first; none where two are too close to tell.
  [[nodiscard]] std::optional<std::vector<std::pair<double, std::size_t>>> expected(
      const Point& pixel) const {
    std::vector<std::pair<double, std::size_t>> out;
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      if (const auto depth = depth_of(drawn_[i], world_at(pixel), towards_eye()))
        out.emplace_back(*depth, i);
    }
    std::sort(out.begin(), out.end());
    for (std::size_t i = 1; i < out.size(); ++i) {
      if (out[i].first - out[i - 1].first < 1e-3) return std::nullopt;
    }
    return out;
  }
  /// The same, where it is the same all around the pixel.
  [[nodiscard]] std::optional<std::vector<std::string>> expected_roles(const Point& pixel) const {
    std::optional<std::vector<std::string>> out;
    for (const double x : {0.0, -1.0, 1.0}) {
      for (const double y : {0.0, -1.0, 1.0}) {
        const auto here = expected(pixel + Point(x, y));
        if (!here) return std::nullopt;
        std::vector<std::string> roles;
        for (const auto& [depth, i] : *here) roles.push_back(fmt::format("t{}.fill", i));
        if (out && *out != roles) return std::nullopt;
        out = roles;
      }
    }
    return out;
  }

  [[nodiscard]] Vector3d towards_eye() const { return map_.axes().row(2).transpose(); }
  [[nodiscard]] const StageMap& map() const { return map_; }
  [[nodiscard]] const std::vector<Vector3d>& points() const { return points_; }
  [[nodiscard]] const std::vector<std::pair<Vector3d, Vector3d>>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<Drawn>& drawn() const { return drawn_; }

 private:
  double coordinate() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Vector3d point() {
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
  }

  void add(int kind, const std::string& role) {
    Drawn& drawn = drawn_.emplace_back();
    if (kind < 2) {
      std::vector<Vector3d> points;
      const Vector3d middle = 0.6 * point();
      const int count = kind == 0 ? 4 : 12;
      for (int i = 0; i < count; ++i) points.emplace_back(middle + 0.8 * point());
      const Polyhedron hull = hull_in_space(points);
      drawn.is_opaque = kind == 1;
      draw_solid(scene_, hull, points, role, {}, drawn.is_opaque ? Stuff::body : Stuff::core);
      for (const Polyhedron::Face& face : hull.faces) {
        const auto corner = [&](std::size_t i) {
          return points[static_cast<std::size_t>(face.vertices[i])];
        };
        for (std::size_t i = 2; i < face.vertices.size(); ++i)
          drawn.triangles.push_back({corner(0), corner(i - 1), corner(i)});
      }
      return;
    }
    std::vector<Vector3d> corners = {point(), point(), point()};
    if (kind == 3) {  // a parallelogram
      corners = {corners[0], corners[1], corners[1] + corners[2] - corners[0], corners[2]};
      drawn.triangles.push_back({corners[0], corners[2], corners[3]});
    }
    drawn.triangles.push_back({corners[0], corners[1], corners[2]});
    draw_face(scene_, corners, role + ".fill");
  }

  std::mt19937& random_;
  Eye eye_;
  StageMap map_;
  SceneBuilder scene_;
  std::vector<Drawn> drawn_;
  std::vector<std::pair<Vector3d, Vector3d>> lines_;
  std::vector<Vector3d> points_;
};

/// Roles of the filled areas at a pixel, as they are painted.
std::vector<std::string> painted_at(const std::vector<Mark>& marks, const Point& pixel) {
  std::vector<std::string> out;
  for (const Mark& mark : marks) {
    const Polygon* polygon = std::get_if<Polygon>(&mark.shape);
    if (polygon != nullptr && mark.role.ends_with(".fill") && is_inside(polygon->points, pixel))
      out.push_back(mark.role);
  }
  return out;
}

constexpr int kScenes = 300;

TEST(DepthOrder, OfAreasIsThatAlongRays) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polyhedra-gjk"));
  EffectGraph effects(run);
  std::mt19937 random(41);
  std::uniform_real_distribution<double> pixel(80.0, 320.0);
  int asked = 0;
  int overlaps = 0;
  int wrong_as_they_come = 0;
  int cut_scenes = 0;
  for (int round = 0; round < kScenes; ++round) {
    SCOPED_TRACE(round);
    const RandomScene scene(random, run, effects);
    const std::vector<Mark> marks = scene.marks();
    const std::vector<Mark> as_they_come = scene.marks_as_they_come();
    const auto fills = std::count_if(marks.begin(), marks.end(),
                                     [](const Mark& mark) { return mark.role.ends_with(".fill"); });
    cut_scenes += fills > static_cast<std::ptrdiff_t>(as_they_come.size()) ? 1 : 0;
    for (int i = 0; i < 60; ++i) {
      const double x = pixel(random);
      const Point at(x, pixel(random));
      const auto expected = scene.expected_roles(at);
      if (!expected || expected->empty()) continue;
      EXPECT_EQ(painted_at(marks, at), *expected) << "at " << at.transpose();
      ++asked;
      overlaps += expected->size() > 1 ? 1 : 0;
      wrong_as_they_come += painted_at(as_they_come, at) != *expected ? 1 : 0;
    }
  }
  EXPECT_GT(asked, 4000);
  EXPECT_GT(overlaps, 1000);
  EXPECT_GT(cut_scenes, kScenes / 3);
  EXPECT_GT(wrong_as_they_come, 500) << "layer by layer";
}

/// A line or a disk: areas nearer than it are painted later, and all others before.
TEST(DepthOrder, OfLinesAndDisksIsThatAlongRays) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polyhedra-gjk"));
  EffectGraph effects(run);
  std::mt19937 random(43);
  int below = 0;
  int above = 0;
  int hidden = 0;
  for (int round = 0; round < kScenes; ++round) {
    SCOPED_TRACE(round);
    const RandomScene scene(random, run, effects);
    const std::vector<Mark> marks = scene.marks();
    const auto check = [&](const std::string& role, const Vector3d& point, bool is_line) {
      const Point at = scene.map()(point);
      const double depth = scene.map().towards_eye(point);
      const auto expected = scene.expected(at);
      if (!expected || !scene.expected_roles(at)) return;
      bool is_hidden = false;
      for (const auto& [of, i] : *expected) {
        if (std::abs(of - depth) < 1e-2) return;
        is_hidden = is_hidden || (scene.drawn()[i].is_opaque && of > depth);
      }
      const auto mark = std::find_if(marks.begin(), marks.end(), [&](const Mark& each) {
        if (!is_line) return each.role == role;
        const Polyline* line = std::get_if<Polyline>(&each.shape);
        return line != nullptr && each.role.starts_with(role) &&
               segment_distance(at, line->points[0], line->points[1]) < 1e-6;
      });
      ASSERT_NE(mark, marks.end()) << role;
      if (is_line) {
        EXPECT_EQ(mark->role.ends_with(".hidden"), is_hidden) << role;
        hidden += is_hidden ? 1 : 0;
      }
      for (const auto& [of, i] : *expected) {
        const std::string fill = fmt::format("t{}.fill", i);
        const auto area = std::find_if(marks.begin(), marks.end(), [&](const Mark& each) {
          const Polygon* polygon = std::get_if<Polygon>(&each.shape);
          return each.role == fill && is_inside(polygon->points, at);
        });
        EXPECT_EQ(of > depth, mark < area) << role << " and " << fill;
        ++(of > depth ? below : above);
      }
    };
    for (std::size_t i = 0; i < scene.points().size(); ++i)
      check(fmt::format("p{}", i), scene.points()[i], false);
    for (std::size_t i = 0; i < scene.lines().size(); ++i) {
      const auto& [from, to] = scene.lines()[i];
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
        check(fmt::format("l{}", i), from + share * (to - from), true);
    }
  }
  EXPECT_GT(below, 2000);
  EXPECT_GT(above, 2000);
  EXPECT_GT(hidden, 500);
}

/// A thing that only touches is neither before nor behind: nothing is cut, and what comes later
/// lies on top.
TEST(DepthOrder, OfThingsThatTouchIsTheOrderInWhichTheyCome) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polyhedra-gjk"));
  EffectGraph effects(run);
  const StageMap map({{0.0, 0.0}, {400.0, 400.0}}, {Vector3d::Zero(), 4.0, 1.0, Eye{30.0, 40.0}});
  SceneBuilder scene(run, effects, run.frames[0], run.lesson.views[0], map);
  const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Polyhedron hull = hull_in_space(corners);
  draw_solid(scene, hull, corners, "first");
  draw_solid(scene, hull, corners, "second");
  for (const Polyhedron::Face& face : hull.faces)
    draw_face(scene,
              {corners[static_cast<std::size_t>(face.vertices[0])],
               corners[static_cast<std::size_t>(face.vertices[1])],
               corners[static_cast<std::size_t>(face.vertices[2])]},
              map.towards_eye(face.normal) > 0.0 ? "front.fill" : "back.fill");
  std::vector<std::string> fills;
  for (const Mark& mark : in_order_of_depth(scene.out.surfaces, scene.out.loose_marks)) {
    if (mark.role.ends_with(".fill")) fills.push_back(mark.role);
  }
  ASSERT_EQ(fills.size(), 6u);
  const auto place = [&](const char* role) {
    return std::find(fills.begin(), fills.end(), role) - fills.begin();
  };
  EXPECT_EQ(fills.front(), "back.fill");
  EXPECT_LT(place("first.fill"), place("second.fill"));
  EXPECT_LT(place("second.fill"), place("front.fill"));
}

}  // namespace depth_order_test
}  // namespace gjkscope
