#include "picture/solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "outlines/polygon.hpp"

namespace gjkscope {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// A face with this normal, which has no corners yet.
Facet facet_of(const StageMap& map, const Vector3d& normal) {
  const Vector3d seen = map.axes() * normal;
  return {{}, Vector3d(seen.x(), -seen.y(), seen.z())};
}

}  // namespace

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
  for (const int vertex : solid.vertices) behind[vertex] = true;
  const std::vector<bool> front = faces_in_front(map, solid);
  for (std::size_t k = 0; k < front.size(); ++k) {
    if (!front[k]) continue;
    for (const int vertex : solid.faces[k].vertices) behind[vertex] = false;
  }
  return behind;
}

std::optional<std::array<double, 2>> part_behind(const StageMap& map, const SolidBody& body,
                                                 const Vector3d& from, const Vector3d& to) {
  if (body.hull.faces.empty()) return std::nullopt;
  const auto point = [&](int vertex) { return body.points[vertex]; };
  double nearest = -std::numeric_limits<double>::infinity();
  double size = 0.0;
  for (const int vertex : body.hull.vertices) {
    nearest = std::max(nearest, map.towards_eye(point(vertex)));
    size = std::max(size, (point(vertex) - point(body.hull.vertices.front())).norm());
  }
  const double far = nearest - std::min(map.towards_eye(from), map.towards_eye(to));
  if (far <= 0.0) return std::nullopt;
  // All (t, s) for which from + t (to - from) + s (towards the eye) lies within the body.
  const double touching = 1e-6 * size;
  const Vector3d along = to - from;
  const Vector3d eye = map.axes().row(2).transpose();
  std::vector<Vector2d> inside = {{0.0, 0.0}, {1.0, 0.0}, {1.0, far}, {0.0, far}};
  const auto cut = [&](const Vector3d& outwards, const Vector3d& on_face, double margin) {
    const Vector2d normal(outwards.dot(along), outwards.dot(eye));
    const double beyond = outwards.dot(from - on_face) + margin;
    if (normal.squaredNorm() > 0.0) {
      inside = clip(inside, {-beyond / normal.squaredNorm() * normal, normal});
    } else if (beyond > 0.0) {
      inside.clear();
    }
  };
  const bool is_flat = body.hull.faces.size() == 2;  // a plate, as thick as `touching` either way
  for (const Polyhedron::Face& face : body.hull.faces) {
    cut(face.normal, point(face.vertices[0]), is_flat ? -touching : touching);
    if (inside.empty()) return std::nullopt;
  }
  for (std::size_t i = 0; is_flat && i < body.hull.edges.size(); ++i) {
    const Polyhedron::Edge& rim = body.hull.edges[i];
    const Vector3d& on_left = body.hull.faces[rim.left].normal;
    cut((point(rim.to) - point(rim.from)).cross(on_left).normalized(), point(rim.from), touching);
    if (inside.empty()) return std::nullopt;
  }
  std::array<double, 2> part = {1.0, 0.0};
  for (const Vector2d& corner : inside)
    part = {std::min(part[0], corner.x()), std::max(part[1], corner.x())};
  return part;
}

void draw_solid(SceneBuilder& scene, const Polyhedron& solid, const std::vector<Vector3d>& points,
                const std::string& role, const Subject& subject, Stuff stuff) {
  // From the upper left, in the directions of the screen.
  const Vector3d light = scene.map.axes().transpose() * Vector3d(-0.5, 0.6, 0.6).normalized();
  constexpr double kShaded = 0.35;
  const auto at = [&](int vertex) { return scene.at(points[vertex]); };
  const std::string hidden = stuff == Stuff::core ? std::string() : role + ".hidden";
  /// An edge that its own body does not hide.
  const auto edge_in_front = [&](const Polyhedron::Edge& ends, const std::string& of) {
    scene.line_in_space(of, points[ends.from], points[ends.to], hidden, subject);
  };
  if (solid.faces.empty()) {
    for (const Polyhedron::Edge& ends : solid.edges) {
      edge_in_front(ends, role);
      scene.out.obstacles.segments.push_back({at(ends.from), at(ends.to)});
    }
    return;
  }
  const std::vector<bool> front = faces_in_front(scene.map, solid);
  const auto is_front = [&](int face) { return front[face]; };
  // Short edges that lie close together cannot be told apart: first those behind are left out, then
  // all edges and faces.
  constexpr double kHiddenRoom = 32.0;
  constexpr double kRoom = 12.0;
  double length = 0.0;
  for (const Polyhedron::Edge& ends : solid.edges) length += (at(ends.from) - at(ends.to)).norm();
  const double mean = length / static_cast<double>(solid.edges.size());
  for (const Polyhedron::Edge& ends : solid.edges) {
    if (is_front(ends.left) != is_front(ends.right)) {
      edge_in_front(ends, role);
    } else if (is_front(ends.left)) {
      if (mean > kRoom) edge_in_front(ends, role + ".edge");
    } else if (mean > kHiddenRoom) {
      scene.line_in_space(role + ".hidden", points[ends.from], points[ends.to], {}, subject);
    }
  }
  std::vector<Facet> facets;
  facets.reserve(solid.faces.size());
  for (std::size_t k = 0; k < solid.faces.size(); ++k) {
    if (!front[k]) continue;
    Facet facet = facet_of(scene.map, solid.faces[k].normal);
    facet.is_shaded = mean > kRoom && light.dot(solid.faces[k].normal) <= kShaded;
    facet.corners.reserve(solid.faces[k].vertices.size());
    for (const int vertex : solid.faces[k].vertices)
      facet.corners.push_back(scene.map.in_depth(points[vertex]));
    facets.push_back(std::move(facet));
  }
  PointsInSpace corners;
  for (const int vertex : solid.vertices) corners.push_back(scene.map.in_depth(points[vertex]));
  const auto shape = std::make_shared<const Convex>(std::move(facets), corners);
  scene.outline(shape->outline);
  scene.out.surfaces.push_back(
      {role + ".fill", role + ".shade", shape, stuff == Stuff::body, subject});
}

void draw_face(SceneBuilder& scene, const std::vector<Vector3d>& corners, const std::string& role) {
  Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  if (scene.map.towards_eye(normal) < 0.0) normal = -normal;
  Facet facet = facet_of(scene.map, normal);
  for (const Vector3d& corner : corners) facet.corners.push_back(scene.map.in_depth(corner));
  const PointsInSpace points = facet.corners;
  scene.out.surfaces.push_back(
      {role, {}, std::make_shared<const Convex>(std::vector<Facet>{std::move(facet)}, points)});
}

void draw_plane(SceneBuilder& scene, const Vector3d& center, const Vector3d& normal,
                double half_width, const std::string& role) {
  // One side level, as a floor would have it.
  Vector3d along = Vector3d::UnitZ().cross(normal);
  along = along.norm() > 1e-6 * normal.norm() ? along.normalized() : Vector3d::UnitX();
  const Vector3d across = normal.normalized().cross(along);
  std::vector<Vector3d> corners;
  for (const auto& [a, b] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    corners.emplace_back(center + half_width * (a * along + b * across));
  draw_face(scene, corners, role + ".fill");
  for (std::size_t i = 0; i < corners.size(); ++i)
    scene.line_in_space(role, corners[i], corners[(i + 1) % corners.size()], role + ".hidden");
  scene.passing_outline(scene.mapped(corners));
}

}  // namespace gjkscope
