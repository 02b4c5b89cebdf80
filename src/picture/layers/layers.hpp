#pragma once
// What a stage is drawn of. A layer is a value, defined in one of the files here and listed in
// list.def. It lies below or above what the act draws; the functions here are what acts draw with.

#include <string>
#include <string_view>

#include "picture/plot.hpp"
#include "picture/scene.hpp"

namespace gjkscope {

struct Layer {
  enum class On { every_view, world, difference };
  std::string_view effect = {};  ///< Drawn where a view calls for it; empty: always.
  On on = On::every_view;
  int order = 0;  ///< Those with lower numbers lie below; the act's own marks have kOfAct.
  void (*draw)(SceneBuilder& scene) = nullptr;
  /// In frames with equal keys a view's layer is the same, and is drawn once; null: in each frame.
  EffectKey (*key)(const SceneBuilder& scene) = nullptr;

  static constexpr int kOfAct = 500;
};

namespace layers {

#define GJKSCOPE_LAYER(name) extern const Layer k##name;
#include "picture/layers/list.def"
#undef GJKSCOPE_LAYER

// shapes.cpp
/// The name of a vertex, of X, Y or the difference, that the frame leaves without one; a disk where
/// it has none, too.
void vertex_name(SceneBuilder& scene, const Subject& vertex, bool has_mark);

// difference.cpp
/// How the difference is built, in both views.
void building(SceneBuilder& scene);

// issues.cpp
/// The step, with the whole triangle where it holds Q, and d where that is the question.
void issue(SceneBuilder& scene);

// run.cpp
/// The support line that the lower bound comes from, where it is not that of the frame's search.
void best_support_line(SceneBuilder& scene);
/// Simplices of earlier iterations, below that of the frame; their closest points, above it.
void history(SceneBuilder& scene);
void history_points(SceneBuilder& scene);
void simplex(SceneBuilder& scene);
void closest_line(SceneBuilder& scene);
/// A length beside the line that it is the length of; none within a pixel.
void length_label(SceneBuilder& scene, const std::string& id, double length, const Point& from,
                  const Point& to);
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

// measured.cpp
/// Ticks along a line, on the side `towards`, a direction.
void ticks(SceneBuilder& scene, const std::string& role, const Point& a, const Point& b,
           const Point& towards);

// support.cpp
/// d, the support point of Y, that of X, their difference, one after the other.
void support_in_parts(SceneBuilder& scene);

// answer.cpp
/// P on its simplex, and the closest points that its weights
/// give.
void answer(SceneBuilder& scene);

// round_shapes.cpp
/// In the world, once the run has ended: shapes with a radius are apart, so that the length to name
/// is that of the way between them, not between their polygons.
[[nodiscard]] bool shows_gap(const SceneBuilder& scene);

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

}  // namespace layers
}  // namespace gjkscope
