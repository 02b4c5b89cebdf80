#include <fmt/format.h>

#include <algorithm>
#include <array>

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

constexpr std::array kAnswerAsks = {asks::kClosestX, asks::kClosestY, asks::kClosestZ,
                                    asks::kOriginIn};

int answer_step(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  const bool is_of_z = question.ask == asks::kClosestZ.name || question.ask == asks::kOriginIn.name;
  const bool shows_z =
      run.lesson.dimension == 2 &&
      std::any_of(run.lesson.views.begin(), run.lesson.views.end(),
                  [](const LessonView& view) { return view.kind == ViewKind::difference; });
  if (!is_at(frame, question) || (is_of_z && !shows_z)) return -1;
  const bool is_open =
      question.ask == asks::kOriginIn.name || has_closest(run, frame, question.ask);
  return is_open ? frame.step : -1;
}

void answer_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask == asks::kOriginIn.name) return captions::overlap_question(story, text);
  if (ask == asks::kClosestZ.name) return captions::closest_of_difference_question(story, text);
  captions::closest_question(story, text);
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
    .asks = kAnswerAsks,
    .answering_step = answer_step,
    .asking = answer_asking,
    .algorithm = &kGjkAlgorithm,
    .position = position_on_path,
    .tick = answer_tick,
    .words = captions::answer,
    .stage = layers::answer,
    .question = answer_question,
};

}  // namespace gjkscope::acts
