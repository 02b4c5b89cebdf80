#pragma once
// The last frame of a run that is shown step by step: the whole run at a glance.

#include <vector>

#include "run/run.hpp"

namespace gjkscope {

/// Frame::part of the frame that shows a run at a glance; its step is the last.
inline constexpr int kTrail = -2;
[[nodiscard]] inline bool is_trail(const Frame& frame) { return frame.part == kTrail; }

/// Appends that frame to the frames of a single run of at least two iterations that are shown to
/// their end. All other runs have none.
void add_trail(LessonRun& run);

/// The most iterations that have a small picture each.
inline constexpr std::size_t kMostInTrail = 8;
/// One frame for each iteration of the first run, which GJK has not refused: the step that has S,
/// P, d and the support point; of the last iteration the last step. Where there are more than
/// kMostInTrail, the first ones and the last.
[[nodiscard]] std::vector<Frame> frames_of_trail(const LessonRun& run);

/// Index of the last frame that shows one step: the answer.
[[nodiscard]] int answering_index(const LessonRun& run);

}  // namespace gjkscope
