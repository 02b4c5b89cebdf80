#include <algorithm>

#include "run/facts.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector3d;

constexpr double kRowRadius = 9.0;

Vector3d middle_of(const std::vector<Vector3d>& vertices) {
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& vertex : vertices) middle += vertex / static_cast<double>(vertices.size());
  return middle;
}

/// The line through a support point, normal to d, a little longer than its shape.
void line_past(SceneBuilder& scene, const std::vector<Vector3d>& vertices, const Point& through,
               const Vector3d& d) {
  constexpr double kBeyond = 16.0;  // pixels
  const Point across = scene.map.direction(Eigen::Vector2d(d.y(), -d.x()));
  double low = 0.0;
  double high = 0.0;
  for (const Vector3d& vertex : vertices) {
    const double along = across.dot(scene.at(vertex) - through);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  const Point from = through + (low - kBeyond) * across;
  const Point to = through + (high + kBeyond) * across;
  scene.add("support.plane", Polyline{{from, to}});
  scene.out.obstacles.passing.push_back({from, to});
}

/// A shape of the world along d: the direction at its middle, and once its support point is found,
/// there.
void along(SceneBuilder& scene, const std::vector<Vector3d>& vertices, int found, const Vector3d& d,
           const std::string& text, bool is_found) {
  if (!is_found)
    return scene.search_arrow(scene.at(middle_of(vertices)), d, sizes::kPairArrow, text);
  const Point point = scene.at(vertices[found]);
  line_past(scene, vertices, point, d);
  scene.search_arrow(point, d, sizes::kPairArrow, text);
  scene.diamond("support.vertex", point, sizes::kSupportRadius);
}

/// The differences that the chosen vertex of Y is in: a copy of X, turned round, standing at it.
void row(SceneBuilder& scene, int y) {
  for (const Vector3d& x : scene.positioned.x().world)
    scene.disk("cloud.row", scene.at(scene.positioned.y().world[y] - x), kRowRadius);
}

}  // namespace

void support_in_parts(SceneBuilder& scene) {
  const WideState& state = scene.state;
  const SupportPart reached = *support_part(scene.run, scene.frame);
  if (!scene.shows_difference) {
    along(scene, scene.positioned.y().world, state.support.pair.y, state.d, "d",
          reached >= SupportPart::of_y);
    along(scene, scene.positioned.x().world, state.support.pair.x, -state.d, "−d",
          reached >= SupportPart::of_x);
    if (reached == SupportPart::of_z)
      scene.link(scene.vertex_of_x(state.support), scene.vertex_of_y(state.support));
    return;
  }
  if (reached == SupportPart::of_y || reached == SupportPart::of_x)
    row(scene, state.support.pair.y);
  simplex(scene);
  const bool at_end = reached == SupportPart::of_z;
  if (at_end) scene.support_line(scene.at_difference(state.support.w), state.d);
  closest_line(scene);
  search_direction(scene);
  if (at_end) support_point(scene);
  closest_point(scene);
}

}  // namespace gjkscope::layers
