#include "subjects/feature_regions/drawing.hpp"

#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/space/solids.hpp"

namespace gjkscope::cells {

using Eigen::Vector3d;
using namespace sizes;

Vector3d middle_of(const std::vector<Vector3d>& points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double radius_of(const std::vector<Vector3d>& points) {
  const Vector3d middle = middle_of(points);
  double radius = 0.0;
  for (const Vector3d& point : points) radius = std::max(radius, (point - middle).norm());
  return radius;
}

SolidPart region_of(const Feature& feature, const std::vector<Feature>& of_body,
                    const std::vector<Vector3d>& points, double reach) {
  std::vector<HalfSpace> spaces;
  for (const Border& border : feature.borders) spaces.push_back(border.inside);
  for (const Feature& face : of_body) {
    if (face.kind() != Kind::face) break;
    const HalfSpace& outside = face.borders.back().inside;
    spaces.push_back({-outside.normal, -outside.offset - reach});
  }
  // A box cut along its faces has its corners within this radius.
  return cut_off(std::move(spaces), middle_of(points), radius_of(points) + 1.75 * reach);
}

std::vector<Point> corners_of(const SceneBuilder& scene, std::size_t body, const Feature& feature) {
  std::vector<Point> out;
  for (const int vertex : feature.vertices)
    out.push_back(scene.at(scene.positioned.bodies[body].world[vertex]));
  return out;
}

namespace {

std::string hidden_of(const SceneBuilder& scene, std::size_t body, const Feature& feature) {
  const std::vector<Vector3d>& world = scene.positioned.bodies[body].world;
  const auto vertex = [&](int index) { return world[index]; };
  const SolidBody solid{scene.effects.get<ShapeSolids>(scene.frame)[body], world};
  const bool is_hidden = feature.kind() == Kind::face
                             ? scene.map.towards_eye(feature.outwards) <= 0.0
                             : part_behind(scene.map, solid, vertex(feature.vertices.front()),
                                           vertex(feature.vertices.back()))
                                   .has_value();
  return is_hidden ? ".hidden" : "";
}

}  // namespace

void draw_feature(SceneBuilder& scene, std::size_t body, const Feature& feature) {
  const std::vector<Point> at = corners_of(scene, body, feature);
  const std::string hidden = hidden_of(scene, body, feature);
  if (feature.kind() == Kind::vertex)
    return scene.disk("feature.vertex" + hidden, at[0], kSupportRadius);
  if (feature.kind() == Kind::edge) return scene.line("feature.edge" + hidden, at[0], at[1]);
  scene.area("cell.mark" + hidden, at);
}

void draw_neighbour(SceneBuilder& scene, std::size_t body, const Feature& feature) {
  const std::vector<Point> at = corners_of(scene, body, feature);
  const std::string role = "cell.beside" + hidden_of(scene, body, feature);
  if (feature.kind() == Kind::vertex) return scene.disk(role, at[0], kSimplexRadius);
  if (feature.kind() == Kind::edge) scene.line(role, at[0], at[1]);
}

void draw_pair(SceneBuilder& scene, const std::array<Vector3d, 2>& points, const std::string& role,
               const std::array<std::string, 2>& names) {
  const std::array<Point, 2> at = {scene.at(points[0]), scene.at(points[1])};
  scene.line(role, at[0], at[1]);
  for (const std::size_t end : {0, 1}) {
    if (names[end].empty()) continue;
    scene.disk("slab.point", at[end], kClosestRadius);
    scene.out.moving_labels.push_back(scene.label("point:" + names[end], names[end],
                                                  "closest.label", type::kVertex, at[end],
                                                  kClosestRadius, at[end] - at[1 - end]));
  }
}

void draw_refuting_plane(SceneBuilder& scene, const Border& border, const Vector3d& from,
                         const Vector3d& point, double most) {
  const Vector3d foot = point - border.depth(point) * border.inside.normal;
  const double reach = 0.5 * (foot - from).norm();
  const Vector3d middle = from + 0.5 * std::min(1.0, most / reach) * (foot - from);
  draw_plane(scene, middle, border.inside.normal, std::min(reach, most), "cell.out");
}

}  // namespace gjkscope::cells
