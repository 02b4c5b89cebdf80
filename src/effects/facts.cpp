#include "effects/facts.hpp"

#include <algorithm>

namespace gjkscope {
namespace {

using gjk::Phase;

/// P is found by a step that measures or uses it; where frames take such a step apart, by the last.
bool knows_closest_point(const LessonRun& run, const Frame& frame, const FrameFacts::Value& facts) {
  if (!facts.phase || facts.phase_is(Phase::add)) return false;
  if (run.lesson.granularity == Granularity::orders) return frame.detail > 0;
  if (run.lesson.granularity != Granularity::test) return true;
  return frame.detail >= 0 && facts.region_tests[static_cast<std::size_t>(frame.detail)].holds;
}

bool is_in_parts(const LessonRun& run, const Frame& frame) {
  return run.lesson.granularity == Granularity::support && frame.detail >= 0;
}

}  // namespace

int steps_over(const LessonRun& run, const Frame& frame) {
  return is_in_parts(run, frame) && frame.detail < kSupportOfZ ? frame.step : frame.step + 1;
}

EffectKey FrameFacts::key(const LessonRun&, const Frame& frame) {
  return {frame.run, frame.step, frame.detail};
}

FrameFacts::Value FrameFacts::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value facts;
  const auto& steps = run.run(frame).trace.steps;
  facts.support_calls = static_cast<int>(
      std::count_if(steps.begin(), steps.begin() + steps_over(run, frame),
                    [](const auto& step) { return step.phase == Phase::support; }));
  if (frame.step < 0) return facts;
  const gjk::Step<double, 2>& step = run.step(frame);
  facts.phase = step.phase;
  if (facts.phase_is(Phase::closest)) facts.region_tests = step.record.region_tests;
  facts.tests_reached = run.lesson.granularity == Granularity::test
                            ? frame.detail
                            : static_cast<int>(facts.region_tests.size()) - 1;
  facts.stop_follows_scan =
      facts.phase_is(Phase::stop) && run.run(frame).follows_support(frame.step);
  facts.closest_point = knows_closest_point(run, frame, facts);
  facts.is_at_query = facts.closest_point && step.after.p_sq == 0.0;
  facts.support = facts.phase_is(Phase::support) || facts.stop_follows_scan;
  facts.whole_support = is_in_parts(run, frame) ? frame.detail == kSupportOfZ : facts.support;
  facts.direction = facts.phase_is(Phase::direction) || facts.support;
  facts.has_ended = step.after.stop != gjk::StopReason::running;
  return facts;
}

}  // namespace gjkscope
