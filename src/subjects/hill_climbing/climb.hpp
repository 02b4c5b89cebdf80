#pragma once
// A support point of a convex polyhedron by a walk on its vertices: from a vertex to the neighbour
// that lies farthest along d, until no neighbour lies farther.
//
// All of the polyhedron lies in the cone of a vertex's edges. If none of these leads farther along
// d, nothing of the polyhedron lies farther: a walk that stops has found a support point. That
// needs true vertices and all of their edges (exact_hull). At a point inside of a face, say,
// all edges lie in the face: where d points straight into the body none of them leads farther, and
// the walk would stop at the wrong end.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace climbing {

using Eigen::Vector3d;
using Neighbours = std::vector<std::vector<int>>;

/// One vertex of a walk, and what is computed there.
struct Look {
  int at = 0;
  std::vector<int>
      new_neighbours;  ///< Neighbours that the walk has not met before: one dot product each.
  int next = -1;       ///< The neighbour that lies farthest, and farther; -1: the walk stops.
};

struct Walk {
  Vector3d d = Vector3d::Zero();
  std::vector<Look> looks;

  [[nodiscard]] int end() const { return looks.back().at; }
  /// That of the first vertex, and one for each vertex met.
  [[nodiscard]] int products() const;
};

/// Exactly: 1 where b lies farther along d than a, 0 where both lie equally far.
[[nodiscard]] int farther(const Vector3d& d, const Vector3d& a, const Vector3d& b);

/// `from`: a vertex of the hull of the points. The first counts of neighbours that lie equally far.
[[nodiscard]] Walk walk(std::span<const Vector3d> points, const Neighbours& neighbours,
                        const Vector3d& d, int from);

/// A vertex to start from: `wanted` if it is one, else the first there is.
[[nodiscard]] int start_at(const Neighbours& neighbours, int wanted);

}  // namespace climbing
