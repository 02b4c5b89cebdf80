#pragma once
// The cost of effects: the frames of each lesson, with each effect and without.

#include <functional>
#include <string>
#include <vector>

#include "picture/type.hpp"
#include "run/run.hpp"
#include "study/interleave.hpp"

namespace gjkscope {

struct EffectCost {
  std::string lesson;
  std::string effect;  ///< Empty in the last row of a lesson, for all that nothing calls for.
  std::string off;     ///< Things taken away to be without it: "hull in a view, block bounds".
  int frames = 0;
  long pulls = 0;           ///< How often the frames ask for it, and
  long runs = 0;            ///< how often it is computed for them.
  long pulls_off = 0;       ///< Not 0: the lesson cannot be without it, and there is no ratio.
  double share = 0.0;       ///< The share of the frames' time spent computing it and what it pulls.
  int repetitions = 0;      ///< Repetitions of the timing. Without any the rest is 0.
  study::Quartiles ns;      ///< Per frame, with it.
  study::Quartiles ns_off;  ///< Without it.
  study::Quartiles ratio;   ///< With it to without, repetition by repetition.
};

/// Times how long the frames of a lesson take to build (layout, words and marks; painting them
/// comes after and does not know of effects). For each effect that is called for, with it and
/// without all that calls for it. The last row times the lesson against a copy of itself: how far
/// the effects that nothing calls for, which are never computed, are from costing nothing, and how
/// large the noise is. `seconds`: of timing, about. Ended early by `go_on`, it has no rows or those
/// that were timed.
[[nodiscard]] std::vector<EffectCost> effects_cost(
    const LessonRun& run, const Fonts& fonts, double seconds,
    const std::function<bool()>& go_on = [] { return true; });

/// For a terminal.
[[nodiscard]] std::string effects_table(const std::vector<EffectCost>& rows);
/// A line of names, then one line a row.
[[nodiscard]] std::string effects_csv(const std::vector<EffectCost>& rows);

}  // namespace gjkscope
