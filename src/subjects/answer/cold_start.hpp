#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// The cost of the run of a frame's position when it starts as the lesson's first run does, and not
/// from the final simplex of the run before: a second run, traced like the first.
struct ColdStart {
  static constexpr std::string_view kName = "cold-start";
  static constexpr std::string_view kNeeds = "";
  struct Value {
    int iterations = 0;
    int support_calls = 0;
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
