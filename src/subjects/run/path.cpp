#include <algorithm>

#include "subjects/run/subject.hpp"

namespace gjkscope::acts {
namespace {

void path_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[static_cast<std::size_t>(index)].trace);
  // A refused run has no step: its frame shows the start.
  run.frames.push_back({.run = index, .step = run.lesson.until ? last : std::min(0, last)});
}

Tick path_tick(const LessonRun& run, const Frame& frame) {
  const gjk::Face face = run.state(frame).region;
  if (gjk::vertex_count(face) == 3) return {.group = "interior"};
  return {.group = "region " + SimplexWords(run, run.state(frame).simplex).face(face)};
}

}  // namespace

const Act kPath{
    .name = "path",
    .meaning = "position of X on the path",
    .needs = {.path = PathUse::needed},
    .add_frames = path_frames,
    .sweeps = true,
    .algorithm = &kGjkAlgorithm,
    .position = position_on_path,
    .tick = path_tick,
    .words = captions::step,
    .stage = layers::stage_step,
};

}  // namespace gjkscope::acts
