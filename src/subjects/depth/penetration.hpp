#pragma once
#include "run/graph.hpp"
#include "subjects/depth/lesson_trace.hpp"

namespace gjkscope {

/// How deep the shapes of a run lie in each other (depth.hpp), in the lesson's scalar.
struct PenetrationDepth {
  static constexpr std::string_view kName = "penetration-depth";
  static constexpr std::string_view kNeeds = "";
  using Value = DepthResult;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The depth of the frame's shapes; nullptr, and nothing is computed, where they are apart.
[[nodiscard]] const DepthResult* depth_on_overlap(EffectGraph& effects, const LessonRun& run,
                                                  const Frame& frame);

}  // namespace gjkscope
