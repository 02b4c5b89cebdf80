#pragma once
// A lesson's runs as text to read.

#include <string>

#include "lesson/run.hpp"

namespace gjkscope {

[[nodiscard]] std::string trace_text(const LessonRun& run);

}  // namespace gjkscope
