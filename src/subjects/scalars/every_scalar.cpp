#include "subjects/scalars/every_scalar.hpp"

#include <algorithm>

#include "subjects/scalars/subject.hpp"

namespace gjkscope {
namespace {

int parting_of(const PositionedRun& run, const PositionedRun& exact) {
  const int last = std::max(run.trace.result.iterations, exact.trace.result.iterations);
  for (int iteration = 1; iteration <= last; ++iteration) {
    const WideStep* mine = support_step(run, iteration);
    const WideStep* right = support_step(exact, iteration);
    if ((mine == nullptr) != (right == nullptr)) return iteration;
    if (mine != nullptr && mine->after.support.pair != right->after.support.pair) return iteration;
    const bool ends = run.trace.result.iterations == iteration;
    if (ends != (exact.trace.result.iterations == iteration)) return iteration;
  }
  return 0;
}

}  // namespace

const WideStep* support_step(const PositionedRun& run, int iteration) {
  for (const WideStep& step : run.trace.steps) {
    if (step.iteration == iteration && step.phase == gjk::Phase::support) return &step;
  }
  return nullptr;
}

EffectKey EveryScalar::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

EveryScalar::Value EveryScalar::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const auto answer = [&](ScalarKind scalar) {
    Lesson lesson = run.lesson;
    lesson.scalar = scalar;
    PositionedRun again = run_lesson(std::move(lesson), *run.tour).runs[frame.run];
    std::string refused = why_not_drawn(again);
    return Answer{scalar, std::move(again), std::move(refused), 0};
  };
  Value value = {answer(ScalarKind::half), answer(ScalarKind::single), answer(ScalarKind::double_),
                 answer(ScalarKind::exact)};
  for (Answer& each : value) {
    if (each.refused.empty()) each.parting = parting_of(each.run, value.back().run);
  }
  return value;
}

const EffectInfo effect_infos::kEveryScalar = effect_info<EveryScalar>(
    "panel", "the lesson's query in half, float, double and exact numbers");

}  // namespace gjkscope
