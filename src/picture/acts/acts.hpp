#pragma once
// The acts there are.

#include "picture/act.hpp"

namespace gjkscope::acts {

#define GJKSCOPE_ACT(name) extern const StagedAct k##name;
#include "picture/acts/list.def"
#undef GJKSCOPE_ACT

}  // namespace gjkscope::acts
