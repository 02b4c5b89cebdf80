#pragma once
// A view of space beside its shapes: their hulls, regions, a floor with shadows, and axes.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {
extern const Layer kFloor;
extern const Layer kTriad;
extern const Layer kDropLine;
extern const Layer kRegionSolid;
extern const Layer kFacesBefore;
}  // namespace layers

namespace blocks {
extern const Block kFaces;
}  // namespace blocks

namespace effect_infos {
extern const EffectInfo kDifferenceSolid;
extern const EffectInfo kShapeSolids;
extern const EffectInfo kRegionSolid;
extern const EffectInfo kFacesBefore;
}  // namespace effect_infos

}  // namespace gjkscope
