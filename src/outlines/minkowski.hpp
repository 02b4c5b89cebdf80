#pragma once
// The Minkowski difference, point by point. GJK never builds it; lessons do, to show what GJK walks
// on.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "gjk/query.hpp"

namespace gjkscope {

struct CloudPoint {
  Eigen::Vector2d z;  ///< y - x
  gjk::VertexPair pair;
};

/// All differences y_j - x_i: for each vertex of X in turn, every vertex of Y
/// (Catto 2010, slide "Building the Minkowski difference").
[[nodiscard]] std::vector<CloudPoint> minkowski_cloud(std::span<const Eigen::Vector2d> x,
                                                      std::span<const Eigen::Vector2d> y);

/// Corners of the difference Y - X of two convex polygons, all counter-clockwise: the edges of Y
/// and of -X in the order of their directions, so that few of the differences are looked at. Edges
/// of the same direction are joined.
[[nodiscard]] std::vector<CloudPoint> minkowski_merge(std::span<const Eigen::Vector2d> x,
                                                      std::span<const Eigen::Vector2d> y);

/// Corners of the convex hull of all differences of two sets of points, counter-clockwise from the
/// leftmost. Only differences of corners of the two hulls are looked at, so that shapes of
/// thousands of vertices have an outline of Z, too.
[[nodiscard]] std::vector<CloudPoint> minkowski_hull(std::span<const Eigen::Vector2d> x,
                                                     std::span<const Eigen::Vector2d> y);

}  // namespace gjkscope
