#pragma once
// Faces of Z as polyhedra grow, beside the support points that GJK asks for.

#include <array>

#include "picture/plot.hpp"
#include "run/graph.hpp"
#include "subjects/growth/choices.hpp"

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
    int asked_for_depth = 0;  ///< By a search on the spheres where their centers meet.
  };
  using Value = std::vector<Sample>;
  /// They depend on nothing.
  static bool is_same(const LessonRun&, const LessonRun&) { return true; }
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Bodies as they are counted, X and Y around the origin: two lenses that cross, or two spheres.
struct CountedBodies {
  static constexpr int kVertices = 20;  ///< Those of each.
  std::array<std::vector<Eigen::Vector3d>, 2> points;
};
[[nodiscard]] CountedBodies crossing_lenses();
[[nodiscard]] CountedBodies spheres();

/// The subject of a frame after the answer, in order: faces of Z, the depth, bodies that are not
/// convex.
enum class Growing { faces, depth, general };

/// Questions go from this size to the last one.
[[nodiscard]] const FaceGrowth::Sample& asked_from(const FaceGrowth::Value& samples);
/// A question chooses from `choices`, each so many times the number before it.
struct GrowthQuestion {
  double vertices = 0.0;  ///< Its place on the x axis.
  double before = 1.0;
  double measured = 1.0;
  std::array<GrowthChoice, 3> choices;
};
[[nodiscard]] GrowthQuestion question_of(Growing growing, const FaceGrowth::Value& samples);
/// Counts against the number of vertices. A question leaves out what it asks for.
[[nodiscard]] Plot faces_plot(Growing growing, bool asks, const FaceGrowth::Value& samples);

}  // namespace gjkscope
