#include "picture/solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "outlines/polygon.hpp"

namespace gjkscope {

using Eigen::Vector3d;

std::vector<bool> faces_in_front(const StageMap& map, const Polyhedron& solid) {
  constexpr double kEdgeOn = 1e-9;
  std::vector<bool> out;
  for (const Polyhedron::Face& face : solid.faces)
    out.push_back(map.towards_eye(face.normal) > kEdgeOn);
  return out;
}

std::vector<bool> vertices_behind(const StageMap& map, const Polyhedron& solid,
                                  std::size_t points) {
  std::vector<bool> behind(points, false);
  if (solid.faces.empty()) return behind;
  for (const int vertex : solid.vertices) behind[static_cast<std::size_t>(vertex)] = true;
  const std::vector<bool> front = faces_in_front(map, solid);
  for (std::size_t k = 0; k < front.size(); ++k) {
    if (!front[k]) continue;
    for (const int vertex : solid.faces[k].vertices)
      behind[static_cast<std::size_t>(vertex)] = false;
  }
  return behind;
}

void draw_solid(SceneBuilder& scene, const Polyhedron& solid, const std::vector<Vector3d>& points,
                const std::string& role, const Subject& subject) {
  // From the upper left, in the directions of the screen.
  const Vector3d light = scene.map.axes().transpose() * Vector3d(-0.5, 0.6, 0.6).normalized();
  constexpr double kShaded = 0.35;
  const auto at = [&](int vertex) { return scene.at(points[static_cast<std::size_t>(vertex)]); };
  const auto edge = [&](const Polyhedron::Edge& ends, const std::string& of) {
    scene.add(of, Polyline{{at(ends.from), at(ends.to)}}, subject);
  };
  if (solid.faces.empty()) {
    for (const Polyhedron::Edge& ends : solid.edges)
      scene.line(role, at(ends.from), at(ends.to), subject);
    return;
  }
  const std::vector<bool> front = faces_in_front(scene.map, solid);
  const auto is_front = [&](int face) { return front[static_cast<std::size_t>(face)]; };
  // Among many short edges those behind cannot be told apart, and at last no edge or face can.
  constexpr double kHiddenRoom = 24.0;
  constexpr double kRoom = 12.0;
  double length = 0.0;
  for (const Polyhedron::Edge& ends : solid.edges) length += (at(ends.from) - at(ends.to)).norm();
  const double mean = length / static_cast<double>(solid.edges.size());
  for (const Polyhedron::Edge& ends : solid.edges) {
    if (mean > kHiddenRoom && !is_front(ends.left) && !is_front(ends.right))
      edge(ends, role + ".hidden");
  }
  std::vector<Point> seen;
  for (const int vertex : solid.vertices) seen.push_back(at(vertex));
  std::vector<Point> silhouette;
  for (const int corner : convex_hull(seen))
    silhouette.push_back(seen[static_cast<std::size_t>(corner)]);
  for (std::size_t k = 0; k < solid.faces.size(); ++k) {
    if (mean <= kRoom || !front[k] || light.dot(solid.faces[k].normal) > kShaded) continue;
    std::vector<Point> corners;
    for (const int vertex : solid.faces[k].vertices) corners.push_back(at(vertex));
    scene.area(role + ".shade", corners);
  }
  if (silhouette.size() > 2) scene.area(role, silhouette, subject);
  for (const Polyhedron::Edge& ends : solid.edges) {
    if (mean > kRoom && is_front(ends.left) && is_front(ends.right)) edge(ends, role + ".edge");
  }
  scene.outline(silhouette);
}

void draw_plane(SceneBuilder& scene, const Vector3d& center, const Vector3d& normal,
                double half_width, const std::string& role) {
  // One side level, as a floor would have it.
  Vector3d along = Vector3d::UnitZ().cross(normal);
  along = along.norm() > 1e-6 * normal.norm() ? along.normalized() : Vector3d::UnitX();
  const Vector3d across = normal.normalized().cross(along);
  std::vector<Point> corners;
  for (const auto& [a, b] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    corners.push_back(scene.at(center + half_width * (a * along + b * across)));
  scene.area(role + ".fill", corners);
  scene.add(role, Polyline{corners, true});
  scene.passing_outline(corners);
}

}  // namespace gjkscope
