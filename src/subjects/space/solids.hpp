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

/// A convex body: its hull, and the points that it was made of, which outlive it.
struct SolidOf {
  const Polyhedron& hull;
  const std::vector<Eigen::Vector3d>& points;
};

/// Pairs whose differences y − x have all vertices of the hull of Y − X among them, as far as
/// double precision can tell. Both hulls have faces. A vertex of X and one of Y make a vertex of
/// the difference where some direction has both as its only support points; so each face of one
/// body goes with the other's support point, and each edge of X with the vertices of Y that support
/// the directions between those of its two faces.
[[nodiscard]] std::vector<gjk::VertexPair> pairs_of_hull(const SolidOf& x, const SolidOf& y);

/// The hull of all differences y − x in space. Vertices of the hulls of X and Y alone can be on it,
/// and of bodies with very many vertices pairs_of_hull alone are looked at.
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
