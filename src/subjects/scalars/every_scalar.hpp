#pragma once
#include <array>
#include <string>

#include "run/graph.hpp"

namespace gjkscope {

/// The lesson's query in all four scalars, each from the vertices as the file has them: a scalar
/// rounds them first. The exact run, the last, says what is right.
struct EveryScalar {
  static constexpr std::string_view kName = "every-scalar";
  static constexpr std::string_view kNeeds = "";
  struct Answer {
    ScalarKind scalar;
    PositionedRun run;
    std::string refused;  ///< Why there is no answer; empty where there is one.
    int parting = 0;      ///< The first iteration with another support point than the exact run, or
                          ///< in which only one of both runs ends; 0: there is no such.
  };
  using Value = std::array<Answer, 4>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The step of an iteration in which a run asked for a support point; null where it asked for none.
[[nodiscard]] const WideStep* support_step(const PositionedRun& run, int iteration);

}  // namespace gjkscope
