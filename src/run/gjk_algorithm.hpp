#pragma once
#include "lesson/algorithm.hpp"

namespace gjkscope {

/// GJK itself. Its trace is that of PositionedRun.
extern const Algorithm kGjkAlgorithm;

}  // namespace gjkscope
