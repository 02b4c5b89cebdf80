#pragma once
// The runs of a lesson or a case as text to read.

#include <string>

#include "run/traced.hpp"

namespace gjkscope {

/// D: 2 or 3.
template <int D>
[[nodiscard]] std::string trace_text(const Traced<D>& traced);

}  // namespace gjkscope
