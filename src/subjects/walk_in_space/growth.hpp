#pragma once
// Steps of three methods as polyhedra grow: two balls pass each other a little at a time.

#include "picture/plot.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Averages over positions of one path. Random points on spheres from a fixed seed, on a lattice on
/// which the move does not round: counts are the same on every machine.
struct SpaceWalkGrowth {
  static constexpr std::string_view kName = "space-walk-growth";
  static constexpr std::string_view kNeeds = "";
  static constexpr int kPositions = 20;  ///< After the first, which has no last pair.
  struct Sample {
    int vertices = 0;    ///< Those of each body.
    double pairs = 0.0;  ///< Pairs of features that a walk from the last pair looks at.
    double warm = 0.0;   ///< Iterations of GJK from the last simplex.
    double cold = 0.0;   ///< The same from one vertex of each body.
  };
  using Value = std::vector<Sample>;
  /// They depend on nothing.
  static bool is_same(const LessonRun&, const LessonRun&) { return true; }
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Them against the number of vertices.
[[nodiscard]] Plot space_walk_plot(const SpaceWalkGrowth::Value& samples);

}  // namespace gjkscope
