#pragma once
// The side panel and the timeline.

#include "effects/graph.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

/// The blocks that the lesson asks for, from top to bottom of `card`.
[[nodiscard]] std::vector<Mark> panel_marks(const LessonRun& run, EffectGraph& effects,
                                            const Frame& frame, const Fonts& fonts,
                                            const Rect& card);

/// All frames of the lesson as ticks, grouped, the current one marked.
[[nodiscard]] std::vector<Mark> timeline_marks(const LessonRun& run, int current,
                                               const Fonts& fonts, const Rect& area);

}  // namespace gjkscope
