#include <fmt/format.h>

#include "run/questions.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::acts {
namespace {

void answer_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[index].trace);
  run.frames.push_back({.run = index, .step = last});
}

Tick answer_tick(const LessonRun& run, const Frame& frame) {
  if (frame.step < 0) return tick_of_step(run, frame);
  const WideResult& result = run.run(frame).trace.result;
  if (!(result.distance > 0.0)) return {.group = "distance 0"};
  return {.group = fmt::format("{} – {}", feature_name(run, result.simplex, true),
                               feature_name(run, result.simplex, false))};
}

int answer_step(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  return is_at(frame, question) && has_closest(run, frame, question.ask) ? frame.step : -1;
}

/// At the new place, before anything is known of it.
Frame answer_asking(const LessonRun&, const Frame& frame) { return {.run = frame.run}; }

}  // namespace

const Act kAnswer{
    .name = "answer",
    .meaning = "position on the path: how the run there ends",
    .needs = {.takes_radius = true,
              .shown_of = ShownOf::both,
              .why_no_until = "frames show how the run ends"},
    .add_frames = answer_frames,
    .sweeps = true,
    .asks = asks::kOfAnswers,
    .answering_step = answer_step,
    .asking = answer_asking,
    .algorithm = &kGjkAlgorithm,
    .position = position_on_path,
    .tick = answer_tick,
    .words = captions::answer,
    .stage = layers::answer,
    .question = captions::closest_question,
};

}  // namespace gjkscope::acts
