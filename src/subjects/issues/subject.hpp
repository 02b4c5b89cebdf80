#pragma once
// Numerical issues, by the place of Q: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kIssues;
}  // namespace tours

namespace blocks {
extern const Block kIssuesOfPlaces;
}  // namespace blocks

namespace layers {

extern const Layer kEarlierPlaces;

/// The step, with the whole triangle where it holds Q, and d where that is the question.
void issue(SceneBuilder& scene);

}  // namespace layers

namespace captions {

/// Says what could go wrong at the place of Q.
void issue(const Story& story, FrameText& text);
/// Says what GJK does about it.
void issue_solved(const Story& story, FrameText& text);
void issue_question(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kNumericalIssue;
}  // namespace effect_infos

}  // namespace gjkscope
