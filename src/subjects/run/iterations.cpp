#include "run/questions.hpp"
#include "run/trail.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/table.hpp"

namespace gjkscope::tours {
namespace {

bool ends_iteration(const LessonRun& run, int index, int step) {
  const WideTrace& trace = run.runs[index].trace;
  return step == last_step(run.lesson, trace) ||
         trace.steps[step + 1].iteration != trace.steps[step].iteration;
}

void iteration_frames(LessonRun& run, int index) {
  add_step_frames(run, index, ends_iteration);
  add_trail(run);
}

}  // namespace

const Tour kIteration{
    .name = "iteration",
    .meaning = "iteration of the run",
    .needs = {.settings = &LessonSecond::kKind,
              .settings_are_optional = true,
              .takes_radius = true,
              .shown_of = ShownOf::both},
    .add_frames = iteration_frames,
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
