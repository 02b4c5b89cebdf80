#pragma once
// A stage: one view of a lesson (the world, or the Minkowski difference) drawn into a rectangle of
// the frame.

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "picture/scene.hpp"

namespace gjkscope {

/// The camera of a view: the lesson's, or one that fits everything the view will show over all
/// frames.
[[nodiscard]] Camera camera_of(const LessonRun& run, const LessonView& view, const Rect& area);

struct Layer;
/// Scenes that layers of a view have drawn and that are the same in many of its frames.
using StillLayers = std::map<std::pair<const Layer*, EffectKey>, Scene>;

/// `drawn` is that of the view, seen by this `map`.
[[nodiscard]] Scene stage_scene(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                                const LessonView& view, const StageMap& map, const Fonts& fonts,
                                StillLayers& drawn);

}  // namespace gjkscope
