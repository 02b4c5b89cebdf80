#include "outlines/polygon.hpp"
#include "subjects/support/slab.hpp"
#include "subjects/support/subject.hpp"
#include "subjects/support/touched_points.hpp"

namespace gjkscope::layers {

namespace {

void touched_points(SceneBuilder& scene) {
  for (const auto& point : scene.effects.get<TouchedPoints>(scene.frame))
    scene.disk("cloud.touched", scene.at_difference(point.w), sizes::kTouchedRadius);
}

}  // namespace

const Layer kTouchedPoints{.effect = gjkscope::TouchedPoints::kName,
                           .on = Layer::On::every_view,
                           .order = 150,
                           .draw = touched_points};

namespace {

using Eigen::Vector2d;

void slab(SceneBuilder& scene) {
  const Slab::Value& strip = scene.effects.get<Slab>(scene.frame);
  if (!strip) return;
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
  const Point from = scene.at(x_side);
  const Point to = scene.at(x_side - strip->width * normal);
  scene.line("slab.width", from, to);
  constexpr double kTick = 6.0;
  const Point tick = kTick * scene.map.direction(along);
  for (const Point& end : {from, to}) scene.add("slab.width", Polyline{{end - tick, end + tick}});
  scene.length_label("slab", strip->width, from, to);
}

}  // namespace

const Layer kSlab{
    .effect = gjkscope::Slab::kName, .on = Layer::On::every_view, .order = 140, .draw = slab};

}  // namespace gjkscope::layers
