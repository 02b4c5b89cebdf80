#include "effects/slab.hpp"

namespace gjkscope {

EffectKey Slab::key(const LessonRun&, const Frame& frame) { return {frame.run, frame.step, -1}; }

Slab::Value Slab::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  return widest_strip(run, frame);
}

Slab::Value widest_strip(const LessonRun& run, const Frame& frame) {
  Slab::Value widest;
  for (int i = 0; i <= frame.step; ++i) {
    const gjk::Step<double, 2>& step = run.run(frame).trace.steps[i];
    const gjk::State<double, 2>& state = step.after;
    if (step.phase != gjk::Phase::support || !(state.d.norm() > 0.0)) continue;
    const double width = -state.support_value / state.d.norm();
    if (width > (widest ? widest->width : 0.0))
      widest = Slab::Strip{state.support, state.d.normalized(), width};
  }
  return widest;
}

bool is_found_by(const Slab::Strip& strip, const gjk::State<double, 2>& state) {
  return strip.support.pair == state.support.pair && strip.normal == state.d.normalized();
}

}  // namespace gjkscope
