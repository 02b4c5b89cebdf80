#include "subjects/study/tour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/decimal.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/study/dot_words.hpp"
#include "subjects/study/subject.hpp"
#include "subjects/study/table.hpp"

namespace gjkscope::tours {
namespace {

constexpr std::array<AskInfo, 2> kStudyAsks = {
    {{"overlap", "whether the shapes overlap", "about mark"},
     {"time", "how much longer the next mark takes than the one before", "about mark"}}};

/// In the order of Frame::part.
std::vector<StudyFrame> study_frames_of(const Lesson& lesson) {
  using enum StudyStage;
  const int all_marks = static_cast<int>(lesson.settings.as<LessonStudy>()->marks.size());
  const int first = std::min(2, all_marks);
  std::vector<StudyFrame> frames;
  for (const StudyStage stage : {shapes, gap, in_float, in_double, error})
    frames.push_back({stage, 0});
  for (const StudyStage stage : {error_axis, time_axis}) frames.push_back({stage, first});
  for (int marks = first + 1; marks <= all_marks; ++marks) frames.push_back({mark, marks});
  for (const StudyStage stage : {front, all, choice}) frames.push_back({stage, all_marks});
  return frames;
}

void study_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[index].trace);
  const int count = static_cast<int>(study_frames_of(run.lesson).size());
  for (int i = 0; i < count; ++i) run.frames.push_back({.run = index, .step = last, .part = i});
}

int study_answer(const LessonRun& run, const Frame&, const Frame& frame,
                 const LessonQuestion& question) {
  using enum StudyStage;
  const auto [stage, marks] = *study_frame(run, frame);
  const bool answers = question.ask == kStudyAsks[0].name
                           ? stage == gap
                           : question.ask == kStudyAsks[1].name && stage == mark &&
                                 (!question.at || *question.at == marks);
  return answers ? frame.step : -1;
}

Tick study_tick(const LessonRun& run, const Frame& frame) {
  using enum StudyStage;
  const auto [stage, marks] = *study_frame(run, frame);
  Tick tick{.group = stage < error_axis ? "one pair"
                     : stage < front    ? "time and error"
                                        : "the front",
            .event = stage == error || stage == choice};
  constexpr std::array<std::string_view, 11> kLabels = {
      "shapes", "gap", "float",        "double", "error",       "errors",
      "times",  "",    "of the marks", "of all", "what to take"};
  tick.label = stage == mark ? run.lesson.settings.as<LessonStudy>()->marks[marks - 1].configuration
                             : std::string(kLabels[static_cast<std::size_t>(stage)]);
  return tick;
}

void study_values(const Story& story, FrameText& text) {
  using enum StudyStage;
  text.values.emplace_back("x", story.run.lesson.x().name);
  text.values.emplace_back("y", story.run.lesson.y().name);
  for (const StudyDot& dot : introduced(*story.run.lesson.settings.as<LessonStudy>(),
                                        study_frame(story.run, story.frame)->marks)) {
    text.values.emplace_back(dot.configuration,
                             fmt::format("{}, error {}", time_text(dot.ns), error_words(dot)));
  }
}

bool study_fill(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot) return false;
  layers::study(scene, fonts);
  return true;
}

std::string study_plot_title(const LessonRun& run) {
  return fmt::format("Pairs: {}", run.lesson.settings.as<LessonStudy>()->family);
}

}  // namespace

const Tour kStudy{
    .name = "study",
    .meaning =
        "of these: the pair X and Y, its gap, its answers in float and double, "
        "what an error is; the axis of errors, that of times, each mark of [study]; the "
        "front of the marks, that of all, what to take",
    .needs = {.settings = &LessonStudy::kKind,
              .path = PathUse::refused,
              .why_no_until = "frames show how the run ends"},
    .add_frames = study_frames,
    .asks = kStudyAsks,
    .answering_step = study_answer,
    .algorithm = &kGjkAlgorithm,
    .position = position_in_lesson,
    .tick = study_tick,
    .words = captions::study,
    .stage = layers::answer,
    .question = captions::study_question,
    .values = study_values,
    .fill = study_fill,
    .plot_title = study_plot_title,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<StudyFrame> study_frame(const LessonRun& run, const Frame& frame) {
  const auto index = part_of<std::size_t>(tours::kStudy, run, frame);
  return index ? std::optional(tours::study_frames_of(run.lesson)[*index]) : std::nullopt;
}

}  // namespace gjkscope
