#pragma once
// The part of space that is closest to one face of a simplex.

#include <vector>

#include "outlines/polyhedron.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// All points q with dot(normal, q) >= offset.
struct HalfSpace {
  Eigen::Vector3d normal;  ///< A unit vector.
  double offset = 0.0;
};

/// A convex part of space: its corners, and their hull.
struct SolidPart {
  std::vector<Eigen::Vector3d> points;
  Polyhedron hull;
};
/// The points that half-spaces have in common, as far as about `radius` from `middle`. Empty where
/// there are none.
[[nodiscard]] SolidPart cut_off(std::vector<HalfSpace> spaces, const Eigen::Vector3d& middle,
                                double radius);

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
  using Value = SolidPart;  ///< In the coordinates of the difference.
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
