#pragma once
// The runs of a lesson or a case as text to read, made of their JSON.

#include <string>

#include "run/traced.hpp"

namespace gjkscope {

[[nodiscard]] std::string trace_text(const Traced& traced);

}  // namespace gjkscope
