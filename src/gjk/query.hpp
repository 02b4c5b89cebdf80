#pragma once
// A query, and the options that say how its run decides.

#include <algorithm>
#include <array>
#include <cstdint>

#include "gjk/proof/shape.hpp"

namespace gjk {

/// Two shapes, whose coordinates are S; R is the scalar of a run everywhere, and D the dimension.
/// GJK computes distance(X, Y) as the distance of the origin O from the Minkowski
/// difference Z = Y - X. A query "point Q against a polygon" has X = {Q}: then Z is the polygon
/// seen from Q, and O stands for Q.
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

/// The order in which Voronoi regions are tested; the first region whose test holds is taken. When
/// rounding makes every test fail, or puts O in a simplex whose weights put P elsewhere, the region
/// with the nearest point is taken.
enum class RegionOrder : std::uint8_t {
  vertices_first,  ///< Vertices, edges, ..., interior: the slides' order.
  edges_first,     ///< Edges before all others. Only rounding can make this differ.
  unchecked,       ///< Vertices first, and every test is believed: when none holds, the whole
                   ///< simplex is taken, as on the slides.
};

/// Indices of the vertices of X and Y whose difference is a vertex of the simplex.
struct VertexPair {
  int x = 0;
  int y = 0;
  friend constexpr bool operator==(const VertexPair& a, const VertexPair& b) {
    return ((a.x ^ b.x) | (a.y ^ b.y)) == 0;  // one branch; the defaulted operator has two
  }
};

inline constexpr int kMaxDimension = 3;

/// A simplex to begin with: `Result::warm` of one query makes it for `Options::start` of the next.
struct WarmStart {
  std::array<VertexPair, kMaxDimension + 1> pairs = {};
  int count = 0;  ///< How many of `pairs` are used: 0 to D+1.
  friend bool operator==(const WarmStart& a, const WarmStart& b) {
    return std::equal(a.pairs.begin(), a.pairs.begin() + a.count, b.pairs.begin(),
                      b.pairs.begin() + b.count);
  }
};

/// How far an answer is checked.
enum class Proof : std::uint8_t {
  none,    ///< Not at all: |P| and the weighted vertices as the loop left them, as in textbooks.
  bounds,  ///< Bounds that include rounding; short distances are computed anew with more digits.
  exact,   ///< As `bounds`; exact arithmetic runs on where they are wide or leave the verdict open.
};

/// Iterations after which a run gives up. GJK in the plane needs 3 to 6 on average, however many
/// vertices there are (Larsen 1998, "GJK - Running Time"; tests/gjk/distance_test.cpp).
inline constexpr int kDefaultIterationCap = 64;

/// How a run decides. Every choice is data, so that a lesson can show what another choice spoils.
struct Options {
  DirectionRule direction_rule = DirectionRule::perpendicular;
  RegionOrder region_order = RegionOrder::vertices_first;
  /// Stop when the support point is already in the simplex (Catto 2010, termination case 1).
  bool stop_on_repeated_support = true;
  /// Stop when P came no nearer to O, or the support point is no farther along d than the simplex.
  bool stop_on_no_progress = true;
  /// Stop when lower >= (1 - tolerance) * upper: a relative tolerance in [0, 1), where 0 is off.
  double tolerance = 0.0;
  int iteration_cap = kDefaultIterationCap;
  Proof proof = Proof::exact;

  /// The first simplex. When it is empty, the run starts from the support point along the line
  /// between the centers of the two shapes, which saves an iteration or two; in every scalar from
  /// the same one.
  WarmStart start = {};
};

/// Why a query was refused: the first thing found wrong.
enum class Error : std::uint8_t {
  none,
  x_has_no_vertices,
  y_has_no_vertices,
  x_not_finite,  ///< A vertex or the pose of X holds a NaN or an infinity.
  y_not_finite,
  overflow,     ///< The distance, a witness point, or a pose's entries exceed the scalar's range.
  underflow,    ///< Coordinates so small that their products underflow in every unit of length: in
                ///< Eigen::half, and denormal ones in float in space.
  bad_start,    ///< A start pair names no vertex, or their count is not 0 to D+1.
  bad_options,  ///< The iteration cap is below 1, or the tolerance is not in [0, 1).
};

}  // namespace gjk
