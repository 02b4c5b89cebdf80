#include <algorithm>
#include <cmath>
#include <numbers>

#include "outlines/polygon.hpp"
#include "subjects/round_shapes/round_shapes.hpp"
#include "subjects/round_shapes/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;

/// Enough corners to make a circle of this radius, in pixels, look round: they are off by a
/// twentieth of a pixel.
int corners_of_circle(double pixels) {
  constexpr double kOff = 0.05;
  constexpr double kFewest = 16.0;
  constexpr double kMost = 720.0;
  const double corners = std::ceil(std::numbers::pi * std::sqrt(0.5 * pixels / kOff));
  return static_cast<int>(std::clamp(corners, kFewest, kMost));
}

/// The outline of all points within `radius` of the hull of the vertices, counter-clockwise.
std::vector<Vector2d> rounded(const std::vector<Vector2d>& vertices, double radius, double pixels) {
  const double turn = 2.0 * std::numbers::pi / corners_of_circle(pixels);
  const std::vector<int> hull = convex_hull(vertices);
  const std::size_t count = hull.size();
  const auto corner = [&](std::size_t i) { return vertices[hull[i % count]]; };
  /// The angle of the outward normal of the edge that leaves corner i.
  const auto angle = [&](std::size_t i) {
    const Vector2d edge = corner(i + 1) - corner(i);
    return count == 1 ? 0.0 : std::atan2(-edge.x(), edge.y());
  };
  std::vector<Vector2d> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double from = angle(i + count - 1);
    // A convex outline turns left by at most half a turn, to which rounding adds little; a point
    // turns once around.
    double arc = std::remainder(angle(i) - from, 2.0 * std::numbers::pi);
    if (count == 1 || arc < -0.5 * std::numbers::pi) arc += 2.0 * std::numbers::pi;
    const int steps = std::max(1, static_cast<int>(std::ceil(arc / turn)));
    for (int k = 0; k <= steps; ++k) {
      const double at = from + arc * k / steps;
      out.emplace_back(corner(i) + radius * Vector2d(std::cos(at), std::sin(at)));
    }
  }
  return out;
}

std::vector<Point> outline_of(const SceneBuilder& scene, const std::vector<Vector2d>& vertices,
                              double radius) {
  std::vector<Point> points;
  for (const Vector2d& point : rounded(vertices, radius, scene.map.scale() * radius))
    points.push_back(scene.at(point));
  return points;
}

void skins(SceneBuilder& scene) {
  for (std::size_t body = 0; body < scene.run.lesson.bodies.size(); ++body) {
    const double radius = scene.run.lesson.bodies[body].radius;
    if (!(radius > 0.0)) continue;
    const bool is_x = body == 0;
    const std::vector<Point> outline =
        outline_of(scene, in_plane(scene.positioned.bodies[body].world), radius);
    scene.area(scene.run.point_query() ? is_x ? "skin.query" : "skin"
               : is_x                  ? "skin.x"
                                       : "skin.y",
               outline, {is_x ? Subject::Kind::shape_x : Subject::Kind::shape_y});
    scene.outline(outline);
  }
}

/// In the difference both radii go to the origin: it is the round shapes' distance from Z.
void radii(SceneBuilder& scene) {
  const RoundShapes::Value* round = RoundShapes::of(scene.effects, scene.run, scene.frame);
  if (round == nullptr) return;
  const std::vector<Point> outline = outline_of(scene, {Vector2d::Zero()}, round->radii);
  scene.add("skin.origin", Polyline{outline, true});
  scene.outline(outline);
}

void gap(SceneBuilder& scene) {
  if (!shows_gap(scene)) return;
  const RoundShapes::Value* round = RoundShapes::of(scene.effects, scene.run, scene.frame);
  const Point x = scene.at(round->x);
  const Point y = scene.at(round->y);
  scene.line("skin.gap", x, y);
  for (const Point& point : {x, y}) scene.disk("skin.point", point, sizes::kVertexRadius);
  scene.length_label("gap", round->distance, x, y);
}

}  // namespace

bool shows_gap(const SceneBuilder& scene) {
  const RoundShapes::Value* round = RoundShapes::of(scene.effects, scene.run, scene.frame);
  return round != nullptr && round->meeting == RoundShapes::Meeting::apart &&
         scene.view.kind == ViewKind::world && scene.knows.distance;
}

const Layer kSkins{.effect = {}, .on = Layer::On::world, .order = 55, .draw = skins};
const Layer kRadii{.effect = {}, .on = Layer::On::difference, .order = 70, .draw = radii};
const Layer kGap{.effect = {}, .on = Layer::On::world, .order = Layer::kOfTour + 20, .draw = gap};

}  // namespace gjkscope::layers
