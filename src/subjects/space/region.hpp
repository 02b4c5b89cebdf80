#pragma once
// The part of space that is closest to one face of a simplex.

#include <vector>

#include "outlines/polyhedron.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// One condition of a Voronoi region of a simplex: the sign of a vertex's weight, if only `face`
/// counted (Johnson's conditions; Gilbert, Johnson, Keerthi 1988).
struct RegionCondition {
  gjk::Face face = 0;
  int vertex = 0;
  bool wants_positive = false;
};
/// All conditions of the region of a face.
[[nodiscard]] std::vector<RegionCondition> conditions_of(const WideSimplex& simplex,
                                                         gjk::Face region);

/// The Voronoi region of the face that holds P, or, where tests are tried one by one, of the one
/// whose test is the frame's; cut off some way around the simplex. Empty where there is none yet,
/// and where the simplex has no volume.
struct RegionSolid {
  static constexpr std::string_view kName = "region-solid";
  static constexpr std::string_view kNeeds = "facts";
  struct Value {
    std::vector<Eigen::Vector3d> points;  ///< In the coordinates of the difference.
    Polyhedron hull;
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The faces that the query point lies beyond: those opposite to vertices of negative weight.
struct FacesBefore {
  static constexpr std::string_view kName = "faces-before";
  static constexpr std::string_view kNeeds = "barycentric-weights";
  using Value = std::vector<gjk::Face>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
