#pragma once
// Penetration depth as the algorithm of a lesson: run in the lesson's scalar, widened to double,
// and told as JSON and as text.

#include "exact/instances.hpp"
#include "lesson/algorithm.hpp"
#include "run/run.hpp"
#include "subjects/depth/depth.hpp"

// NOLINTBEGIN(bugprone-macro-parentheses): a type takes none.
/// The depth in the scalars of lessons, compiled once.
#define GJKSCOPE_DEPTH_INSTANCE(linkage, S)                                        \
  linkage template depth::Result<S> depth::penetration<S>(const gjk::Query<S, 2>&, \
                                                          const gjk::Options&);
// NOLINTEND(bugprone-macro-parentheses)
GJKSCOPE_DEPTH_INSTANCE(extern, Eigen::half)
GJKSCOPE_DEPTH_INSTANCE(extern, float)
GJKSCOPE_DEPTH_INSTANCE(extern, double)
GJKSCOPE_DEPTH_INSTANCE(extern, gjkscope::Rational)

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
