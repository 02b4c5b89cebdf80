#pragma once
// Penetration depth as the algorithm of a lesson: run in the lesson's scalar, widened to double,
// and told as JSON and as text.

#include "depth/depth.hpp"
#include "exact/instances.hpp"
#include "lesson/algorithm.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// The trace of the expanding polygon after the end of a run; its `gjk` is not filled in.
using DepthTrace = depth::Trace<double>;

extern const Algorithm kDepthAlgorithm;

/// The trace of run `index`; nullptr where the lesson shows another algorithm.
[[nodiscard]] const DepthTrace* depth_trace(const LessonRun& run, int index);

/// How deep the shapes of a run lie in each other, from their vertices in the world.
[[nodiscard]] DepthTrace depth_of(const PositionedRun& run, const gjk::Options& options,
                                  ScalarKind scalar);

}  // namespace gjkscope
