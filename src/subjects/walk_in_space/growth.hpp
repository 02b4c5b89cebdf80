#pragma once
// Steps of three methods as polyhedra grow: two balls pass each other a little at a time.

#include <array>

#include "picture/plot.hpp"
#include "run/graph.hpp"
#include "subjects/growth/choices.hpp"

namespace gjkscope {

/// Averages over positions of one path. Random points on spheres from a fixed seed, on a lattice on
/// which the move does not round: counts are the same on every machine.
struct SpaceWalkGrowth {
  static constexpr std::string_view kName = "space-walk-growth";
  static constexpr std::string_view kNeeds = "";
  static constexpr int kPositions = 20;  ///< After the first, which has no last pair.
  struct Sample {
    int vertices = 0;          ///< Those of each body.
    double pairs = 0.0;        ///< Pairs of features that a walk from the last pair looks at.
    double warm = 0.0;         ///< Iterations of GJK from the last simplex.
    double cold = 0.0;         ///< The same from one vertex of each body.
    double small_moves = 0.0;  ///< Pairs where moves shrink as features do.
    double first_pair = 0.0;   ///< Pairs of walks that start at the first vertices.
  };
  using Value = std::vector<Sample>;
  /// They depend on nothing.
  static bool is_same(const LessonRun&, const LessonRun&) { return true; }
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The subject of a frame after the path, in order: the walk beside GJK, moves that shrink as
/// features do, walks from the first vertices.
enum class WalkGrowing { beside_gjk, coherent, cold };

/// Both questions go from one size to the last one.
[[nodiscard]] const SpaceWalkGrowth::Sample& asked_from(const SpaceWalkGrowth::Value& samples);
[[nodiscard]] std::array<GrowthChoice, 3> growth_choices_of(const SpaceWalkGrowth::Value& samples);
/// The count that is asked for.
[[nodiscard]] double SpaceWalkGrowth::Sample::*counted_for(WalkGrowing growing);

/// Counts against the number of vertices. A question leaves out what it asks for.
[[nodiscard]] Plot space_walk_plot(WalkGrowing growing, bool asks,
                                   const SpaceWalkGrowth::Value& samples);

}  // namespace gjkscope
