#pragma once
// What is asked, and how the run shall decide.

#include <algorithm>
#include <array>
#include <cstdint>

#include "gjk/shape.hpp"

namespace gjk {

/// GJK computes distance(X, Y) as the distance of the origin O from the Minkowski difference Z = Y
/// - X. A point query "Q against a polygon" has X = {Q}: then Z is the polygon seen from Q, and O
/// stands where Q does.
template <class S, int D>
struct Query {
  Shape<S, D> x;
  Shape<S, D> y;
};
template <class S, int D>
Query(Shape<S, D>, Shape<S, D>) -> Query<S, D>;

/// How the search direction is built from the simplex and its closest point P.
enum class DirectionRule : std::uint8_t {
  perpendicular,   ///< Normal of the simplex, flipped towards O; P is not used (Catto 2010, "An
                   ///< accurate search direction").
  towards_origin,  ///< d = O - P, with the round-off of P (Catto 2010, "A bad direction").
};

/// The order in which Voronoi regions are tested; the first region whose test holds is taken. Where
/// rounding leaves no region whose test holds, or makes O lie in a simplex whose weights put P
/// elsewhere, the region with the nearest point is taken.
enum class RegionOrder : std::uint8_t {
  vertices_first,  ///< Vertices, edges, ..., interior: the slides' order.
  edges_first,     ///< Edges before vertices. Exact arithmetic cannot tell the difference; rounding
                   ///< can.
  unchecked,       ///< Vertices first, and every test is believed: the last region is what is left
                   ///< over, as on the slides.
};

/// Indices of the vertices of X and Y whose difference is a vertex of the simplex.
struct VertexPair {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(const VertexPair& a, const VertexPair& b) {
    return ((a.x ^ b.x) | (a.y ^ b.y)) == 0;  // one branch, where the defaulted one has two
  }
};

inline constexpr int kMaxDimension = 3;

/// A simplex to begin with: what `Result::warm` of one query hands to `Options::start` of the next.
struct WarmStart {
  std::array<VertexPair, kMaxDimension + 1> pairs = {};
  int count = 0;  ///< The first so many of `pairs`, 0 to D+1.
  friend bool operator==(const WarmStart& a, const WarmStart& b) {
    return std::equal(a.pairs.begin(), a.pairs.begin() + a.count, b.pairs.begin(),
                      b.pairs.begin() + b.count);
  }
};

/// How far an answer is checked.
enum class Proof : std::uint8_t {
  none,    ///< Not at all: |P| and the weighted vertices, as the loop left them (the textbook).
  bounds,  ///< Bounds that include rounding; close distances are computed anew.
  exact,   ///< Exact arithmetic runs on where the bounds are wide or leave the verdict open.
};

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

  Proof proof = Proof::exact;

  /// The first simplex. Empty, the run starts from the support point along the line between the
  /// centres of the two shapes, which saves an iteration or two.
  WarmStart start = {};
};

/// Why a query was refused. Each names the first thing found wrong.
enum class Error : std::uint8_t {
  none,
  x_has_no_vertices,
  y_has_no_vertices,
  x_not_finite,  ///< A vertex or the pose of X holds a NaN or an infinity.
  y_not_finite,
  overflow,     ///< The distance, a witness point, or a pose's entries exceed the scalar's range.
  underflow,    ///< Coordinates so small that no unit of length saves their products: those of
                ///< Eigen::half, and denormal ones of float in space.
  bad_start,    ///< A start pair names no vertex, or their count is not 0 to D+1.
  bad_options,  ///< The iteration cap is below 1, or the tolerance is not in [0, 1).
};

}  // namespace gjk
