#pragma once
// Times of a study as lessons tell them: by the ratios that were measured within turns.

#include "lesson/study_results.hpp"

namespace gjkscope {

/// The same with times as the ratios to the default have them, and the front of those. A ratio is
/// taken within a turn, so what disturbs the machine weighs less on it than on a median of times.
[[nodiscard]] std::vector<StudyDot> timed_by_ratio(std::vector<StudyDot> dots);

/// The configuration of a family that ratios refer to; null where the file does not have it.
[[nodiscard]] const StudyDot* default_of(const std::vector<StudyDot>& dots,
                                         std::string_view family);

}  // namespace gjkscope
