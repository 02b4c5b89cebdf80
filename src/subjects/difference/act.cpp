#include "subjects/difference/act.hpp"

#include <fmt/format.h>

#include "subjects/difference/subject.hpp"

namespace gjkscope::acts {
namespace {

constexpr int kMostVertices = 8;

/// In the order of Frame::part.
std::vector<BuildFrame> build_frames(const Lesson& lesson) {
  using enum BuildPart;
  const int per_x = static_cast<int>(lesson.y().vertices.size());
  const int all = per_x * static_cast<int>(lesson.x().vertices.size());
  std::vector<BuildFrame> frames = {{start, 0}, {pair, 1}};
  for (int made = per_x; made <= all; made += per_x) frames.push_back({copy, made});
  for (const BuildPart part : {mirror, slide, hull, edges, any, shortest})
    frames.push_back({part, all});
  return frames;
}

void pairs_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[static_cast<std::size_t>(index)].trace);
  const int count = static_cast<int>(build_frames(run.lesson).size());
  for (int i = 0; i < count; ++i) run.frames.push_back({.run = index, .step = last, .part = i});
}

std::string pairs_position(const LessonRun& run, int index) {
  return position_in_lesson(run, index);
}

Tick pairs_tick(const LessonRun& run, const Frame& frame) {
  using enum BuildPart;
  const auto [part, made] = *build_frame(run, frame);
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
    .algorithm = &kGjkAlgorithm,
    .position = pairs_position,
    .tick = pairs_tick,
    .words = captions::pairs,
    .stage = layers::building,
};

}  // namespace gjkscope::acts

namespace gjkscope {

std::optional<BuildFrame> build_frame(const LessonRun& run, const Frame& frame) {
  const auto index = part_of<std::size_t>(acts::kPairs, run, frame);
  return index ? std::optional(acts::build_frames(run.lesson)[*index]) : std::nullopt;
}

}  // namespace gjkscope
