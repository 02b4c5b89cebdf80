#pragma once
#include "outlines/minkowski.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Every difference y - x (Catto 2010, slides "Example point cloud").
struct MinkowskiCloud {
  static constexpr std::string_view kName = "minkowski-cloud";
  static constexpr std::string_view kNeeds = "";
  using Value = std::vector<CloudPoint>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Corners of the hull of the differences (Catto 2010, slide "The final polygon").
struct MinkowskiHull {
  static constexpr std::string_view kName = "minkowski-hull";
  static constexpr std::string_view kNeeds = "";
  using Value = std::vector<CloudPoint>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
