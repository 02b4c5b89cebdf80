#include "picture/tour.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lesson/names.hpp"
#include "run/questions.hpp"
#include "run/trail.hpp"

namespace gjkscope {

bool asks_later(const LessonRun& run, int index) {
  return std::any_of(run.frames.begin() + index, run.frames.end(),
                     [](const Frame& later) { return later.question >= 0; });
}

std::string position_in_run(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const bool asks = asks_later(run, index);
  if (frame.step < 0)
    return asks ? "start" : fmt::format("start · {} of {}", index + 1, run.frames.size());
  if (is_trail(frame)) return "the run at a glance";
  const WideStep& step = run.step(frame);
  const std::string_view phase = name_of(step.phase);
  if (asks) return fmt::format("iteration {} · {}", step.iteration, phase);
  return fmt::format("iteration {} of {} · {}", step.iteration,
                     run.run(frame).trace.result.iterations, phase);
}

std::string position_on_path(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const std::string position = fmt::format("position {} of {}", frame.run + 1, run.runs.size());
  const bool has_clock = run.lesson.path_of_shapes && run.lesson.path_of_shapes->seconds;
  return has_clock ? fmt::format("{} · t = {} s", position, fixed(run.run(frame).time, 2))
                   : position;
}

std::string position_in_lesson(const LessonRun& run, int index) {
  if (run.lesson.path_of_shapes && run.lesson.path_of_shapes->seconds)
    return position_on_path(run, index);
  return asks_later(run, index) ? fmt::format("step {}", index + 1)
                                : fmt::format("{} of {}", index + 1, run.frames.size());
}

Tick tick_of_step(const LessonRun& run, const Frame& frame) {
  if (frame.step < 0) return {.group = "start", .label = "start"};
  if (is_trail(frame)) return {.group = "at a glance", .label = "at a glance"};
  const WideStep& step = run.step(frame);
  const std::string phase(name_of(step.phase));
  std::string dropped;
  for (const WideVertex& vertex : step.record.dropped)
    dropped += (dropped.empty() ? " " : ", ") + run.pair_name(vertex.pair);
  return {.group = fmt::format("iteration {}", step.iteration),
          .label = phase + dropped,
          .short_label = phase,
          .event = run.info(frame).is_event};
}

std::string group_of_position(const LessonRun& run, const Frame& frame,
                              const std::string& otherwise) {
  return run.runs.size() > 1 ? fmt::format("position {}", frame.run + 1) : otherwise;
}

void add_step_frames(LessonRun& run, int index,
                     bool (*shows)(const LessonRun&, int index, int step)) {
  run.frames.push_back({.run = index});
  const int last = last_step(run.lesson, run.runs[index].trace);
  for (int i = 0; i <= last; ++i) {
    if (shows(run, index, i)) run.frames.push_back({.run = index, .step = i});
  }
}

void add_algorithm_frames(LessonRun& run, int index) {
  const int steps = run.algorithm_traces[index]->steps();
  for (int i = -1; i <= (steps > 0 ? steps : -1); ++i)
    run.frames.push_back({.run = index, .step = i});
}

namespace {

enum class AlgorithmPart { start, step, answer };
AlgorithmPart part_of(const LessonRun& run, const Frame& frame) {
  if (frame.step < 0) return AlgorithmPart::start;
  return frame.step < run.algorithm_trace(frame).steps() ? AlgorithmPart::step
                                                         : AlgorithmPart::answer;
}

}  // namespace

std::string position_in_algorithm(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const AlgorithmPart part = part_of(run, frame);
  if (part == AlgorithmPart::start) return "start";
  if (part == AlgorithmPart::answer)
    return fmt::format("answer · {} of {}", index + 1, run.frames.size());
  const StepInfo at = run.info(frame);
  if (run.runs.size() > 1) return fmt::format("{} · {}", position_on_path(run, index), at.phase);
  if (asks_later(run, index)) return fmt::format("iteration {} · {}", at.iteration, at.phase);
  const AlgorithmTrace& trace = run.algorithm_trace(frame);
  return fmt::format("iteration {} of {} · {}", at.iteration,
                     trace.info(trace.steps() - 1).iteration, at.phase);
}

Tick tick_of_algorithm(const LessonRun& run, const Frame& frame) {
  const AlgorithmPart part = part_of(run, frame);
  if (part == AlgorithmPart::start)
    return {.group = group_of_position(run, frame, "start"), .label = "start"};
  if (part == AlgorithmPart::answer)
    return {.group = group_of_position(run, frame, "answer"),
            .label = "answer",
            .short_label = "end",
            .event = true};
  const StepInfo at = run.info(frame);
  return {.group = group_of_position(run, frame, fmt::format("iteration {}", at.iteration)),
          .label = std::string(at.phase),
          .event = at.is_event};
}

int answering_step_of_run(const LessonRun& run, const Frame& before, const Frame& frame,
                          const LessonQuestion& question) {
  const WideTrace& trace = run.run(frame).trace;
  for (int i = before.step + 1; i <= frame.step; ++i) {
    const bool is_asked =
        tells(trace, i, question.ask) && (!question.at || *question.at == trace.steps[i].iteration);
    if (is_asked && is_open(run, trace, question.ask, i)) return i;
  }
  return -1;
}

}  // namespace gjkscope
