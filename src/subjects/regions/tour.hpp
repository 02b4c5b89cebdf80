#pragma once
// The parts of a step that frames of the tours `maps` and `orders` show.

#include <optional>

#include "run/run.hpp"

namespace gjkscope {

/// Maps of a triangle's plane.
enum class MapStage {
  voronoi,
  interior,
  negative_u,
  negative_v,
  negative_w,
  signs,
  blended,
  difference,
  asked  ///< A question: both maps, and Q at a new place.
};
[[nodiscard]] std::optional<MapStage> map_stage(const LessonRun& run, const Frame& frame);

/// A triangle's numbers, then one chain of region tests each. Short tests leave out that an edge's
/// own coordinates must be positive.
enum class OrderStage { numbers, vertices_first_short, edges_first_short, edges_first_whole };
[[nodiscard]] std::optional<OrderStage> order_stage(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
