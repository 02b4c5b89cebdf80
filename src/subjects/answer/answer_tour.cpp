#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "run/questions.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
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
                                    asks::kOriginIn, asks::kMeets,    asks::kSlide,
                                    asks::kHolds};

/// It is asked before shapes move.
bool asks_of_move(std::string_view ask) {
  return ask == asks::kSlide.name || ask == asks::kHolds.name;
}

/// The last step of the position before, which has a frame of its own.
int step_before(const LessonRun& run, const Frame& frame) {
  return last_step(run.lesson, run.runs[static_cast<std::size_t>(frame.run) - 1].trace);
}

int step_before_move(const LessonRun& run, const Frame& frame, const LessonQuestion& question) {
  if (frame.run == 0 || !run.lesson.calls_for(LastPosition::kName)) return -1;
  EffectGraph effects(run);
  const LastPosition::Value last = effects.get<LastPosition>(frame);
  const bool slides = !last->turned && last->y_by != last->x_by;
  const bool is_open = question.ask == asks::kSlide.name ? slides : !last->turned;
  return is_open ? std::min(frame.step, step_before(run, frame)) : -1;
}

int answer_step(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  const bool is_of_z = question.ask == asks::kClosestZ.name ||
                       question.ask == asks::kOriginIn.name || asks_of_move(question.ask);
  const bool shows_z =
      run.lesson.dimension == 2 &&
      std::any_of(run.lesson.views.begin(), run.lesson.views.end(),
                  [](const LessonView& view) { return view.kind == ViewKind::difference; });
  if (!is_at(frame, question) || (is_of_z && !shows_z)) return -1;
  if (asks_of_move(question.ask)) return step_before_move(run, frame, question);
  if (question.ask == asks::kMeets.name && !run.lesson.calls_for(GrownObstacle::kName)) return -1;
  const bool is_open =
      question.ask == asks::kOriginIn.name || has_closest(run, frame, question.ask);
  return is_open ? frame.step : -1;
}

void answer_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask == asks::kOriginIn.name) return captions::overlap_question(story, text);
  if (ask == asks::kSlide.name) return captions::slide_question(story, text);
  if (ask == asks::kHolds.name) return captions::holds_question(story, text);
  if (ask == asks::kClosestZ.name || ask == asks::kMeets.name)
    return captions::closest_of_difference_question(story, text);
  captions::closest_question(story, text);
}

/// At the new place, before anything is known of it; of a move, at the last one.
Frame answer_asking(const LessonRun& run, const Frame& frame) {
  return {.run = asks_of_move(run.asked(frame).ask) ? frame.run - 1 : frame.run};
}

}  // namespace

const Tour kAnswer{
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

}  // namespace gjkscope::tours
