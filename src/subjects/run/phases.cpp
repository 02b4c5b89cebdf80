#include <algorithm>

#include "run/questions.hpp"
#include "run/trail.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/table.hpp"

namespace gjkscope::tours {
namespace {

bool is_chosen(const LessonRun& run, int index, int step) {
  const std::vector<gjk::Phase>& phases = run.lesson.phases;
  const auto& steps = run.runs[index].trace.steps;
  const gjk::Phase phase = steps[step].phase;
  // A drop phase that drops nothing has nothing to show.
  if (phase == gjk::Phase::drop && phases.empty() && step + 1 < static_cast<int>(steps.size()) &&
      steps[step].record.dropped.empty())
    return false;
  return phases.empty() || std::find(phases.begin(), phases.end(), phase) != phases.end();
}

void phase_frames(LessonRun& run, int index) {
  add_step_frames(run, index, is_chosen);
  add_trail(run);
}

}  // namespace

const Tour kPhase{
    .name = "phase",
    .meaning =
        "phase of each iteration: closest point, drop, direction, support, stop "
        "tests, add",
    .needs = {.settings = &LessonSecond::kKind,
              .settings_are_optional = true,
              .takes_phases = true,
              .takes_radius = true,
              .shown_of = ShownOf::both},
    .add_frames = phase_frames,
    .follows_run = true,
    .asks = asks::kOfSteps,
    .answering_step = answering_step_of_run,
    .algorithm = &kGjkAlgorithm,
    .position = position_in_run,
    .tick = tick_of_step,
    .words = captions::step,
    .stage = layers::stage_step,
};

}  // namespace gjkscope::tours
