#pragma once
// Hulls of points in space, for pictures: their faces, edges and vertices.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace gjkscope {

/// The hull of points in space. A hull that is flat has two faces, back to back; one on a line has
/// one edge and no face; a single point has neither.
struct Polyhedron {
  /// Triangles in one plane make one face, as far as double precision can tell.
  struct Face {
    std::vector<int> vertices;  ///< Indices of points, counter-clockwise seen from outside.
    Eigen::Vector3d normal;     ///< Outwards, of unit length.
  };
  struct Edge {
    int from = 0;
    int to = 0;
    int left = -1;  ///< The faces on both sides; -1: the hull has none.
    int right = -1;
  };
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<int> vertices;  ///< Those on the hull, in ascending order.
};

/// |v|, in the same digits by every compiler.
[[nodiscard]] double length(const Eigen::Vector3d& v);
/// v / |v|, in the same digits by every compiler. v: not 0.
[[nodiscard]] Eigen::Vector3d unit(const Eigen::Vector3d& v);

/// The hull of at least one point. Orientations are decided exactly, so it never folds (Barber,
/// Dobkin, Huhdanpaa 1996, Quickhull).
[[nodiscard]] Polyhedron hull_in_space(std::span<const Eigen::Vector3d> points);

/// The same, decided exactly throughout: all vertices are true ones, none inside of a face, on an
/// edge or twice, and only triangles that lie in one plane make one face. A hull that is flat has
/// edges, and no face.
[[nodiscard]] Polyhedron exact_hull(std::span<const Eigen::Vector3d> points);

/// For each point that a hull was made of the other ends of its edges, in ascending order.
[[nodiscard]] std::vector<std::vector<int>> neighbours_of(const Polyhedron& hull,
                                                          std::size_t points);

/// From one point to another, which outlive it.
struct Difference {
  const Eigen::Vector3d& from;
  const Eigen::Vector3d& to;
  [[nodiscard]] Eigen::Vector3d rounded() const { return to - from; }
};
/// Sign of (u × w) · v. Exact.
[[nodiscard]] int volume_sign(const Difference& u, const Difference& w, const Difference& v);

/// Sign of the volume of abcd: positive where d lies on the side from which abc turns clockwise.
/// Exact.
[[nodiscard]] int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c, const Eigen::Vector3d& d);

}  // namespace gjkscope
