#pragma once
// Axes and lines at round coordinates: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {
extern const Layer kGrid;
}  // namespace layers

namespace effect_infos {
extern const EffectInfo kGrid;
}  // namespace effect_infos

}  // namespace gjkscope
