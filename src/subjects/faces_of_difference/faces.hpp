#pragma once
// The faces of Z = Y - X in space, by what they come from.
//
// A face of Z with the outward normal n is what Y has farthest along n, less what X has farthest
// along -n: a face of Y less a vertex of X, a vertex of Y less a face of X, or an edge less an
// edge, a parallelogram. If a face of one is parallel to an edge or a face of the other, both
// make one face of Z. There are no others, so Z is found without a hull of all differences: each
// face of Y and X is looked at once, and each pair of edges. All signs are exact.

#include <span>

#include "gjk/gjk.hpp"
#include "outlines/polyhedron.hpp"

namespace sums_in_space {

using Eigen::Vector3d;
using gjkscope::Polyhedron;
using Points = std::span<const Vector3d>;

enum class Kind : std::uint8_t { of_y, of_x, of_edges, of_several };
inline constexpr int kKinds = 4;

/// Vertices of Y and of X: those of a face in order around it, the ends of an edge, or one.
struct Face {
  std::vector<int> y;
  std::vector<int> x;
  Vector3d normal;  ///< Outwards, of unit length.
  [[nodiscard]] Kind kind() const {
    if (y.size() == 2 && x.size() == 2) return Kind::of_edges;
    return x.size() == 1 ? Kind::of_y : y.size() == 1 ? Kind::of_x : Kind::of_several;
  }
};

/// Empty where X or Y is flat.
[[nodiscard]] std::vector<Face> faces_of_difference(Points x, const Polyhedron& hull_x, Points y,
                                                    const Polyhedron& hull_y);

/// Corners of a face of Z in order around it.
[[nodiscard]] std::vector<gjk::VertexPair> corners_of(const Face& face, Points x, Points y);

}  // namespace sums_in_space
