#pragma once
// The cost of accuracy: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kStudy;
}  // namespace tours

namespace blocks {
extern const Block kStudy;
}  // namespace blocks

namespace layers {

/// A view of the study: X and Y with their gap enlarged, or error against time.
void study(SceneBuilder& scene, const Fonts& fonts);

}  // namespace layers

namespace captions {

void study(const Story& story, FrameText& text);
/// The question of a frame of the study.
void study_question(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kRoundedPair;
}  // namespace effect_infos

}  // namespace gjkscope
