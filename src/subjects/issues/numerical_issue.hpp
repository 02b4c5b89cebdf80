#pragma once
#include <vector>

#include "run/graph.hpp"

namespace gjkscope {

/// The reason why a point query needs care, by where Q lies (Catto 2010, slides "Numerical Issues"
/// to "Collinear vertices").
struct NumericalIssue {
  static constexpr std::string_view kName = "numerical-issue";
  static constexpr std::string_view kNeeds = "shape-hull,direction-rules";
  enum class Kind {
    direction,  ///< Beyond an edge: d = Q - P is rounded.
    repeated,   ///< Beyond a vertex: the same support point again.
    contained,  ///< Inside.
    vertex,     ///< On a vertex: d = 0.
    edge,       ///< On an edge: d may have either sign.
    interior,   ///< On a segment of vertices that are no neighbours: the same.
    notch,      ///< In the hull, outside of the polygon.
    collinear,  ///< Beyond three vertices on one line: each is a support point.
  };
  struct Value {
    Kind kind = Kind::contained;
    double dot_with_edge = 0.0;  ///< The dot product of d = Q - P, as built for the last scan.
    std::vector<int> support;    ///< Vertices of Y that are farthest along the last d.
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
