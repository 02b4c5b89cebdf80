#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// The convex hulls of the shapes as they stand in the world: what GJK sees of them, since a vertex
/// inside of the hull lies farthest in no direction (Catto 2010, slides "Non-convex polygon").
struct ShapeHull {
  static constexpr std::string_view kName = "shape-hull";
  static constexpr std::string_view kNeeds = "";
  struct Hull {
    std::vector<int> corners;  ///< Counter-clockwise.
    std::vector<int> inside;   ///< Vertices off the hull, in their own order.
  };
  struct Value {
    Hull x;
    Hull y;
    Eigen::Vector2d outline_point =
        Eigen::Vector2d::Zero();    ///< On Y, not its hull: closest to X's first vertex.
    double outline_distance = 0.0;  ///< From X's first vertex to there; 0 inside of Y.
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
