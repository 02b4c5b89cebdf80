#pragma once
// The layers of a stage: one family a file, drawn in the order of stage.cpp.

#include "picture/plot.hpp"
#include "picture/scene.hpp"

namespace gjkscope::layers {

// regions.cpp
/// Voronoi regions of the simplex under test, and their borders.
void regions(SceneBuilder& scene);

// shapes.cpp
void shapes(SceneBuilder& scene);
/// The ways of the shapes that move.
void path(SceneBuilder& scene);
/// Q in the world of a point query, O in the difference.
void query_point(SceneBuilder& scene);

// shape_hull.cpp
/// Hulls of shapes that are not convex.
void shape_hull(SceneBuilder& scene);

// difference.cpp
/// Cloud and hull of the differences.
void difference(SceneBuilder& scene);
/// Granularity "pairs": the pair that makes the newest difference, in both views.
void pair_under_construction(SceneBuilder& scene);

/// Names of the hull's corners, but for those that the run has named.
void corner_names(SceneBuilder& scene);

// parts.cpp
/// Lengths and areas in proportion to the barycentric coordinates.
void parts(SceneBuilder& scene);

// line.cpp
/// The line through a segment, and the point G of it that Q falls on.
void projection(SceneBuilder& scene);
void unit_vector(SceneBuilder& scene);

// balance.cpp
/// The beam below the segment whose weights are its masses.
void balance(SceneBuilder& scene);

// maps.cpp
/// The plane by the signs of u, v and w.
void signs(SceneBuilder& scene);
/// Where signs and Voronoi regions name different features.
void map_difference(SceneBuilder& scene);

// orders.cpp
/// The half-plane in which the short test that took an edge is true.
void short_test(SceneBuilder& scene);
/// The point that it took for P.
void wrong_point(SceneBuilder& scene);

// run.cpp
/// The support line that the lower bound comes from, where it is not that of the frame's search.
void best_support_line(SceneBuilder& scene);
/// Simplices and closest points of earlier iterations.
void history(SceneBuilder& scene);
void simplex(SceneBuilder& scene);
void closest_line(SceneBuilder& scene);
void closest_point(SceneBuilder& scene);
void witness_points(SceneBuilder& scene);
/// An arrow along d, and its name.
void search_arrow(SceneBuilder& scene, const Point& from, const Eigen::Vector2d& d, double length,
                  const std::string& text);
/// The search direction at P.
void search_direction(SceneBuilder& scene);
/// The line through a point, normal to d.
void support_line(SceneBuilder& scene, const Point& through, const Eigen::Vector2d& d,
                  const std::string& role = "support.plane");
/// Search direction, support line and support point.
void search(SceneBuilder& scene);
void search_between_shapes(SceneBuilder& scene);

// support.cpp
/// Granularity "support": d, the support point of Y, that of X, their difference, one after the
/// other.
void support_in_parts(SceneBuilder& scene);

// answer.cpp
/// Granularities "answer" and "witness": P on its simplex, and the closest points that its weights
/// give.
void answer(SceneBuilder& scene);

// motion.cpp
/// Where everything was a position ago.
void last_position(SceneBuilder& scene);
/// Y grown by X, and X as a point against it.
void grown_obstacle(SceneBuilder& scene);
/// The differences that the run has computed so far.
void touched_points(SceneBuilder& scene);
/// The widest strip proved empty between X and Y.
void slab(SceneBuilder& scene);

// second_run.cpp
/// Closest point, search direction, support line and support point of the second run.
void second_run(SceneBuilder& scene);

// growth.cpp
/// A view of growth: iterations and support calls against the number of vertices.
void growth(SceneBuilder& scene, const Fonts& fonts);
/// A run on polygons of the frame's size, in the difference; in a unit of length of its own.
void growth_example(SceneBuilder& scene);

// study.cpp
/// A view of the study: X and Y with their gap enlarged, or error against time.
void study(SceneBuilder& scene, const Fonts& fonts);

/// A plot that fills the view. (growth.cpp)
void add_plot(SceneBuilder& scene, const Plot& plot, const Fonts& fonts);

}  // namespace gjkscope::layers
