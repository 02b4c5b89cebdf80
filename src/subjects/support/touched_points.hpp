#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// The points of the Minkowski difference that the run has computed by a frame's step, each once,
/// in the order in which it met them: those that it started from, and its support points. A support
/// point that frames put together from its parts counts when it is whole.
struct TouchedPoints {
  static constexpr std::string_view kName = "touched-points";
  static constexpr std::string_view kNeeds = "facts";
  using Value = std::vector<WideVertex>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
