#pragma once
// A run at a glance: a small picture for each iteration, and both bounds against iterations.

#include "picture/scene.hpp"

namespace gjkscope {

/// Whether it is this view of the lesson that has the small pictures, and not the plot alone: the
/// first that shows Z, or else the last.
[[nodiscard]] bool has_cells(const LessonRun& run, std::size_t view);

/// The marks of a frame that is a trail (run/trail.hpp) in `area` of a view, in frame pixels: the
/// first view that shows Z, or else the last, has a cell for each of frames_of_trail, in which the
/// view's `camera` is moved to fit Z; the others have the plot, for which a single view keeps room.
[[nodiscard]] Scene trail_scene(const LessonRun& run, EffectGraph& effects, std::size_t view,
                                const Camera& camera, const Rect& area, const Fonts& fonts);

}  // namespace gjkscope
