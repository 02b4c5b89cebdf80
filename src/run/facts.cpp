#include "run/facts.hpp"

#include <algorithm>

#include "lesson/vocabulary.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

using gjk::Phase;

EffectKey FrameFacts::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

FrameFacts::Value FrameFacts::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value facts;
  const int at = run.gjk_step(frame);
  if (at < 0) return facts;
  const auto& steps = run.run(frame).trace.steps;
  const WideStep& step = run.step(frame);
  facts.phase = step.phase;
  facts.steps = at + 1;
  if (facts.phase_is(Phase::closest)) facts.region_tests = step.record.region_tests;
  facts.tests_reached = static_cast<int>(facts.region_tests.size()) - 1;
  // P is found by a step that measures or uses it.
  facts.closest_point = !facts.phase_is(Phase::add);
  facts.support = facts.phase_is(Phase::support) ||
                  (facts.phase_is(Phase::stop) && steps[at - 1].phase == Phase::support);
  facts.whole_support = facts.support;
  facts.has_ended = step.after.stop != gjk::StopReason::running;
  facts.distance = facts.has_ended;
  if (frame.part >= 0 && run.tour->knows != nullptr) run.tour->knows(frame, facts);
  facts.is_at_query = facts.closest_point && step.after.p_sq == 0.0;
  facts.direction = facts.phase_is(Phase::direction) || facts.support;
  facts.support_calls = static_cast<int>(
      std::count_if(steps.begin(), steps.begin() + facts.steps,
                    [](const auto& each) { return each.phase == Phase::support; }));
  return facts;
}

const EffectInfo effect_infos::kFrameFacts =
    effect_info<FrameFacts>("frame", "what is known when a frame is shown");

}  // namespace gjkscope
