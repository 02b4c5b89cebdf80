#include "subjects/support/slab.hpp"

#include "subjects/support/subject.hpp"

namespace gjkscope {

EffectKey BestSupport::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), -1};
}

BestSupport::Value BestSupport::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value widest;
  const int last = run.gjk_step(frame);
  for (int i = 0; i <= last; ++i) {
    const WideStep& step = run.run(frame).trace.steps[i];
    const WideState& state = step.after;
    if (step.phase != gjk::Phase::support || !(state.d.norm() > 0.0)) continue;
    const double width = -state.support_value / state.d.norm();
    if (width > (widest ? widest->width : 0.0))
      widest = Strip{state.support, state.d.normalized(), width};
  }
  return widest;
}

bool is_found_by(const BestSupport::Strip& strip, const WideState& state) {
  return strip.support.pair == state.support.pair && strip.normal == state.d.normalized();
}

EffectKey Slab::key(const LessonRun& run, const Frame& frame) {
  return BestSupport::key(run, frame);
}

Slab::Value Slab::compute(EffectGraph& graph, const LessonRun&, const Frame& frame) {
  return graph.get<BestSupport>(frame);
}

const EffectInfo effect_infos::kBestSupport =
    effect_info<BestSupport>("frame", "the support line that proves most of the distance");

const EffectInfo effect_infos::kSlab = shown_of(
    ShownOf::both, effect_info<Slab>("view", "the widest strip proved empty between X and Y"));

}  // namespace gjkscope
