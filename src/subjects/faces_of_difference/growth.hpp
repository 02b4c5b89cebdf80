#pragma once
// Faces of Z as polyhedra grow, beside the support points that GJK asks for.

#include "picture/plot.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Pairs of bodies with n vertices each, apart: random points on spheres, and two flat lenses that
/// cross like the bars of a plus. From a fixed seed, of sums, products, quotients and square roots
/// alone: the counts are the same on every machine.
struct FaceGrowth {
  static constexpr std::string_view kName = "face-growth";
  static constexpr std::string_view kNeeds = "";
  struct Sample {
    int vertices = 0;
    int of_spheres = 0;  ///< Faces of Z.
    int of_lenses = 0;
    int asked_of_spheres = 0;  ///< Support points of a run.
    int asked_of_lenses = 0;
  };
  using Value = std::vector<Sample>;
  /// They depend on nothing.
  static bool is_same(const LessonRun&, const LessonRun&) { return true; }
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Two lenses that cross, as they are counted.
struct Lenses {
  static constexpr int kVertices = 20;  ///< Those of each.
  std::array<std::vector<Eigen::Vector3d>, 2> points;
};
[[nodiscard]] Lenses crossing_lenses();

/// Them against the number of vertices.
[[nodiscard]] Plot faces_plot(const FaceGrowth::Value& samples);

}  // namespace gjkscope
