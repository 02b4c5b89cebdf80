#include <array>

#include "subjects/regions/act.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::acts {
namespace {

void maps_frames(LessonRun& run, int index) {
  using enum MapStage;
  if (run.runs[static_cast<std::size_t>(index)].trace.steps.empty()) return;
  for (const MapStage stage :
       {voronoi, interior, negative_u, negative_v, negative_w, signs, blended, difference}) {
    // The maps are the same wherever X stands.
    if (index == 0 || stage == difference)
      run.frames.push_back({.run = index, .step = 0, .part = static_cast<int>(stage)});
  }
}

Tick maps_tick(const LessonRun& run, const Frame& frame) {
  constexpr std::array<std::string_view, 8> kLabels = {
      "Voronoi", "interior", "u < 0", "v < 0", "w < 0", "signs", "both", "difference"};
  return {.group = frame.run == 0 ? "maps" : group_of_position(run, frame, ""),
          .label = std::string(kLabels[static_cast<std::size_t>(*map_stage(run, frame))])};
}

}  // namespace

const Act kMaps{
    .name = "maps",
    .meaning =
        "map of the plane around a triangle: Voronoi regions, signs of u, v, w, both, and "
        "where they disagree; the last one for further positions of X",
    .needs = {.start = 3, .why_no_until = "frames go through the first region tests"},
    .add_frames = maps_frames,
    .algorithm = &kGjkAlgorithm,
    .position = position_in_lesson,
    .tick = maps_tick,
    .words = captions::maps,
    .stage = layers::stage_step,
};

}  // namespace gjkscope::acts

namespace gjkscope {

std::optional<MapStage> map_stage(const LessonRun& run, const Frame& frame) {
  return part_of<MapStage>(acts::kMaps, run, frame);
}

}  // namespace gjkscope
