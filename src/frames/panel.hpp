#pragma once
// The side panel.

#include "picture/picture.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Its width beside one view and beside two, in frame pixels: blocks have room in either.
inline constexpr double kWidePanel = 440.0;
inline constexpr double kNarrowPanel = 400.0;

/// The blocks that the lesson asks for, from top to bottom of `card`.
[[nodiscard]] std::vector<Mark> panel_marks(const LessonRun& run, EffectGraph& effects,
                                            const Frame& frame, const Fonts& fonts,
                                            const Rect& card);

}  // namespace gjkscope
