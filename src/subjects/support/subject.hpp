#pragma once
// The support point, in parts; the slab that it proves: what the files of this folder define.

#include "picture/act.hpp"
#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

/// Parts of one support step: d, the support point of Y along d, that of X along -d, their
/// difference.
enum class SupportPart { direction, of_y, of_x, of_z };
[[nodiscard]] std::optional<SupportPart> support_part(const LessonRun& run, const Frame& frame);

namespace acts {
extern const Act kSupport;
}  // namespace acts

namespace layers {

extern const Layer kTouchedPoints;
extern const Layer kSlab;

/// d, the support point of Y, that of X, their difference, one after the other.
void support_in_parts(SceneBuilder& scene);

}  // namespace layers

namespace captions {

void support_in_parts(const Story& story, FrameText& text);
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
