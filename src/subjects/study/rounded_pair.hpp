#pragma once
#include <array>
#include <vector>

#include "run/graph.hpp"

namespace gjkscope {

/// The lesson's first query in three scalars, each from the same vertices: exact, in float, which
/// rounds the vertices, and in double.
struct RoundedPair {
  static constexpr std::string_view kName = "rounded-pair";
  static constexpr std::string_view kNeeds = "";
  /// A vertex of X or of Y.
  struct Vertex {
    bool of_x = false;
    int index = 0;
  };
  /// Between a vertex of one shape and the other shape.
  struct Gap {
    Eigen::Vector2d vertex;
    Eigen::Vector2d other;  ///< The point of the other shape that is closest.
    double length = 0.0;
  };
  /// One vertex before and after rounding to float.
  struct End {
    Vertex of;
    Gap exact;
    Gap in_float;
  };
  struct Value {
    PositionedRun exact;
    PositionedRun in_float;
    PositionedRun in_double;
    /// The vertices at which the shapes are closest, in truth and in the run in float.
    std::array<End, 2> ends;
    /// The ends of the two edges that face each other, an edge's one after the other; empty where
    /// these are not edges.
    std::vector<Vertex> facing;
    double tilt = 0.0;  ///< Radians between these edges.

    [[nodiscard]] double distance() const { return exact.trace.result.distance; }
    /// How many times larger the spacing of floats is seen: 1, 2 or 5 times a power of ten.
    [[nodiscard]] double magnification() const;
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

[[nodiscard]] Eigen::Vector2d vertex_in_world(const PositionedRun& run,
                                              const RoundedPair::Vertex& vertex);

/// How far a float of this size is from the next larger one.
[[nodiscard]] double spacing_of_floats(double value);

/// By which share an answer is off: |answer - distance| as a share of the larger of the two.
[[nodiscard]] double error_of(double answer, double distance);

}  // namespace gjkscope
