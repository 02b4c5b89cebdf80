#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// Both ways to build the search direction from a segment, in the lesson's scalar, and how far each
/// is from being perpendicular to it (Catto 2010, slides "A bad direction" and "An accurate search
/// direction").
struct DirectionRules {
  static constexpr std::string_view kName = "direction-rules";
  static constexpr std::string_view kNeeds = "";
  struct Built {
    gjk::DirectionRule rule = gjk::DirectionRule::perpendicular;
    Eigen::Vector3d d = Eigen::Vector3d::Zero();
    double dot_with_edge = 0.0;
    double degrees_off = 0.0;  ///< From being perpendicular to the edge.
  };
  /// Both rules; empty where the simplex is not a segment.
  using Value = std::vector<Built>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
