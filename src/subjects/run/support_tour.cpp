#include <fmt/format.h>

#include <array>

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

void support_frames(LessonRun& run, int index) {
  using enum SupportPart;
  const WideTrace& trace = run.runs[index].trace;
  const int last = last_step(run.lesson, trace);
  const std::size_t before = run.frames.size();
  for (int i = 0; i <= last; ++i) {
    if (trace.steps[i].phase != gjk::Phase::support) continue;
    for (const SupportPart part : {direction, of_y, of_x, of_z})
      run.frames.push_back({.run = index, .step = i, .part = static_cast<int>(part)});
  }
  // A run that needs no support point shows how it ends.
  if (run.frames.size() == before) run.frames.push_back({.run = index, .step = last});
}

std::string support_position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const auto part = support_part(run, frame);
  if (!part) return position_in_lesson(run, index);
  constexpr std::array<std::string_view, 4> kParts = {"direction", "support of Y", "support of X",
                                                      "support of Z"};
  return fmt::format("iteration {} of {} · {}", run.step(frame).iteration,
                     run.run(frame).trace.result.iterations,
                     kParts[static_cast<std::size_t>(*part)]);
}

Tick support_tick(const LessonRun& run, const Frame& frame) {
  using enum SupportPart;
  const auto shown = support_part(run, frame);
  if (!shown) return tick_of_step(run, frame);
  constexpr std::array<std::string_view, 4> kParts = {"d", "Y along d", "X along −d", "Z"};
  const auto part = static_cast<std::size_t>(*shown);
  return {.group = fmt::format("iteration {}", run.step(frame).iteration),
          .label = std::string(kParts[part]),
          .short_label = std::string(1, "dYXZ"[part]),
          .event = *shown == of_z};
}

void support_words(const Story& story, FrameText& text) {
  return support_part(story.run, story.frame) ? captions::support_in_parts(story, text)
                                              : captions::step(story, text);
}

void support_stage(SceneBuilder& scene) {
  return support_part(scene.run, scene.frame) ? layers::support_in_parts(scene)
                                              : layers::stage_step(scene);
}

void support_knows(const Frame& frame, KnownFacts& facts) {
  facts.whole_support = frame.part == static_cast<int>(SupportPart::of_z);
  facts.steps = facts.whole_support ? frame.step + 1 : frame.step;
}

constexpr std::array kSupportAsks = {asks::kSupport};

/// Asked where d is known, and answered by the support points of Y and X.
int support_answer(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const auto part = support_part(run, frame);
  const bool answers = question.ask == asks::kSupport.name && part && *part == SupportPart::of_y &&
                       (!question.at || *question.at == run.step(frame).iteration);
  return answers ? frame.step : -1;
}

}  // namespace

const Tour kSupport{
    .name = "support",
    .meaning =
        "part of each support step: the direction, the support point of Y, that of "
        "X, their difference",
    .add_frames = support_frames,
    .asks = kSupportAsks,
    .answering_step = support_answer,
    .algorithm = &kGjkAlgorithm,
    .knows = support_knows,
    .position = support_position,
    .tick = support_tick,
    .words = support_words,
    .stage = support_stage,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<SupportPart> support_part(const LessonRun& run, const Frame& frame) {
  return part_of<SupportPart>(tours::kSupport, run, frame);
}

}  // namespace gjkscope
