#pragma once

#include <string>

#include "lesson/case.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

/// A lesson about the shapes of a case that was read without problems and without outlines. It
/// shows them as `example` shows its own, and says what the case says of itself.
[[nodiscard]] Lesson case_lesson(Lesson example, const ReadCase& read, const std::string& name);

}  // namespace gjkscope
