#pragma once
// The words of a frame, generated from the values of its step.

#include "frames/frame.hpp"

namespace gjkscope {

/// Caption, detail, filled-in prose and values of one frame. Pulls the effects that the words tell
/// of.
[[nodiscard]] FrameText frame_text(const LessonRun& run, EffectGraph& effects, const Frame& frame);

}  // namespace gjkscope
