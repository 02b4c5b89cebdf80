#pragma once
// A lesson's runs as JSON; docs/trace-format.md describes every key.

#include <string>

#include "lesson/run.hpp"

namespace gjkscope {

/// Counts up when a key changes its meaning or goes away; new keys do not count.
inline constexpr int kTraceFormatVersion = 2;

[[nodiscard]] std::string trace_json(const LessonRun& run);

}  // namespace gjkscope
