#include "subjects/shape_hull/shape_hull.hpp"
#include "subjects/shape_hull/subject.hpp"

namespace gjkscope::layers {

namespace {

/// Whether the vertices, in their own order, go once around their hull.
bool goes_around(const std::vector<int>& corners) {
  std::size_t back = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    back += corners[(i + 1) % corners.size()] < corners[i] ? 1 : 0;
  return back <= 1 || back + 1 >= corners.size();
}

void shape_hull(SceneBuilder& scene) {
  const ShapeHull::Value& hulls = scene.effects.get<ShapeHull>(scene.frame);
  const auto draw = [&](const ShapeHull::Hull& hull, const std::vector<Eigen::Vector3d>& world) {
    if (hull.inside.empty() && goes_around(hull.corners)) return;  // the shape is its own hull
    std::vector<Point> points;
    for (const int corner : hull.corners) points.push_back(scene.at(world[corner]));
    scene.area("hull", points);
    scene.outline(points);
  };
  draw(hulls.x, scene.positioned.x().world);
  draw(hulls.y, scene.positioned.y().world);
  if (scene.run.point_query() && !hulls.y.inside.empty() && hulls.outline_distance > 0.0 &&
      scene.state.stop != gjk::StopReason::running) {
    const Point q = scene.at(scene.positioned.x().world[0]);
    scene.line("outline.line", q, scene.at(hulls.outline_point));
  }
}

}  // namespace

const Layer kShapeHull{
    .effect = gjkscope::ShapeHull::kName, .on = Layer::On::world, .order = 50, .draw = shape_hull};

}  // namespace gjkscope::layers
