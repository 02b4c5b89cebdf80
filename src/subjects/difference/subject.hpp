#pragma once
// How the Minkowski difference is built: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kPairs;
}  // namespace tours

namespace blocks {
extern const Block kPairs;
}  // namespace blocks

namespace listings {
extern const Listing kMinkowski;
}  // namespace listings

namespace layers {

extern const Layer kDifference;
extern const Layer kCornerNames;

/// How the difference is built, in both views.
void building(SceneBuilder& scene);

}  // namespace layers

namespace captions {

void pairs(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kMinkowskiCloud;
extern const EffectInfo kMinkowskiHull;
}  // namespace effect_infos

}  // namespace gjkscope
