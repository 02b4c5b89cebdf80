#pragma once
#include "lesson/algorithm.hpp"

namespace gjkscope {

/// GJK itself. Its trace is that of PositionedRun, from which its steps are told.
extern const Algorithm kGjkAlgorithm;

}  // namespace gjkscope
