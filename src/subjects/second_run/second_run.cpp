#include "subjects/second_run/second_run.hpp"

#include <algorithm>
#include <cassert>

#include "subjects/second_run/subject.hpp"

namespace gjkscope {
int index_of_step(const WideTrace& trace, int iteration, gjk::Phase phase) {
  const auto found = std::find_if(
      trace.steps.begin(), trace.steps.end(),
      [&](const WideStep& each) { return each.iteration == iteration && each.phase == phase; });
  return found == trace.steps.end() ? -1 : static_cast<int>(found - trace.steps.begin());
}

int index_up_to(const WideTrace& trace, int iteration, gjk::Phase phase) {
  int found = -1;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const WideStep& step = trace.steps[i];
    if (step.iteration < iteration || (step.iteration == iteration && step.phase <= phase))
      found = static_cast<int>(i);
  }
  return found;
}

PositionedRun second_of_gjk(const LessonSecond& second, const PositionedRun& first,
                            const gjk::Options& options, ScalarKind scalar) {
  return run_again(first, second.options(started_as(first, options)),
                   second.scalar.value_or(scalar));
}

namespace {

const WideStep* same_step(const WideTrace& trace, const WideStep& step) {
  const int index = index_of_step(trace, step.iteration, step.phase);
  return index < 0 ? nullptr : &trace.steps[index];
}

}  // namespace

EffectKey SecondRun::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

SecondRun::Value SecondRun::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const PositionedRun& first = run.run(frame);
  const LessonSecond* second = second_of(run.lesson);
  assert(second != nullptr && second->scalar);
  Value value{second_of_gjk(*second, first, run.lesson.options, run.lesson.scalar)};
  const auto is_inside = [](const PositionedRun& each) {
    return each.trace.result.distance == 0.0;
  };
  if (is_inside(value.run) && !is_inside(first)) {
    gjk::Options options = started_as(first, run.lesson.options);
    options.direction_rule = gjk::DirectionRule::perpendicular;
    value.mended = run_again(first, options, run.lesson.scalar);
  }
  const std::vector<WideStep>& steps = first.trace.steps;
  for (int i = 0; i < static_cast<int>(steps.size()) && value.parting < 0; ++i) {
    if (steps[i].phase != gjk::Phase::support) continue;
    const WideStep* beside = same_step(value.run.trace, steps[i]);
    if (!beside || beside->after.support.pair != steps[i].after.support.pair) value.parting = i;
  }
  return value;
}

const WideStep* step_beside(const SecondRun::Value& second, const LessonRun& run,
                            const Frame& frame) {
  return run.gjk_step(frame) < 0 ? nullptr : same_step(second.run.trace, run.step(frame));
}

const EffectInfo effect_infos::kSecondRun = shown_of(
    ShownOf::both,
    effect_info<SecondRun>("view", "the same query in another scalar: its closest point and search",
                           {}, LessonSecond::kTable));

}  // namespace gjkscope
