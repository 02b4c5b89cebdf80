#pragma once
// Penetration depth as the algorithm of a lesson: run in the lesson's scalar, widened to double,
// and written as JSON and as text.

#include "depth/depth.hpp"
#include "exact/instances.hpp"
#include "lesson/algorithm.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// The trace of the expanding polygon after the end of a run, or of the expanding polytope in
/// space; its `gjk` is not filled in.
using DepthTrace = depth::Trace<double>;
using DepthTraceInSpace = depth::space::Trace<double>;
/// In the plane z = 0.
using DepthResult = depth::Result<double, 3>;

extern const Algorithm kDepthAlgorithm;

/// The trace of run `index`; nullptr where the lesson shows another algorithm, or has another
/// dimension.
[[nodiscard]] const DepthTrace* depth_trace(const LessonRun& run, int index);
[[nodiscard]] const DepthTraceInSpace* depth_trace_in_space(const LessonRun& run, int index);
/// Its result, in either dimension; nullptr where the lesson shows another algorithm.
[[nodiscard]] const DepthResult* depth_result(const LessonRun& run, int index);

/// How deep the shapes of a run lie in each other, from their vertices in the world.
[[nodiscard]] DepthResult depth_of(const PositionedRun& run, const gjk::Options& options,
                                   ScalarKind scalar);

/// "f3": faces count from those of the first polytope on; what was outgrown before has no name.
[[nodiscard]] std::string face_name(const DepthTraceInSpace& trace, int face);

}  // namespace gjkscope
