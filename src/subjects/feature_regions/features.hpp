#pragma once
// Features of a convex polyhedron, and their Voronoi regions (Lin and Canny 1991; Larsen 1998,
// "Voronoi Regions").
//
// The region of a feature holds all points outside of the body whose closest point lies on it. Each
// of its borders is a plane, beyond which the closest point lies elsewhere:
//
//   face    for each edge the plane through it, normal to the face; and the face's own plane
//   edge    those planes of both its faces; at each end the plane through it, normal to the edge
//   vertex  for each of its edges the plane through the vertex, normal to the edge

#include <span>

#include "lesson/lesson.hpp"
#include "subjects/space/region.hpp"

namespace gjkscope::cells {

enum class Kind : std::uint8_t { face, edge, vertex };
inline constexpr int kKinds = 3;

/// A plane between two regions, which face each other.
struct Border {
  HalfSpace inside;
  int beyond = -1;  ///< The neighbour; -1: the body.
  /// How far a point lies inside of it, in units of length; negative: beyond.
  [[nodiscard]] double depth(const Eigen::Vector3d& q) const;
};

struct Feature {
  std::vector<int> vertices;  ///< One, the two ends of an edge, or a face in order around it.
  Eigen::Vector3d outwards = Eigen::Vector3d::Zero();  ///< Into the region, of unit length.
  std::vector<Border> borders = {};
  [[nodiscard]] Kind kind() const {
    return vertices.size() == 1 ? Kind::vertex : vertices.size() == 2 ? Kind::edge : Kind::face;
  }
  /// The border that a point lies farthest beyond, or least inside of.
  [[nodiscard]] const Border& tightest(const Eigen::Vector3d& q) const;
};

/// "face KLM"
[[nodiscard]] std::string name_of(const Feature& feature, const LessonShape& shape);

/// Faces, edges and vertices of a hull; none where it is flat.
[[nodiscard]] std::vector<Feature> features_of(const Polyhedron& hull,
                                               std::span<const Eigen::Vector3d> points);

/// The feature whose region holds a point outside of the body.
[[nodiscard]] int holding(std::span<const Feature> features, const Eigen::Vector3d& q);

}  // namespace gjkscope::cells
