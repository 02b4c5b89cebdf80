#include <array>

#include "run/questions.hpp"
#include "subjects/issues/subject.hpp"

namespace gjkscope::tours {
namespace {

void issues_frames(LessonRun& run, int index) {
  run.frames.push_back({.run = index});
  const int last = last_step(run.lesson, run.runs[index].trace);
  if (last >= 0) run.frames.push_back({.run = index, .step = last});
}

Tick issues_tick(const LessonRun& run, const Frame& frame) {
  return {.group = group_of_position(run, frame, "position"),
          .label = frame.step < 0 ? "start" : "stop",
          .event = frame.step >= 0};
}

constexpr std::array kAsks = {AskInfo{asks::kStop.name, asks::kStop.meaning, "at position"},
                              asks::kClosestY};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  if (question.ask == asks::kClosestY.name) {
    const Frame end{.run = frame.run, .step = last_step(run.lesson, run.run(frame).trace)};
    const bool answers = frame.step < 0 && is_at(frame, question);
    return answers && has_closest(run, end, question.ask) ? end.step : -1;
  }
  return frame.step >= 0 && question.at.value_or(frame.run + 1) == frame.run + 1 ? frame.step : -1;
}

/// The frame before the first one that shows the place of Q, or how the run ends there.
Frame asking(const LessonRun&, const Frame& frame) { return {.run = frame.run}; }

}  // namespace

const Tour kIssues{
    .name = "issues",
    .meaning =
        "place of Q, then for how GJK ends there: the numerical issues, one for "
        "each place of Q; for a point query",
    .needs = {.start = 1, .why_no_until = "frames show how the run ends"},
    .add_frames = issues_frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kGjkAlgorithm,
    .position = position_on_path,
    .tick = issues_tick,
    .start = captions::issue,
    .words = captions::issue_solved,
    .stage = layers::issue,
    .question = captions::issue_question,
};

}  // namespace gjkscope::tours
