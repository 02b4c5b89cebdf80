#include "subjects/feature_regions/features.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "gjk/vector.hpp"

namespace gjkscope::cells {

using Eigen::Vector3d;

double Border::depth(const Vector3d& q) const { return gjk::dot(inside.normal, q) - inside.offset; }

const Border& Feature::tightest(const Vector3d& q) const {
  return *std::min_element(borders.begin(), borders.end(), [&](const Border& a, const Border& b) {
    return a.depth(q) < b.depth(q);
  });
}

std::vector<Feature> features_of(const Polyhedron& hull, std::span<const Vector3d> points) {
  std::vector<Feature> out;
  if (hull.faces.empty()) return out;
  for (const Polyhedron::Face& face : hull.faces) out.push_back({face.vertices, face.normal});
  const int first_edge = static_cast<int>(out.size());
  for (const Polyhedron::Edge& edge : hull.edges) out.push_back({{edge.from, edge.to}});
  std::vector<int> feature_at(points.size(), -1);
  for (const int vertex : hull.vertices) {
    feature_at[vertex] = static_cast<int>(out.size());
    out.push_back({{vertex}});
  }
  const auto at = [&](int i) -> Feature& { return out[i]; };
  // Adds the plane through a point to two features that it separates; `towards_b` leads from a to
  // b.
  const auto border = [&](int a, int b, const Vector3d& through, const Vector3d& towards_b) {
    const double offset = gjk::dot(towards_b, through);
    at(b).borders.push_back({{towards_b, offset}, a});
    at(a).borders.push_back({{-towards_b, -offset}, b});
  };
  for (std::size_t k = 0; k < hull.edges.size(); ++k) {
    const Polyhedron::Edge& ends = hull.edges[k];
    const int edge = first_edge + static_cast<int>(k);
    const Vector3d& from = points[ends.from];
    const Vector3d& to = points[ends.to];
    const Vector3d along = unit(to - from);
    const Vector3d& left = hull.faces[ends.left].normal;
    const Vector3d& right = hull.faces[ends.right].normal;
    border(ends.left, edge, from, along.cross(left));
    border(ends.right, edge, from, right.cross(along));
    const int start = feature_at[ends.from];
    const int end = feature_at[ends.to];
    border(start, edge, from, along);
    border(end, edge, to, -along);
    for (const int feature : {edge, start, end}) at(feature).outwards += left + right;
  }
  for (int i = 0; i < static_cast<int>(out.size()); ++i) {
    at(i).outwards = unit(at(i).outwards);
    if (i >= first_edge) continue;
    const Vector3d& normal = at(i).outwards;
    at(i).borders.push_back({{normal, gjk::dot(normal, points[at(i).vertices[0]])}});
  }
  return out;
}

std::string name_of(const Feature& feature, const LessonShape& shape) {
  constexpr std::array<std::string_view, kKinds> kNames = {"face ", "edge ", "vertex "};
  std::string out(kNames[static_cast<std::size_t>(feature.kind())]);
  for (const int vertex : feature.vertices) out += shape.vertex_names[vertex];
  return out;
}

int holding(std::span<const Feature> features, const Vector3d& q) {
  const auto depth = [&](const Feature& feature) { return feature.tightest(q).depth(q); };
  const auto deepest =
      std::max_element(features.begin(), features.end(),
                       [&](const Feature& a, const Feature& b) { return depth(a) < depth(b); });
  return static_cast<int>(deepest - features.begin());
}

}  // namespace gjkscope::cells
