#include "run/trail.hpp"

#include <utility>

namespace gjkscope {

void add_trail(LessonRun& run) {
  const WideTrace& trace = run.runs.front().trace;
  const int last = static_cast<int>(trace.steps.size()) - 1;
  // Questions come before the frame that answers them, which is none of these.
  const bool is_whole = last >= 0 && run.frames.back().step == last;
  if (run.runs.size() == 1 && !run.lesson.until && is_whole && trace.steps.back().iteration > 1)
    run.frames.push_back({.step = last, .part = kTrail});
}

std::vector<Frame> frames_of_trail(const LessonRun& run) {
  const auto& steps = run.runs.front().trace.steps;
  std::vector<Frame> frames;
  int iteration = 0;
  for (int i = 0; i < static_cast<int>(steps.size()); ++i) {
    const WideStep& step = steps[i];
    if (std::exchange(iteration, step.iteration) != step.iteration) frames.push_back({.step = i});
    if (step.phase <= gjk::Phase::support) frames.back().step = i;
  }
  frames.back().step = static_cast<int>(steps.size()) - 1;
  if (frames.size() > kMostInTrail)
    frames.erase(frames.begin() + kMostInTrail - 1, frames.end() - 1);
  return frames;
}

int answering_index(const LessonRun& run) {
  const int last = static_cast<int>(run.frames.size()) - 1;
  return is_trail(run.frames.back()) ? last - 1 : last;
}

}  // namespace gjkscope
