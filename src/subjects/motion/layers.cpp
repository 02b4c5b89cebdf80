#include <algorithm>

#include "outlines/polygon.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/motion/subject.hpp"

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
  const WideResult& result = scene.positioned.trace.result;
  const Vector2d position = scene.positioned.x().placement.translate;
  const Point p = scene.at(position);
  if (result.distance > 0.0 && scene.frame.question < 0) {
    // P of the difference, moved by where X stands.
    const Point nearest = scene.at(in_plane(result.y - result.x) + position);
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

}  // namespace gjkscope::layers
