#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// Shapes with a radius (LessonShape::radius): GJK asks about the hulls of the vertices, and both
/// radii are subtracted from its answer (Catto, Box2D 2.4.1, b2Distance with `useRadii`).
struct RoundShapes {
  static constexpr std::string_view kName = "round-shapes";
  static constexpr std::string_view kNeeds = "";
  /// Tells whether round shapes are apart, touch or overlap.
  enum class Meeting { apart, touching, overlapping };
  struct Value {
    double radii = 0.0;     ///< Both, added.
    double distance = 0.0;  ///< GJK's, less the radii: negative where the shapes overlap.
    Meeting meeting = Meeting::apart;
    Eigen::Vector3d x = Eigen::Vector3d::Zero();  ///< The point of X closest to Y; of shapes that
                                                  ///< overlap, the one that is deepest in Y.
    Eigen::Vector3d y = Eigen::Vector3d::Zero();  ///< The same of Y.
  };
  /// nullptr, and nothing is asked of the graph, where no shape has a radius.
  static const Value* of(EffectGraph& graph, const LessonRun& run, const Frame& frame) {
    const bool is_round = run.lesson.x().radius > 0.0 || run.lesson.y().radius > 0.0;
    return is_round ? &graph.get<RoundShapes>(frame) : nullptr;
  }
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
