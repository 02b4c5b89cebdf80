#pragma once
// Barycentric coordinates: lengths, areas, the linear system: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace blocks {
extern const Block kWeights;
extern const Block kLinearSystem;
extern const Block kUnitVector;
extern const Block kAreas;
}  // namespace blocks

namespace layers {
extern const Layer kProjection;
extern const Layer kUnitVector;
extern const Layer kParts;

/// Whether P and its line are drawn. They would cover weights that are measured along a path.
[[nodiscard]] bool shows_closest_point(const SceneBuilder& scene);

}  // namespace layers

namespace captions {

/// u and v as fractional lengths, from G and from Q.
void line(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kBarycentricWeights;
extern const EffectInfo kBarycentricParts;
extern const EffectInfo kProjection;
extern const EffectInfo kUnitVector;
}  // namespace effect_infos

}  // namespace gjkscope
