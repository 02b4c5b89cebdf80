#pragma once
// Shapes with a radius: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {

extern const Layer kSkins;
extern const Layer kRadii;
extern const Layer kGap;

/// In the world, once the run has ended: shapes with a radius are apart, so that the length to name
/// is that of the way between them, not between their polygons.
[[nodiscard]] bool shows_gap(const SceneBuilder& scene);

}  // namespace layers

namespace captions {

void round_shapes(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kRoundShapes;
}  // namespace effect_infos

}  // namespace gjkscope
