#include "subjects/support/touched_points.hpp"

#include <algorithm>

#include "run/facts.hpp"
#include "subjects/support/subject.hpp"

namespace gjkscope {

EffectKey TouchedPoints::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

TouchedPoints::Value TouchedPoints::compute(EffectGraph& graph, const LessonRun& run,
                                            const Frame& frame) {
  const int over = graph.get<FrameFacts>(frame).steps;
  const WideTrace& trace = run.run(frame).trace;
  Value touched;
  const auto touch = [&](const WideVertex& point) {
    const bool known = std::any_of(touched.begin(), touched.end(),
                                   [&](const auto& earlier) { return earlier.pair == point.pair; });
    if (!known) touched.push_back(point);
  };
  for (int i = 0; i < trace.initial.simplex.count; ++i) touch(trace.initial.simplex.vertices[i]);
  for (int i = 0; i < over; ++i) {
    if (trace.steps[i].phase == gjk::Phase::support) touch(trace.steps[i].after.support);
  }
  return touched;
}

const EffectInfo effect_infos::kTouchedPoints = shown_of(
    ShownOf::both,
    effect_info<TouchedPoints>("view", "the differences that the run has computed so far"));

}  // namespace gjkscope
