#pragma once
// Shapes along a path: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {
extern const Layer kLastPosition;
extern const Layer kGrownObstacle;
extern const Layer kPath;
}  // namespace layers

namespace effect_infos {
extern const EffectInfo kLastPosition;
extern const EffectInfo kGrownObstacle;
}  // namespace effect_infos

}  // namespace gjkscope
