#pragma once
// A second run about the lesson's shapes: what the files of this folder define.

#include <array>
#include <string>

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace blocks {
extern const Block kTwoRuns;

/// A run, and its state at the frame.
struct RunColumn {
  std::string title;
  const PositionedRun& run;
  const WideState* state;  ///< Null where the run has no step beside the frame's.
  Numbers numbers;
};
/// The numbers of two runs that the panel's frame knows, and where they differ by more than this
/// share.
void two_columns(PanelBuilder& panel, const std::array<RunColumn, 2>& columns, double share = 0.0);
}  // namespace blocks

namespace layers {

/// Closest point, search direction, support line and support point of the second run.
void second_run(SceneBuilder& scene);

}  // namespace layers

namespace captions {

void second_run(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kSecondRun;
}  // namespace effect_infos

}  // namespace gjkscope
