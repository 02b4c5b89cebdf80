#include "subjects/answer/subject.hpp"
#include "subjects/depth/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::depths {
namespace {

using depth::Phase;
using Eigen::Vector2d;
using namespace sizes;

constexpr double kOutwardArrow = 38.0;  // from a vertex, within what a camera leaves around shapes

/// The edge's point nearest to O.
Vector2d foot(const depth::State<double>& state, const depth::Edge<double>& edge) {
  const Vector2d& a = state.polygon.at(edge.from);
  const Vector2d along = state.polygon.at(edge.to) - a;
  const double length_sq = along.squaredNorm();
  if (length_sq == 0.0) return a;
  return a + std::clamp(-a.dot(along) / length_sq, 0.0, 1.0) * along;
}

void label_at(SceneBuilder& scene, const std::string& name, const Point& at, double radius,
              const Point& towards, const std::string& role) {
  scene.out.moving_labels.push_back(
      scene.label("depth:" + name, name, role, type::kVertex, at, radius, towards));
}

/// The polygon in the difference: all of it in Z, around O.
void polygon(SceneBuilder& scene, const Shown& shown) {
  const depth::Polygon<double>& polygon = shown.state.polygon;
  std::vector<Point> corners;
  const std::vector<depth::Edge<double>> edges = edges_in_order(polygon);
  for (const depth::Edge<double>& edge : edges) corners.push_back(scene.at(polygon.at(edge.from)));
  if (corners.size() > 2) scene.area("simplex.fill", corners);
  for (const depth::Edge<double>& edge : edges) {
    if (edge.from == edge.to) continue;
    scene.line(shown.is_nearest(edge) ? "simplex.feature" : "simplex.edge",
               scene.at(polygon.at(edge.from)), scene.at(polygon.at(edge.to)));
  }
  for (const depth::Edge<double>& edge : edges) {
    scene.simplex_vertex(in_space(polygon.corners[edge.from].point), "polygon");
  }
  if (!shown.is(Phase::expand)) return;
  for (const int corner : shown.step->record.outgrown) {
    const auto& point = polygon.corners[corner].point;
    scene.disk("dropped", scene.at(point.w), kRingRadius);
    scene.pair_label(in_space(point), "dropped.label");
  }
}

/// O's distance from the nearest edge as a circle that touches it, and the normal from there.
void nearest(SceneBuilder& scene, const Shown& shown) {
  const Vector2d touching = foot(shown.state, shown.state.edge);
  const double radius = (scene.at(touching) - scene.at(Vector2d::Zero())).norm();
  if (radius > kOriginRadius) scene.disk("depth.inside", scene.at(Vector2d::Zero()), radius);
  scene.search_arrow(scene.at(touching), in_space(shown.state.n), kShortArrow + 18.0, "n");
}

void in_difference(SceneBuilder& scene, const Shown& shown) {
  if (shown.knows_support())
    scene.support_line(scene.at(shown.state.support.w), in_space(shown.state.n));
  polygon(scene, shown);
  if (shown.is_answer) {
    const Vector2d t = in_plane(shown.result.translation);
    const Point o = scene.at(Vector2d::Zero());
    const Point end = scene.at(t);
    if ((end - o).norm() > kOriginRadius) {
      scene.disk("depth.inside", o, (end - o).norm());
      scene.arrow("difference.arrow", o, end);
    }
    scene.disk("closest", end, kClosestRadius);
    label_at(scene, "t", end, kPointRadius, end - o, "closest.label");
    return;
  }
  if (shown.knows_nearest()) nearest(scene, shown);
  if (shown.knows_support()) scene.simplex_vertex(in_space(shown.state.support), "support");
}

void in_world(SceneBuilder& scene, const Shown& shown) {
  if (shown.is_answer) {
    const DepthResult& result = shown.result;
    std::vector<Point> moved;
    for (const Eigen::Vector3d& vertex : scene.positioned.x().world)
      moved.push_back(scene.at(vertex + result.translation));
    if (moved.size() > 1) scene.add("depth.moved", Polyline{moved, moved.size() > 2});
    scene.passing_outline(moved);
    const Point x = scene.at(result.x);
    const Point y = scene.at(result.y);
    if ((y - x).norm() > kPointRadius) {
      scene.arrow("difference.arrow", x, y);
      label_at(scene, "t", 0.5 * (x + y), 4.0, Point(x.y() - y.y(), y.x() - x.x()),
               "closest.label");
    }
    scene.disk("closest", x, kClosestRadius);
    scene.disk("closest", y, kClosestRadius);
    return;
  }
  if (shown.knows_nearest() && !shown.knows_support()) {
    for (const int end : {shown.state.edge.from, shown.state.edge.to}) {
      scene.simplex_vertex(in_space(shown.state.polygon.corners[end].point), "polygon");
    }
  }
  if (!shown.knows_support()) return;
  scene.search_arrow(scene.at(scene.vertex_of_y(in_space(shown.state.support))),
                     in_space(shown.state.n), kOutwardArrow, "n");
  scene.search_arrow(scene.at(scene.vertex_of_x(in_space(shown.state.support))),
                     in_space(Vector2d(-shown.state.n)), kOutwardArrow, "−n");
  scene.simplex_vertex(in_space(shown.state.support), "support");
}

}  // namespace

void stage(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (shown.state.polygon.count == 0) return layers::answer(scene);
  scene.shows_difference ? in_difference(scene, shown) : in_world(scene, shown);
}

}  // namespace gjkscope::depths
