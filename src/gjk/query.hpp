#pragma once
// What is asked: two convex shapes, where they stand, and how the run shall decide.

#include <array>
#include <cstdint>
#include <span>

#include "gjk/linear.hpp"

namespace gjk {

/// Where a shape stands: world = rotation * local + translation.
template <class S, int D>
struct Pose {
  Eigen::Matrix<S, D, D> rotation = Eigen::Matrix<S, D, D>::Identity();
  Vec<S, D> translation = Vec<S, D>::Zero();

  [[nodiscard]] Vec<S, D> rotated(const Vec<S, D>& local) const {
    Vec<S, D> world;
    for (int row = 0; row < D; ++row) {
      world[row] = dot<S, D>(rotation.row(row).transpose(), local);
    }
    return world;
  }
  [[nodiscard]] Vec<S, D> direction_to_local(const Vec<S, D>& world) const {
    Vec<S, D> local;
    for (int column = 0; column < D; ++column) {
      local[column] = dot<S, D>(rotation.col(column), world);
    }
    return local;
  }
};

/// The convex hull of some points: a point, a segment, a polygon, a point set. Order and repetition
/// of vertices do not matter. The vertices are borrowed.
template <class S, int D>
struct Shape {
  std::span<const Vec<S, D>> vertices;
  Pose<S, D> pose = {};
};

/// GJK computes distance(X, Y) as the distance of the origin O from the Minkowski difference Z = Y
/// - X. A point query "Q against a polygon" has X = {Q}: then Z is the polygon seen from Q, and O
/// stands where Q does.
template <class S, int D>
struct Query {
  Shape<S, D> x;
  Shape<S, D> y;
};

/// How the search direction is built from the simplex and its closest point P.
enum class DirectionRule : std::uint8_t {
  perpendicular,   ///< Normal of the simplex, flipped towards O; P is not used (Catto 2010, "An
                   ///< accurate search direction").
  towards_origin,  ///< d = O - P, with the round-off of P (Catto 2010, "A bad direction").
};

/// The order in which Voronoi regions are tested; the first region whose test holds is taken.
enum class RegionOrder : std::uint8_t {
  vertices_first,  ///< Vertices, edges, ..., interior: the slides' order.
  edges_first,     ///< Edges before vertices. Exact arithmetic cannot tell the difference; rounding
                   ///< can.
};

/// Where the run starts.
enum class StartRule : std::uint8_t {
  given,  ///< The vertex pairs of Options::start: a first vertex, a simplex, or a warm start.
  centre_to_centre,  ///< The support point along the line between the centres of the two shapes.
};

/// Indices of the vertices of X and Y whose difference is a vertex of the simplex.
struct VertexPair {
  int x = 0;
  int y = 0;
  friend bool operator==(const VertexPair&, const VertexPair&) = default;
};

inline constexpr int kMaxDimension = 3;

/// Iterations after which the run gives up and says so. GJK in the plane needs 3 to 6 on average
/// for any number of vertices (Larsen 1998, "GJK - Running Time"); tests/gjk/distance_test.cpp
/// asserts that random pairs stay far below.
inline constexpr int kDefaultIterationCap = 64;

/// How a run decides. All of it is data, so that a lesson can show what goes wrong with another
/// choice.
struct Options {
  DirectionRule direction_rule = DirectionRule::perpendicular;
  RegionOrder region_order = RegionOrder::vertices_first;

  /// Stop when the support point is already a vertex of the simplex (Catto 2010, termination case
  /// 1).
  bool stop_on_repeated_support = true;
  /// Stop when the support point lies no farther along d than the simplex does, or when P comes no
  /// nearer to O.
  bool stop_on_no_progress = true;
  /// Stop when lower >= (1 - tolerance) * upper; relative, 0 switches it off.
  double tolerance = 0.0;
  int iteration_cap = kDefaultIterationCap;

  StartRule start_rule = StartRule::given;
  /// Used by StartRule::given: the first `start_count` pairs, 1 to D+1 of them.
  std::array<VertexPair, kMaxDimension + 1> start = {};
  int start_count = 1;
};

/// Why a query was refused. Each names the first thing found wrong.
enum class Error : std::uint8_t {
  none,
  x_has_no_vertices,
  y_has_no_vertices,
  x_not_finite,  ///< A vertex or the pose of X holds a NaN or an infinity.
  y_not_finite,
  overflow,     ///< A product of coordinate differences exceeds the scalar's range.
  underflow,    ///< Products of coordinate differences would be lost among the denormals.
  bad_start,    ///< A start pair names no vertex, or their count is not 1 to D+1.
  bad_options,  ///< The iteration cap is below 1, or the tolerance is not in [0, 1).
};

}  // namespace gjk
