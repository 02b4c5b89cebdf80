#include "effects/touched_points.hpp"

#include <algorithm>

namespace gjkscope {

namespace {

/// Number of steps that are over when a frame ends.
int steps_over(const LessonRun& run, const Frame& frame) {
  const bool in_parts = run.lesson.granularity == Granularity::support && frame.detail >= 0;
  return in_parts && frame.detail < kSupportOfZ ? frame.step : frame.step + 1;
}

}  // namespace

EffectKey TouchedPoints::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, steps_over(run, frame), -1};
}

TouchedPoints::Value TouchedPoints::compute(EffectGraph&, const LessonRun& run,
                                            const Frame& frame) {
  return touched_by(run, frame);
}

TouchedPoints::Value touched_by(const LessonRun& run, const Frame& frame) {
  const WideTrace& trace = run.run(frame).trace;
  TouchedPoints::Value touched;
  const auto touch = [&](const gjk::SupportPoint<double, 2>& point) {
    const bool known = std::any_of(touched.begin(), touched.end(),
                                   [&](const auto& earlier) { return earlier.pair == point.pair; });
    if (!known) touched.push_back(point);
  };
  for (int i = 0; i < trace.initial.simplex.count; ++i) touch(trace.initial.simplex.vertices[i]);
  for (int i = 0; i < steps_over(run, frame); ++i) {
    if (trace.steps[i].phase == gjk::Phase::support) touch(trace.steps[i].after.support);
  }
  return touched;
}

int support_calls_by(const LessonRun& run, const Frame& frame) {
  const auto& steps = run.run(frame).trace.steps;
  return static_cast<int>(
      std::count_if(steps.begin(), steps.begin() + steps_over(run, frame),
                    [](const auto& step) { return step.phase == gjk::Phase::support; }));
}

}  // namespace gjkscope
