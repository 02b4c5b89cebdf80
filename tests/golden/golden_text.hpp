#pragma once
// Runs and pictures as text to keep: one line a fact, so that a difference is a line, and the line
// says where.

#include <string>

#include "picture/picture.hpp"
#include "run/run.hpp"

namespace gjkscope::golden {

/// The lesson's first run as `gjkscope trace` prints it, and one line for each run after it. Where
/// another algorithm takes more than 40 iterations, those after the first 20 are left out.
[[nodiscard]] std::string trace(const LessonRun& run);

/// One line: the number of frames, and CRC-32s of the lesson's traces as JSON, where each number
/// has its bits, and of all words of its frames.
[[nodiscard]] std::string checksums(const LessonRun& run);

/// One line a mark, in painting order: role, shape, coordinates to a tenth of a frame pixel.
[[nodiscard]] std::string marks(const Picture& picture);

/// Such lines without what depends on the release of a font: the places of texts and of the boxes,
/// leaders and charts that leave room for them, where lines of prose break, and the timeline, whose
/// segments and labels are as wide as their words allow.
[[nodiscard]] std::string without_places_of_words(const std::string& marks);

/// The first line in which two texts differ.
struct Difference {
  std::string where;  ///< "iteration 2, support"; of a list of marks "line 12".
  std::string expected;
  std::string got;
};
/// Empty `where`: there is none.
[[nodiscard]] Difference first_difference(const std::string& expected, const std::string& got);

}  // namespace gjkscope::golden
