#pragma once
// The same run in other scalars: what the files of this folder define.

#include "picture/act.hpp"
#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace blocks {
extern const Block kScalars;
extern const Block kTwoRuns;
}  // namespace blocks

namespace layers {

/// Closest point, search direction, support line and support point of the second run.
void second_run(SceneBuilder& scene);

}  // namespace layers

namespace captions {

void second_run(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kEveryScalar;
extern const EffectInfo kSecondRun;
}  // namespace effect_infos

}  // namespace gjkscope
