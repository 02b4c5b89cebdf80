#include "subjects/answer/cold_start.hpp"

#include "subjects/answer/subject.hpp"

namespace gjkscope {

EffectKey ColdStart::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

ColdStart::Value ColdStart::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const WideTrace cold = run_afresh(run, frame.run).trace;
  return {cold.result.iterations, support_calls(cold)};
}

const EffectInfo effect_infos::kColdStart =
    effect_info<ColdStart>("panel", "the same run without the warm start");

}  // namespace gjkscope
