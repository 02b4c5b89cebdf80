#include "subjects/scalars/second_run.hpp"

#include "subjects/scalars/subject.hpp"

namespace gjkscope {
namespace {

/// The step of the same iteration and phase.
const WideStep* same_step(const WideTrace& trace, const WideStep& step) {
  for (const WideStep& each : trace.steps) {
    if (each.phase == step.phase && each.iteration == step.iteration) return &each;
  }
  return nullptr;
}

}  // namespace

EffectKey SecondRun::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

SecondRun::Value SecondRun::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const PositionedRun& first = run.run(frame);
  Value value{run_again(first, started_as(first, run.lesson.options), run.lesson.beside.value())};
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

const EffectInfo effect_infos::kSecondRun = effect_info<SecondRun>(
    "view", "the same query in another scalar: its closest point and search", {}, true);

}  // namespace gjkscope
