#pragma once
// The side panel.

#include "effects/graph.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

/// The blocks that the lesson asks for, from top to bottom of `card`.
[[nodiscard]] std::vector<Mark> panel_marks(const LessonRun& run, EffectGraph& effects,
                                            const Frame& frame, const Fonts& fonts,
                                            const Rect& card);

}  // namespace gjkscope
