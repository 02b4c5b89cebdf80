#pragma once
// Files beside the frames of a lesson: the sidecar file, and the page that shows all frames.

#include <filesystem>
#include <string>
#include <vector>

#include "frames/frame.hpp"

namespace gjkscope {

struct ExportedFrame {
  int step = 1;      ///< From 1.
  std::string file;  ///< Name within the folder.
  FrameText text;
};

struct ExportedLesson {
  std::string id;
  std::string title;
  int chapter = 1;
  std::string source;
  std::string theme;
  int width = 0;
  int height = 0;
  int steps = 0;  ///< Steps of the lesson; `frames` may be some of them.
  std::vector<ExportedFrame> frames;
  std::vector<Rect> tiles;  ///< Chapters 1, 2, ... in the last frame of a map of the course.
};

/// `<lesson>.json`: the words and values of each frame, as JSON (docs/trace-format.md).
[[nodiscard]] std::string sidecar(const ExportedLesson& lesson);

/// `index.html`: one page that works offline from the folder of the frames. `page` is the template
/// (assets/contact-sheet.html).
[[nodiscard]] std::string contact_sheet(const std::vector<ExportedLesson>& lessons,
                                        const std::string& page);

}  // namespace gjkscope
