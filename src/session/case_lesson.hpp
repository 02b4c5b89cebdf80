#pragma once

#include <string>
#include <vector>

#include "lesson/case.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

/// A lesson about the shapes of a case that was read without problems and without outlines. It
/// shows them as `example` shows its own, and says what the case says of itself.
[[nodiscard]] Lesson case_lesson(Lesson example, const ReadCase& read, const std::string& name);

/// Why no lesson file could say a lesson about a case of `file`: problems at the case's place.
[[nodiscard]] std::vector<Problem> why_case_is_not_said(const Lesson& lesson, const ReadCase& read,
                                                        const std::string& file);

}  // namespace gjkscope
