#pragma once
// Iterations against the number of vertices: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kGrowth;
}  // namespace tours

namespace blocks {

extern const Block kGrowth;

/// In place of the counters where a frame is about many runs.
void growth_counters(PanelBuilder& panel);

}  // namespace blocks

namespace layers {

/// A view of growth: iterations and support calls against the number of vertices.
void growth(SceneBuilder& scene, const Fonts& fonts);
/// A run on polygons of the frame's size, in the difference; in a unit of length of its own.
void growth_example(SceneBuilder& scene);

/// A plot that fills the view.
void add_plot(SceneBuilder& scene, const Plot& plot, const Fonts& fonts);

}  // namespace layers

namespace captions {

/// A size of polygons, or, after the last one, what all of them say.
void growth(const Story& story, FrameText& text);
void growth_question(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kGrowth;
extern const EffectInfo kSlowGrowth;
}  // namespace effect_infos

}  // namespace gjkscope
