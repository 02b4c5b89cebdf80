#pragma once
// Dot products of walks and of scans as polyhedra grow: runs of GJK on random points on a sphere.

#include "picture/plot.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Averages over runs, each about another point outside of the sphere, from a fixed seed. Counts
/// are the same on every machine: points come of sums, products, quotients and square roots alone.
/// A walk needs neighbours, whose making is not counted.
struct ClimbGrowth {
  static constexpr std::string_view kName = "climb-growth";
  static constexpr std::string_view kNeeds = "";
  static constexpr int kRuns = 20;  ///< Runs of each size.
  struct Sample {
    int vertices = 0;          ///< Also the dot products of a scan.
    double first = 0.0;        ///< Dot products of the first walk of a run, from any vertex.
    double later = 0.0;        ///< Those of a walk that starts at the last support point.
    double first_moves = 0.0;  ///< Moves of the first walk.
  };
  using Value = std::vector<Sample>;
  /// They depend on nothing.
  static bool is_same(const LessonRun&, const LessonRun&) { return true; }
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Them against the number of vertices.
[[nodiscard]] Plot climb_plot(const ClimbGrowth::Value& samples);

}  // namespace gjkscope
