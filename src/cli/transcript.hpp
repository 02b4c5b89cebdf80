#pragma once
// A lesson in words, for who cannot see its frames, or wants to read them in one go.

#include <string>

#include "run/run.hpp"

namespace gjkscope {

/// Title, chapter, source and prose, then for each frame its number, its place and its words: those
/// of its alternative text. A frame whose prose differs from that of the last repeats it. Each
/// paragraph is one line.
[[nodiscard]] std::string transcript(const LessonRun& run, bool markdown);

}  // namespace gjkscope
