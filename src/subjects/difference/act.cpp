#include "subjects/difference/act.hpp"

#include <fmt/format.h>

#include "subjects/difference/subject.hpp"

namespace gjkscope::acts {
namespace {

constexpr int kMostVertices = 8;

void pairs_frames(LessonRun& run, int index) {
  using enum BuildPart;
  const int last = last_step(run.lesson, run.runs[static_cast<std::size_t>(index)].trace);
  const int per_x = static_cast<int>(run.lesson.y().vertices.size());
  const int all = per_x * static_cast<int>(run.lesson.x().vertices.size());
  int count = 0;
  const auto add = [&](BuildPart part, int made) {
    run.frames.push_back({.run = index, .step = last, .part = {BuildFrame{part, made}, count++}});
  };
  add(start, 0);
  add(pair, 1);
  for (int made = per_x; made <= all; made += per_x) add(copy, made);
  for (const BuildPart part : {mirror, slide, hull, edges, any, shortest}) add(part, all);
}

std::string pairs_position(const LessonRun& run, int index) {
  return position_in_lesson(run, index);
}

Tick pairs_tick(const LessonRun& run, const Frame& frame) {
  using enum BuildPart;
  const auto [part, made] = *frame.part.as<BuildFrame>();
  const std::string& x = run.lesson.x().name;
  const std::string& y = run.lesson.y().name;
  const int per_x = static_cast<int>(run.lesson.y().vertices.size());
  switch (part) {
    case start:
      return {.group = "start"};
    case pair:
      return {.group = "differences", .label = run.pair_name({0, 0})};
    case copy:
      return {.group = "differences",
              .label = fmt::format("{} − {}", y, run.lesson.x().vertex_names[(made - 1) / per_x])};
    case mirror:
      return {.group = fmt::format("{} + (−{})", y, x), .label = "−" + x};
    case slide:
      return {.group = fmt::format("{} + (−{})", y, x), .label = "at " + y};
    case hull:
      return {.group = "Z", .label = "hull", .event = true};
    case edges:
      return {.group = "Z", .label = "edges"};
    case any:
      return {.group = "distance", .label = "y − x"};
    case shortest:
      return {.group = "distance", .label = "shortest", .event = true};
  }
  return {};
}

}  // namespace

const Act kPairs{
    .name = "pairs",
    .meaning =
        "part of how Y − X is built: a first difference, Y less each vertex of X, "
        "−X at each vertex of Y, the hull, its edges, the shortest difference; at "
        "most 8 vertices in each shape",
    .needs = {.most_vertices = kMostVertices},
    .add_frames = pairs_frames,
    .position = pairs_position,
    .tick = pairs_tick,
    .words = captions::pairs,
    .stage = layers::building,
};

}  // namespace gjkscope::acts
