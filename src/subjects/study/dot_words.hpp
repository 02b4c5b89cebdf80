#pragma once
// The outcome of the study of accuracy in words, for captions and panels alike.

#include <optional>
#include <string>
#include <vector>

#include "run/run.hpp"
#include "subjects/study/table.hpp"

namespace gjkscope {

/// "4·10⁻⁸"; "0", "none" (to some pair there was no answer).
[[nodiscard]] std::string error_words(const StudyDot& dot);

/// The dots of the lesson's first `count` marks.
[[nodiscard]] std::vector<StudyDot> introduced(const LessonStudy& study, int count);

/// A few words about a way to run GJK: for a mark, those of the lesson.
[[nodiscard]] std::string about(const LessonStudy& study, const StudyDot& dot);

/// Those of some dots that none of them beats, from fast to accurate.
[[nodiscard]] std::vector<StudyDot> front_among(std::vector<StudyDot> dots);

/// The fastest of `others` that is as fast and as accurate as a dot, or better; nothing when there
/// is none.
[[nodiscard]] std::optional<StudyDot> beaten_by(const StudyDot& dot,
                                                const std::vector<StudyDot>& others);

/// The fastest way to have what one may need.
struct Choice {
  std::string need;
  StudyDot dot;
};
/// For a growing number of right digits on every pair, and to know "overlap or not" with a
/// proof; needs that no way meets are left out. Of ways that take the same time the plainest.
[[nodiscard]] std::vector<Choice> choices(const std::vector<StudyDot>& family);

}  // namespace gjkscope
