#pragma once
// The slab that support points prove empty, and how much of Z was computed: declarations of the
// files of this folder.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace layers {

extern const Layer kTouchedPoints;
extern const Layer kSlab;
}  // namespace layers

namespace captions {

/// Adds how much of Z the run has computed.
void touched_points(const Story& story, FrameText& text);
/// Phases of a lesson that shows the slab between X and Y: what they prove.
void slab(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kBestSupport;
extern const EffectInfo kSlab;
extern const EffectInfo kTouchedPoints;
}  // namespace effect_infos

}  // namespace gjkscope
