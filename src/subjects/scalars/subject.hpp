#pragma once
// The same run in other scalars: what the files of this folder define.

#include "picture/block.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace blocks {
extern const Block kScalars;
}  // namespace blocks

namespace effect_infos {
extern const EffectInfo kEveryScalar;
}  // namespace effect_infos

}  // namespace gjkscope
