#pragma once
// The walk on features (Lin and Canny 1991, "A fast algorithm for incremental distance
// calculation"; Larsen 1998, "Lin-Canny Algorithm").
//
//   start with any feature of each outline
//   loop
//     closest  take the closest points of the two features;
//              an edge whose closest point is an end is left for that end
//     regions  look for a neighbour of one feature whose external Voronoi region holds
//              the other's closest point
//     swap     take that neighbour
//
// The distance falls with each swap, so no pair of features comes twice, and there are finitely
// many. All decisions are exact.
//
// Behind an edge there is no region: a point there lies in the outline, and then the shapes
// overlap, or beyond it, and then another edge is closer, which is looked for among all. On
// outlines that are not convex the walk stops where no neighbour is closer: a local minimum.

#include "outlines/nearest.hpp"

namespace models {

/// A vertex of a ring, or the edge from there to the next.
struct RingFeature {
  bool is_vertex = true;
  int index = 0;
  friend auto operator<=>(const RingFeature&, const RingFeature&) = default;
};

enum class WalkPhase : std::uint8_t { closest, regions, swap };

enum class WalkStop : std::uint8_t {
  running,
  closest,        ///< Each closest point lies in the other feature's region.
  local_minimum,  ///< On outlines that are not convex: no neighbour is closer, but another pair is.
  overlap,        ///< The shapes overlap: features meet, or a point lies within the other outline.
  refused,        ///< The method does not take these outlines; see check().
  pair_cap,       ///< As many swaps as there are pairs: that would be a defect.
};

/// One look whether a point lies across a border of a feature's Voronoi region.
struct RegionTest {
  bool of_a = true;       ///< The region is of A's feature, the point B's.
  RingFeature neighbour;  ///< The feature beyond the border; behind an edge, the edge itself.
  bool behind = false;    ///< The border is the edge itself, or of a straight vertex the next one.
  bool crossed = false;
};

struct WalkState {
  WalkPhase phase = WalkPhase::closest;
  RingFeature a;
  RingFeature b;
  Nearest pair;      ///< Closest points of the features, once they were taken.
  RegionTest found;  ///< The border to be crossed.
  int swaps = 0;
  WalkStop stop = WalkStop::running;
};

struct WalkStep {
  WalkPhase phase = WalkPhase::closest;
  std::vector<RegionTest> tests;  ///< regions: those that were made; the last one may be crossed.
  int asked = 0;                  ///< swap: edges that were looked at behind an edge.
  WalkState after;
};
/// Two outlines, as rings; `convex` says whether both are.
struct WalkQuery {
  Ring a;
  Ring b;
  Model model_a;
  Model model_b;
  bool convex = true;
  /// Pairs of features that there are: vertices and edges of the one with those of the other.
  [[nodiscard]] int pairs() const { return 4 * a.size() * b.size(); }
};
/// The models must have one closed outline each that does not meet itself.
[[nodiscard]] WalkQuery walk_query(const Model& a, const Model& b);

/// Runs the phase `state.phase`; `note` takes what it looks at.
void step(WalkState& state, const WalkQuery& query, WalkStep& note);

/// The end of a walk.
struct WalkResult {
  Answer answer;  ///< After `local_minimum` that of the local minimum.
  WalkStop stop = WalkStop::running;
  Flaw flaw;  ///< The reason for `refused`.
  bool flaw_in_b = false;
  RingFeature a;  ///< The start for the next time.
  RingFeature b;
  int steps = 0;  ///< Pairs of features that were looked at.
};

struct WalkTrace {
  WalkState start;
  std::vector<WalkStep> steps;
  WalkResult result;
};

/// Lin-Canny on two convex outlines, from any features. O(1) steps where these are near the end.
[[nodiscard]] WalkResult lin_canny(const WalkQuery& query, RingFeature a = {}, RingFeature b = {});
/// Checks the models first, and refuses those that are not one convex outline each.
[[nodiscard]] WalkResult lin_canny(const Model& a, const Model& b);
[[nodiscard]] WalkTrace trace_walk(const WalkQuery& query, RingFeature a = {}, RingFeature b = {});

}  // namespace models
