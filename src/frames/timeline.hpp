#pragma once
// The timeline below the caption.

#include "picture/picture.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// All frames of the lesson as ticks, grouped, the current one marked.
[[nodiscard]] std::vector<Mark> timeline_marks(const LessonRun& run, int current,
                                               const Fonts& fonts, const Rect& area);

}  // namespace gjkscope
