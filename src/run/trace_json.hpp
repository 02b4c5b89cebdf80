#pragma once
// The runs of a lesson or a case as JSON; docs/trace-format.md describes every key.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "run/traced.hpp"

namespace gjkscope {

/// Counts up when a key changes its meaning or goes away; new keys do not count.
inline constexpr int kTraceFormatVersion = 3;

[[nodiscard]] nlohmann::ordered_json trace_document(const Traced& traced);
[[nodiscard]] std::string trace_json(const Traced& traced);

}  // namespace gjkscope
