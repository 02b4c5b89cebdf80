#pragma once
// What the frames of act `maps` show of a step (Frame::part).

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
  difference
};

}  // namespace gjkscope
