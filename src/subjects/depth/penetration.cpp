#include "subjects/depth/penetration.hpp"

#include "subjects/depth/shown.hpp"

namespace gjkscope {

EffectKey PenetrationDepth::key(const LessonRun&, const Frame& frame) {
  return {frame.run, -1, -1};
}

PenetrationDepth::Value PenetrationDepth::compute(EffectGraph&, const LessonRun& run,
                                                  const Frame& frame) {
  if (const DepthResult* shown = depth_result(run, frame.run)) return *shown;
  return depth_of(run.run(frame), run.lesson.options, run.lesson.scalar);
}

const DepthResult* depth_on_overlap(EffectGraph& effects, const LessonRun& run,
                                    const Frame& frame) {
  const gjk::Verdict verdict = run.run(frame).trace.result.verdict;
  const bool overlap = verdict == gjk::Verdict::touching || verdict == gjk::Verdict::overlapping;
  return overlap ? &effects.get<PenetrationDepth>(frame) : nullptr;
}

const EffectInfo effect_infos::kPenetrationDepth =
    effect_info<PenetrationDepth>("frame", "the shortest way out of an overlap");

}  // namespace gjkscope
