#include "subjects/run/history.hpp"

#include "subjects/run/subject.hpp"

namespace gjkscope {

EffectKey History::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.state(frame).iteration, -1};
}

History::Value History::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value entries;
  const int now = run.state(frame).iteration;
  for (const WideStep& step : run.run(frame).trace.steps) {
    if (step.phase == gjk::Phase::drop && step.iteration < now) {
      entries.push_back({step.iteration, step.after.simplex, step.after.p});
    }
  }
  return entries;
}

const EffectInfo effect_infos::kHistory =
    shown_of(ShownOf::both,
             effect_info<History>("view", "simplices and closest points of earlier iterations"));

}  // namespace gjkscope
