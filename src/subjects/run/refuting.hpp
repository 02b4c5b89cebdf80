#pragma once
// Frames that answer a question and have its wrong choices to refute.

#include "run/run.hpp"

namespace gjkscope {

/// A frame with little room for other words: FrameQuestion::refuted ends its detail.
[[nodiscard]] bool refutes(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
