#include "subjects/answer/tour.hpp"

#include <fmt/format.h>

#include <array>

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

constexpr std::array<std::string_view, 4> kWitnessParts = {"P", "on Y", "on X", "y − x"};

void witness_frames(LessonRun& run, int index) {
  using enum WitnessPart;
  const int last = last_step(run.lesson, run.runs[index].trace);
  if (last < 0) return run.frames.push_back({.run = index});
  for (const WitnessPart part : {p, on_y, on_x, distance})
    run.frames.push_back({.run = index, .step = last, .part = static_cast<int>(part)});
}

std::string witness_position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const auto part = witness_part(run, frame);
  const bool has_clock = run.lesson.path_of_shapes && run.lesson.path_of_shapes->seconds;
  if (!part || has_clock) return position_in_lesson(run, index);
  return fmt::format("{} · {}", position_on_path(run, index),
                     kWitnessParts[static_cast<std::size_t>(*part)]);
}

Tick witness_tick(const LessonRun& run, const Frame& frame) {
  using enum WitnessPart;
  const auto part = witness_part(run, frame);
  if (!part) return tick_of_step(run, frame);
  return {.group = group_of_position(run, frame, "answer"),
          .label = std::string(kWitnessParts[static_cast<std::size_t>(*part)]),
          .event = *part == distance};
}

void witness_knows(const Frame& frame, KnownFacts& facts) {
  facts.distance = facts.has_ended && frame.part == static_cast<int>(WitnessPart::distance);
}

int witness_answer(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const WitnessPart part =
      question.ask == asks::kClosestX.name ? WitnessPart::on_x : WitnessPart::on_y;
  return is_at(frame, question) && witness_part(run, frame) == part &&
                 has_closest(run, frame, question.ask)
             ? frame.step
             : -1;
}

}  // namespace

const Tour kWitness{
    .name = "witness",
    .meaning =
        "part of each answer: P, its weights on the vertices of Y, on those of X, "
        "the distance",
    .needs = {.takes_radius = true,
              .shown_of = ShownOf::both,
              .why_no_until = "frames show how the run ends"},
    .add_frames = witness_frames,
    .asks = asks::kOfAnswers,
    .answering_step = witness_answer,
    .algorithm = &kGjkAlgorithm,
    .knows = witness_knows,
    .position = witness_position,
    .tick = witness_tick,
    .words = captions::witness,
    .stage = layers::answer,
    .question = captions::closest_question,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<WitnessPart> witness_part(const LessonRun& run, const Frame& frame) {
  return part_of<WitnessPart>(tours::kWitness, run, frame);
}

}  // namespace gjkscope
