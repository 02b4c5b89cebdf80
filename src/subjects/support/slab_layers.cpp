#include "outlines/polygon.hpp"
#include "picture/solid.hpp"
#include "subjects/support/slab.hpp"
#include "subjects/support/subject.hpp"
#include "subjects/support/touched_points.hpp"

namespace gjkscope::layers {

namespace {

void touched_points(SceneBuilder& scene) {
  for (const auto& point : scene.effects.get<TouchedPoints>(scene.frame)) {
    if (scene.map.is_of_space())
      scene.disk_in_space("cloud.touched", point.w + scene.shift, sizes::kTouchedRadius);
    else
      scene.disk("cloud.touched", scene.at_difference(point.w), sizes::kTouchedRadius);
  }
}

}  // namespace

const Layer kTouchedPoints{.effect = gjkscope::TouchedPoints::kName,
                           .on = Layer::On::every_view,
                           .order = 150,
                           .draw = touched_points};

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTick = 6.0;  // half a stroke at an end of the width

/// Its width, across the slab from a point of X's side; `tick` is the way of the ends' strokes.
void slab_width(SceneBuilder& scene, double width, const Point& from, const Point& to,
                const Point& tick) {
  scene.line("slab.width", from, to);
  for (const Point& end : {from, to}) scene.add("slab.width", Polyline{{end - tick, end + tick}});
  scene.length_label("slab", width, from, to);
}

/// Parts of both planes, one opposite to the other.
void slab_in_space(SceneBuilder& scene, const BestSupport::Strip& strip) {
  const Vector3d x_side =
      scene.shows_difference ? Vector3d(scene.shift) : scene.vertex_of_x(strip.support);
  const Vector3d y_side = x_side - strip.width * strip.normal;
  const double half = scene.plane_half_width();
  for (const Vector3d& side : {y_side, x_side}) {
    const Vector3d center =
        scene.map.center() + strip.normal * strip.normal.dot(side - scene.map.center());
    draw_plane(scene, center, strip.normal, half, "slab.plane");
  }
  if (scene.knows.has_ended) return;
  const Point across = scene.map.direction(strip.normal);
  const Vector3d tick = kTick / scene.map.scale() * scene.map.axes().transpose() *
                        Vector3d(-across.y(), -across.x(), 0.0).normalized();
  scene.line_in_space("slab.width", x_side, y_side);
  for (const Vector3d& end : {x_side, y_side})
    scene.line_in_space("slab.width", end - tick, end + tick);
  scene.out.obstacles.segments.push_back({scene.at(x_side), scene.at(y_side)});
  scene.length_label("slab", strip.width, scene.at(x_side), scene.at(y_side));
}

void slab(SceneBuilder& scene) {
  const Slab::Value& strip = scene.effects.get<Slab>(scene.frame);
  if (!strip) return;
  if (scene.map.is_of_space()) return slab_in_space(scene, *strip);
  const bool in_difference = scene.shows_difference;
  const Vector2d y_side =
      in_plane(in_difference ? strip->support.w : scene.vertex_of_y(strip->support));
  const Vector2d x_side =
      in_difference ? Vector2d(0.0, 0.0) : in_plane(scene.vertex_of_x(strip->support));
  const Vector2d normal = in_plane(strip->normal);
  std::vector<Vector2d> polygon = scene.map.visible();
  polygon = clip(polygon, {y_side, -normal});
  polygon = clip(polygon, {x_side, normal});
  std::vector<Point> points;
  for (const Vector2d& point : polygon) points.push_back(scene.at(point));
  if (!points.empty()) scene.area("slab", points);
  const Vector2d along(-normal.y(), normal.x());
  const double reach = (scene.map.visible()[2] - scene.map.visible()[0]).norm();
  for (const Vector2d& side : {y_side, x_side}) {
    const Obstacles::Segment line{scene.at(side - reach * along), scene.at(side + reach * along)};
    scene.add("slab.side", Polyline{{line.a, line.b}});
    scene.out.obstacles.passing.push_back(line);
  }
  // At the end the answer's line is as long, or nearly so.
  if (scene.knows.has_ended) return;
  slab_width(scene, strip->width, scene.at(x_side), scene.at(x_side - strip->width * normal),
             kTick * scene.map.direction(along));
}

}  // namespace

const Layer kSlab{
    .effect = gjkscope::Slab::kName, .on = Layer::On::every_view, .order = 140, .draw = slab};

}  // namespace gjkscope::layers
