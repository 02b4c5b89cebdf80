#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// Barycentric coordinates of the query point in the whole simplex that a frame tests, signed,
/// before any vertex is dropped: fractional lengths of a segment, fractional areas of a triangle.
/// Computed in the lesson's scalar.
struct BarycentricWeights {
  static constexpr std::string_view kName = "barycentric-weights";
  static constexpr std::string_view kNeeds = "";
  struct Value {
    WideSimplex simplex;          ///< The simplex that the coordinates belong to.
    std::vector<double> weights;  ///< One a vertex; empty when the simplex is degenerate.
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The parts of the simplex that the weights measure, in the coordinates of the Minkowski
/// difference: for vertex A of a triangle the triangle Q B C; for A of a segment the piece from the
/// projection of Q to B.
struct BarycentricParts {
  static constexpr std::string_view kName = "barycentric-parts";
  static constexpr std::string_view kNeeds = "barycentric-weights";
  struct Part {
    int vertex = 0;
    double weight = 0.0;
    std::vector<Eigen::Vector3d> points;  ///< Two for a length, three for an area.
  };
  using Value = std::vector<Part>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
