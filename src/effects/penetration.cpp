#include "effects/penetration.hpp"

#include "effects/registry.hpp"

namespace gjkscope {

EffectKey PenetrationDepth::key(const LessonRun&, const Frame& frame) {
  return {frame.run, -1, -1};
}

PenetrationDepth::Value PenetrationDepth::compute(EffectGraph&, const LessonRun& run,
                                                  const Frame& frame) {
  if (!run.depths.empty()) return run.depths[static_cast<std::size_t>(frame.run)];
  return depth_of(run.run(frame), run.lesson.options, run.lesson.scalar);
}

const EffectInfo effect_infos::kPenetrationDepth =
    effect_info<PenetrationDepth>("frame", "the shortest way out of an overlap");

}  // namespace gjkscope
