#pragma once
// Lesson + run + effects -> pictures: the layout of a frame, and the words that go with it.

#include <string>
#include <utility>
#include <vector>

#include "effects/graph.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

/// The words and numbers of a frame: what the sidecar file, the contact sheet and the alternative
/// text say.
struct FrameText {
  std::string caption;  ///< What happened and why, from this step's values.
  std::string detail;   ///< The numbers behind it, and what comes next.
  std::string prose;    ///< The lesson's prose, placeholders filled in.
  std::string phase;    ///< "closest", ..., or "start"
  int iteration = 0;    ///< From 1; 0 before the first.
  std::vector<std::pair<std::string, std::string>>
      values;  ///< Name and printed value, in reading order.
};

struct FramePicture {
  Picture picture;
  FrameText text;
};

/// All frames of a lesson. Labels keep their place from frame to frame, so frames are built in
/// order, together. `width` and `height` are at least 640 x 360.
[[nodiscard]] std::vector<FramePicture> lesson_pictures(const LessonRun& run, EffectGraph& effects,
                                                        const Fonts& fonts, double width,
                                                        double height);

}  // namespace gjkscope
