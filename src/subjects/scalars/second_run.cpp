#include "subjects/scalars/second_run.hpp"

#include "subjects/scalars/subject.hpp"

namespace gjkscope {

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
    const WideStep* beside = step_beside(value, run, {frame.run, i});
    if (!beside || beside->after.support.pair != steps[i].after.support.pair) value.parting = i;
  }
  return value;
}

const WideStep* step_beside(const SecondRun::Value& second, const LessonRun& run,
                            const Frame& frame) {
  if (frame.step < 0) return nullptr;
  const WideStep& step = run.step(frame);
  for (const WideStep& beside : second.run.trace.steps) {
    if (beside.phase == step.phase && beside.iteration == step.iteration) return &beside;
  }
  return nullptr;
}

const EffectInfo effect_infos::kSecondRun = effect_info<SecondRun>(
    "view", "the same query in another scalar: its closest point and search", {}, true);

}  // namespace gjkscope
