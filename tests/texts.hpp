#pragma once
// The words of a lesson's frames.

#include <vector>

#include "frames/frame.hpp"
#include "run/graph.hpp"

namespace gjkscope::testing {

inline std::vector<FrameText> texts_of(const LessonRun& run) {
  EffectGraph effects(run);
  return lesson_texts(run, effects);
}

}  // namespace gjkscope::testing
