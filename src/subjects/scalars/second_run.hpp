#pragma once
#include <optional>

#include "run/graph.hpp"

namespace gjkscope {

/// The same query in the lesson's other scalar (`query.beside`): what rounding did to the run shows
/// beside a run that rounds otherwise, or not at all.
struct SecondRun {
  static constexpr std::string_view kName = "second-run";
  static constexpr std::string_view kNeeds = "";
  struct Value {
    PositionedRun run;
    int parting = -1;  ///< Index of the first step of the lesson's run with another support point
                       ///< than the second run's, or with none beside it; -1: there is no such.
    /// The lesson's run with d perpendicular to the edge, where the second run alone ends inside.
    std::optional<PositionedRun> mended = std::nullopt;
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  /// Only for lessons that have a second scalar.
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The second run's step of the same iteration and phase as the frame's; null where it has none.
[[nodiscard]] const WideStep* step_beside(const SecondRun::Value& second, const LessonRun& run,
                                          const Frame& frame);

}  // namespace gjkscope
