#pragma once
// The walk on features (outlines/lin_canny.hpp) as the algorithm of a lesson: on the vertices of
// two polygons as a run places them, and as JSON and text.

#include <optional>

#include "lesson/algorithm.hpp"
#include "outlines/lin_canny.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// The trace of the walk with the polygons of one run.
struct TracedWalk {
  std::optional<models::WalkQuery> query;  ///< A is X, B is Y; none where they are refused.
  models::WalkTrace trace;
  std::optional<models::Answer> truth;  ///< For a walk that is stuck in a local minimum.
};

extern const Algorithm kLinCannyAlgorithm;

/// The walk of run `index`; nullptr where the lesson shows another algorithm.
[[nodiscard]] const TracedWalk* walk_trace(const LessonRun& run, int index);

/// "vertex C of X", "edge KL of Y"
[[nodiscard]] std::string feature_name(const Lesson& lesson, const models::WalkQuery& query,
                                       bool of_x, const models::RingFeature& feature);
/// "regions"
[[nodiscard]] std::string_view name_of(models::WalkPhase phase);
/// "local-minimum"
[[nodiscard]] std::string_view name_of(models::WalkStop stop);

}  // namespace gjkscope
