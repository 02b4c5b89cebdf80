#pragma once
// The answer: closest points of both shapes, counters, bounds: what the files of this folder
// define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kWitness;
extern const Tour kAnswer;
}  // namespace tours

namespace blocks {
extern const Block kWitness;
extern const Block kCounters;
extern const Block kStarts;
extern const Block kBoundSteps;
}  // namespace blocks

namespace layers {

/// P on its simplex, and the closest points that its weights
/// give.
void answer(SceneBuilder& scene);

}  // namespace layers

namespace captions {

void answer(const Story& story, FrameText& text);
void witness(const Story& story, FrameText& text);
/// Before a move: which way Z slides; whether Z holds s − t.
void slide_question(const Story& story, FrameText& text);
void holds_question(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kColdStart;
}  // namespace effect_infos

}  // namespace gjkscope
