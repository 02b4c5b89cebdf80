#pragma once
// Lengths that GJK compares, drawn: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {

extern const Layer kSupportAxis;
extern const Layer kClosestCircle;
extern const Layer kTestedFeet;

/// Ticks along a line, on the side `towards`, a direction.
void ticks(SceneBuilder& scene, const std::string& role, const Point& a, const Point& b,
           const Point& towards);

}  // namespace layers

namespace effect_infos {
extern const EffectInfo kSupportAxis;
extern const EffectInfo kClosestCircle;
extern const EffectInfo kTestedFeet;
}  // namespace effect_infos

}  // namespace gjkscope
