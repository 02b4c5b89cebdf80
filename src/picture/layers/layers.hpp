#pragma once
// The layers of a stage: one family a file, drawn in the order of stage.cpp.

#include "picture/scene.hpp"

namespace gjkscope::layers {

// regions.cpp
/// Voronoi regions of the simplex under test, and their borders.
void regions(SceneBuilder& scene);

// shapes.cpp
void shapes(SceneBuilder& scene);
/// The positions of X.
void path(SceneBuilder& scene);
/// Q in the world of a point query, O in the difference.
void query_point(SceneBuilder& scene);

// difference.cpp
/// Cloud and hull of the differences.
void difference(SceneBuilder& scene);
/// Granularity "pairs": the pair that makes the newest difference, in both views.
void pair_under_construction(SceneBuilder& scene);

// parts.cpp
/// Lengths and areas in proportion to the barycentric coordinates.
void parts(SceneBuilder& scene);

// run.cpp
/// Simplices and closest points of earlier iterations.
void history(SceneBuilder& scene);
void simplex(SceneBuilder& scene);
void closest_line(SceneBuilder& scene);
void closest_point(SceneBuilder& scene);
void witness_points(SceneBuilder& scene);
/// Search direction, support line and support point.
void search(SceneBuilder& scene);
void search_between_shapes(SceneBuilder& scene);

}  // namespace gjkscope::layers
