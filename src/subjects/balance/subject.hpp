#pragma once
// Weights as masses on a beam: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kTime;
}  // namespace tours

namespace blocks {
extern const Block kBalance;
}  // namespace blocks

namespace layers {
extern const Layer kBalance;
}  // namespace layers

namespace captions {

void balance(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kBalance;
}  // namespace effect_infos

}  // namespace gjkscope
