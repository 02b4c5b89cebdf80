#pragma once
// Vertices inside of the hull of a shape: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {
extern const Layer kShapeHull;
}  // namespace layers

namespace captions {

void shape_hull(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kShapeHull;
}  // namespace effect_infos

}  // namespace gjkscope
