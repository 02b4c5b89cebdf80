#include <fmt/format.h>

#include "subjects/answer/subject.hpp"

namespace gjkscope::acts {
namespace {

void answer_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[static_cast<std::size_t>(index)].trace);
  run.frames.push_back({.run = index, .step = last});
}

Tick answer_tick(const LessonRun& run, const Frame& frame) {
  if (frame.step < 0) return tick_of_step(run, frame);
  const WideResult& result = run.run(frame).trace.result;
  if (!(result.distance > 0.0)) return {.group = "distance 0"};
  return {.group = fmt::format("{} – {}", feature_name(run, result.simplex, true),
                               feature_name(run, result.simplex, false))};
}

}  // namespace

const Act kAnswer{
    .name = "answer",
    .meaning = "position on the path: how the run there ends",
    .needs = {.takes_radius = true, .why_no_until = "frames show how the run ends"},
    .add_frames = answer_frames,
    .algorithm = &kGjkAlgorithm,
    .position = position_on_path,
    .tick = answer_tick,
    .words = captions::answer,
    .stage = layers::answer,
};

}  // namespace gjkscope::acts
