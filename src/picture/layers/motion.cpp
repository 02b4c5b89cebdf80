#include "effects/motion.hpp"

#include <algorithm>

#include "effects/slab.hpp"
#include "effects/touched_points.hpp"
#include "geometry/polygon.hpp"
#include "picture/layers/layers.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;

std::vector<Point> placed(const SceneBuilder& scene, const std::vector<Vector2d>& polygon) {
  std::vector<Point> points;
  for (const Vector2d& point : polygon) points.push_back(scene.at(point));
  return points;
}

/// A shape where it was, and an arrow for how far it went.
void ghost(SceneBuilder& scene, const std::vector<Vector2d>& polygon, const Vector2d& by,
           bool slid) {
  if (by.norm() == 0.0 && slid) return;
  const std::vector<Point> points = placed(scene, polygon);
  if (points.size() > 1) scene.add("ghost", Polyline{points, points.size() > 2});
  if (points.size() == 1) scene.disk("ghost", points[0], sizes::kVertexRadius);
  for (std::size_t i = 0; i < points.size(); ++i)
    scene.out.obstacles.passing.push_back({points[i], points[(i + 1) % points.size()]});
  if (!slid || by.norm() == 0.0) return;
  const Vector2d middle = centroid(polygon);
  scene.arrow("ghost.arrow", scene.at(middle), scene.at(middle + by));
}

void last_position(SceneBuilder& scene) {
  const LastPosition::Value& last = scene.effects.get<LastPosition>(scene.frame);
  if (!last) return;
  if (scene.shows_difference) {
    ghost(scene, last->z, last->y_by - last->x_by, !last->turned);
  } else {
    ghost(scene, last->x, last->x_by, true);
    ghost(scene, last->y, last->y_by, !last->turned);
  }
}

}  // namespace

const Layer kLastPosition{.effect = gjkscope::LastPosition::kName,
                          .on = Layer::On::every_view,
                          .order = 130,
                          .draw = last_position};

namespace {

void grown_obstacle(SceneBuilder& scene) {
  const std::vector<Point> grown = placed(scene, scene.effects.get<GrownObstacle>(scene.frame));
  scene.area("grown", grown);
  scene.outline(grown);
  const gjk::Result<double, 2>& result = scene.positioned.trace.result;
  const Vector2d position = scene.positioned.x().placement.translate;
  const Point p = scene.at(position);
  if (result.distance > 0.0) {
    // P of the difference, moved by where X stands.
    const Point nearest = scene.at(result.y - result.x + position);
    scene.line("closest.line", p, nearest);
    scene.disk("closest", nearest, sizes::kClosestRadius);
  }
  const Point far = *std::max_element(
      grown.begin(), grown.end(),
      [&](const Point& a, const Point& b) { return (a - p).norm() < (b - p).norm(); });
  scene.out.moving_labels.push_back(scene.label("grown", "grown " + scene.run.lesson.y().name,
                                                "hull.label", type::kSmallVertex, far, 2.0,
                                                far - p));
  scene.cross("query", p, sizes::kPointRadius);
  scene.out.moving_labels.push_back(
      scene.label("reference", "p", "query.label", type::kVertex, p, sizes::kPointRadius));
}

}  // namespace

const Layer kGrownObstacle{.effect = gjkscope::GrownObstacle::kName,
                           .on = Layer::On::every_view,
                           .order = 120,
                           .draw = grown_obstacle};

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

void slab(SceneBuilder& scene) {
  const Slab::Value& strip = scene.effects.get<Slab>(scene.frame);
  if (!strip) return;
  const Vector2d y_side =
      scene.shows_difference ? Vector2d(strip->support.w) : scene.vertex_of_y(strip->support);
  const Vector2d x_side =
      scene.shows_difference ? Vector2d(0.0, 0.0) : scene.vertex_of_x(strip->support);
  std::vector<Vector2d> polygon = scene.map.visible();
  polygon = clip(polygon, {y_side, -strip->normal});
  polygon = clip(polygon, {x_side, strip->normal});
  if (!polygon.empty()) scene.area("slab", placed(scene, polygon));
  const Vector2d along(-strip->normal.y(), strip->normal.x());
  const double reach = (scene.map.visible()[2] - scene.map.visible()[0]).norm();
  for (const Vector2d& side : {y_side, x_side}) {
    const Obstacles::Segment line{scene.at(side - reach * along), scene.at(side + reach * along)};
    scene.add("slab.side", Polyline{{line.a, line.b}});
    scene.out.obstacles.passing.push_back(line);
  }
  // At the end the answer's line is as long, or nearly so.
  if (scene.knows.has_ended) return;
  const Point from = scene.at(x_side);
  const Point to = scene.at(x_side - strip->width * strip->normal);
  scene.line("slab.width", from, to);
  constexpr double kTick = 6.0;
  const Point tick = kTick * scene.map.direction(along);
  for (const Point& end : {from, to}) scene.add("slab.width", Polyline{{end - tick, end + tick}});
  length_label(scene, "slab", strip->width, from, to);
}

}  // namespace

const Layer kSlab{
    .effect = gjkscope::Slab::kName, .on = Layer::On::every_view, .order = 140, .draw = slab};

}  // namespace gjkscope::layers
