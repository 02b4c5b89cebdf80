#include "run/facts.hpp"

#include <algorithm>

#include "run/effect_info.hpp"

namespace gjkscope {
namespace {

using gjk::Phase;

/// P is found by a step that measures or uses it; where frames take such a step apart, by the last.
bool knows_closest_point(const Frame& frame, const FrameFacts::Value& facts) {
  if (!facts.phase || facts.phase_is(Phase::add)) return false;
  if (const auto* stage = frame.part.as<OrderStage>()) return *stage > OrderStage::numbers;
  if (!facts.gradual) return true;
  return facts.tests_reached >= 0 &&
         facts.region_tests[static_cast<std::size_t>(facts.tests_reached)].holds;
}

}  // namespace

int steps_over(const Frame& frame) {
  return frame.part.value_or(SupportPart::of_z) < SupportPart::of_z ? frame.step : frame.step + 1;
}

EffectKey FrameFacts::key(const LessonRun&, const Frame& frame) {
  return {frame.run, frame.step, frame.part.index()};
}

FrameFacts::Value FrameFacts::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value facts;
  const auto& steps = run.run(frame).trace.steps;
  facts.support_calls = static_cast<int>(
      std::count_if(steps.begin(), steps.begin() + steps_over(frame),
                    [](const auto& step) { return step.phase == Phase::support; }));
  if (frame.step < 0) return facts;
  const gjk::Step<double, 2>& step = run.step(frame);
  facts.phase = step.phase;
  if (facts.phase_is(Phase::closest)) facts.region_tests = step.record.region_tests;
  const auto* tried = frame.part.as<TriedTests>();
  facts.gradual = tried != nullptr;
  facts.tests_reached = (tried ? tried->count : static_cast<int>(facts.region_tests.size())) - 1;
  facts.closest_point = knows_closest_point(frame, facts);
  facts.is_at_query = facts.closest_point && step.after.p_sq == 0.0;
  facts.support = facts.phase_is(Phase::support) ||
                  (facts.phase_is(Phase::stop) && steps[frame.step - 1].phase == Phase::support);
  const auto* part = frame.part.as<SupportPart>();
  facts.whole_support = part ? *part == SupportPart::of_z : facts.support;
  facts.direction = facts.phase_is(Phase::direction) || facts.support;
  facts.has_ended = step.after.stop != gjk::StopReason::running;
  return facts;
}

const EffectInfo effect_infos::kFrameFacts =
    effect_info<FrameFacts>("frame", "what is known when a frame is shown");

}  // namespace gjkscope
