#include "geometry/polygon.hpp"
#include "picture/layers/layers.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

void shape(SceneBuilder& scene, const LessonShape& shape, const std::vector<Vector2d>& world,
           const std::string& role) {
  std::vector<Point> points;
  for (const Vector2d& vertex : world) points.push_back(scene.at(vertex));
  const Point middle = centroid(points);
  if (points.size() == 2) {
    scene.line(role, points[0], points[1]);
  } else if (points.size() > 2) {
    if (is_convex(world)) {
      scene.area(role, points);
    } else {
      scene.add(role, Polyline{points, true});
    }
    scene.outline(points);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    scene.disk(role + ".vertex", points[i], kVertexRadius);
    Point away = points[i] - middle;
    if (points.size() == 1) away = Point::Zero();
    scene.out.fixed_labels.push_back(scene.label("vertex:" + shape.vertex_names[i],
                                                 shape.vertex_names[i], role + ".label",
                                                 type::kVertex, points[i], kSimplexRadius, away));
  }
}

}  // namespace

void shapes(SceneBuilder& scene) {
  if (scene.run.point_query()) {
    shape(scene, scene.run.lesson.y, scene.positioned.y_world, "shape");
  } else {
    shape(scene, scene.run.lesson.x, scene.positioned.x_world, "shape.x");
    shape(scene, scene.run.lesson.y, scene.positioned.y_world, "shape.y");
  }
}

void path(SceneBuilder& scene) {
  std::vector<Point> points;
  for (const PositionedRun& run : scene.run.runs) points.push_back(scene.at(run.x_world[0]));
  // Without a number of frames the path is a set of places to be in, not a way between them.
  if (scene.run.lesson.path_of_x->frames > 0) {
    scene.add("path", Polyline{points});
    for (std::size_t i = 1; i < points.size(); ++i) {
      scene.out.obstacles.segments.push_back({points[i - 1], points[i]});
    }
  }
  for (const Point& point : points) scene.add("path.point", Disk{point, 3.0});
}

void query_point(SceneBuilder& scene) {
  if (scene.view.kind == ViewKind::world && scene.run.point_query()) {
    const Point q = scene.at(scene.positioned.x_world[0]);
    scene.disk("query", q, kPointRadius);
    const std::string& name = scene.run.lesson.x.vertex_names[0];
    scene.out.moving_labels.push_back(scene.label("Q", scene.reaches_query() ? "P = " + name : name,
                                                  "query.label", type::kVertex, q, kPointRadius));
  }
  if (scene.view.kind == ViewKind::difference) {
    const Point o = scene.at(Vector2d::Zero());
    scene.add("origin", Cross{o, kOriginRadius});
    scene.out.obstacles.circles.push_back({o, kOriginRadius});
    scene.out.fixed_labels.push_back(
        scene.label("O", "O", "origin.label", type::kVertex, o, kOriginRadius));
  }
}

}  // namespace gjkscope::layers
