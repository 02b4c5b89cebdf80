#pragma once
// The cost of time steps: the state of scenes with a clock against the size of the step.

#include <functional>
#include <string>
#include <vector>

#include "run/run.hpp"
#include "study/interleave.hpp"

namespace gjkscope {

/// A step of the simulation of a beam (subjects/balance/balance.hpp), or between the positions of
/// shapes that move.
struct TimeStepCost {
  std::string lesson;
  double step = 0.0;        ///< Seconds.
  bool is_shown = false;    ///< It is the lesson's own.
  double error = 0.0;       ///< Error of a beam's angle at the lesson's moments, the largest over
                            ///< its runs, in radians, against steps of kFinestStep. Of a motion:
                            ///< of the place of a vertex at the moments that the coarsest step
                            ///< shares with the others, in the world's unit, against the finest.
  double iterations = 0.0;  ///< On average over the runs of a motion,
  double cold_iterations = 0.0;  ///< and when each run starts anew.
  int repetitions = 0;
  study::Quartiles ns;  ///< For each second that passes in the scene.
};

inline constexpr double kFinestStep = 0x1p-18;

/// Rows from the largest step to the smallest. Empty for a lesson without a clock, and when `go_on`
/// said no before all steps were timed.
[[nodiscard]] std::vector<TimeStepCost> time_step_costs(
    const Lesson& lesson, int repetitions,
    const std::function<bool()>& go_on = [] { return true; });

/// For a terminal.
[[nodiscard]] std::string time_steps_table(const std::vector<TimeStepCost>& rows);
/// A line of names, then one line a row.
[[nodiscard]] std::string time_steps_csv(const std::vector<TimeStepCost>& rows);

}  // namespace gjkscope
