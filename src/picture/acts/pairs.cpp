#include <fmt/format.h>

#include "picture/acts/acts.hpp"
#include "picture/layers/layers.hpp"

namespace gjkscope::acts {
namespace {

constexpr int kMostVertices = 8;

int pair_count(const LessonRun& run) {
  return static_cast<int>(run.lesson.x().vertices.size() * run.lesson.y().vertices.size());
}

void pairs_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[static_cast<std::size_t>(index)].trace);
  for (int i = 0; i <= pair_count(run) + 1; ++i)
    run.frames.push_back({.run = index, .step = last, .pairs = i});
}

std::string pairs_position(const LessonRun& run, int index) {
  const int count = static_cast<int>(run.frames.size());
  if (index == 0 || index + 1 == count) return position_in_lesson(run, index);
  return fmt::format("difference {} of {}", index, count - 2);
}

Tick pairs_tick(const LessonRun& run, const Frame& frame) {
  if (frame.pairs == 0) return {.group = "start"};
  if (frame.pairs > pair_count(run)) return {.group = "hull", .label = "Z", .event = true};
  const int per_x = static_cast<int>(run.lesson.y().vertices.size());
  const gjk::VertexPair pair{(*frame.pairs - 1) / per_x, (*frame.pairs - 1) % per_x};
  return {.group = fmt::format("{} − {}", run.lesson.y().name, run.lesson.x().vertex_names[pair.x]),
          .label = run.pair_name(pair)};
}

}  // namespace

const StagedAct kPairs{
    .act = {.name = "pairs",
            .meaning = "pair of vertices of Y and X, then the hull of their differences; at most 8 "
                       "vertices in each shape",
            .needs = {.most_vertices = kMostVertices},
            .add_frames = pairs_frames},
    .position = pairs_position,
    .tick = pairs_tick,
    .words = captions::pairs,
    .stage = layers::pair_under_construction,
};

}  // namespace gjkscope::acts
