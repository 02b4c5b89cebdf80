#pragma once
#include <optional>

#include "run/graph.hpp"
#include "subjects/second_run/table.hpp"

namespace gjkscope {

/// The same query in another scalar ([second]): what rounding did to the run shows beside a run
/// that rounds otherwise, or not at all.
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
  /// Only for lessons that have a second run in a scalar.
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Index of the step of a phase in an iteration; -1 where there is none.
[[nodiscard]] int index_of_step(const WideTrace& trace, int iteration, gjk::Phase phase);

/// Index of the last step that is no later than that phase of that iteration; -1: the start.
[[nodiscard]] int index_up_to(const WideTrace& trace, int iteration, gjk::Phase phase);

/// GJK about the shapes of `first`, the run of a lesson with these options and this scalar, from
/// where that started, by the rules of [second].
[[nodiscard]] PositionedRun second_of_gjk(const LessonSecond& second, const PositionedRun& first,
                                          const gjk::Options& options, ScalarKind scalar);

/// The second run's step of the same iteration and phase as the frame's; null where it has none.
[[nodiscard]] const WideStep* step_beside(const SecondRun::Value& second, const LessonRun& run,
                                          const Frame& frame);

}  // namespace gjkscope
