#pragma once
// The hulls of shapes in space, which pictures show.

#include <vector>

#include "outlines/polyhedron.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// The hulls of the shapes where they stand.
struct ShapeSolids {
  static constexpr std::string_view kName = "shape-solids";
  static constexpr std::string_view kNeeds = "";
  using Value = std::vector<Polyhedron>;  ///< One for each body; indices of its vertices.
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The hull of all differences y − x in space. Vertices of the hulls of X and Y alone can be on it.
struct DifferenceSolid {
  static constexpr std::string_view kName = "difference-solid";
  static constexpr std::string_view kNeeds = "shape-solids";
  struct Value {
    std::vector<Eigen::Vector3d> points;
    std::vector<gjk::VertexPair> pairs;  ///< One for each point.
    Polyhedron hull;
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
