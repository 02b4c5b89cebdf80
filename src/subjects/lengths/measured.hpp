#pragma once
#include <optional>
#include <vector>

#include "run/graph.hpp"

namespace gjkscope {

/// The lengths that a scan for a support point compares: how far each vertex of Y reaches along d,
/// and each of X along -d (Catto 2010, slides "Support points"). Nothing before the scan.
struct SupportAxis {
  static constexpr std::string_view kName = "support-axis";
  static constexpr std::string_view kNeeds = "facts";
  struct Side {
    std::vector<double> reach;  ///< dot(vertex, d) / |d|, in the world's unit.
    int farthest = 0;           ///< Index of the support point.
  };
  struct Sides {
    Eigen::Vector3d d = Eigen::Vector3d::Zero();  ///< The direction, of length 1; for X it is -d.
    Side y;
    Side x;
  };
  using Value = std::optional<Sides>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The circle about the query point through P, in the coordinates of the difference: the feature
/// that holds P touches it, and nothing of the simplex lies inside. Its radius; nothing before P is
/// known, and where P is the query point.
struct ClosestCircle {
  static constexpr std::string_view kName = "closest-circle";
  static constexpr std::string_view kNeeds = "facts";
  using Value = std::optional<double>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The lengths that the region test of a frame compares: for each coordinate on an edge the foot of
/// the query point on the edge's line, and the length from the edge's other end that the coordinate
/// measures (Catto 2010, slides "Projection", "Voronoi regions"). For frames that go through region
/// tests.
struct TestedFeet {
  static constexpr std::string_view kName = "tested-feet";
  static constexpr std::string_view kNeeds = "facts";
  struct Foot {
    int vertex = 0;                                ///< The coordinate's, in the simplex.
    int other = 0;                                 ///< The edge's other end.
    double value = 0.0;                            ///< The coordinate: 1 at `vertex`, 0 at `other`.
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< In the coordinates of the difference.
  };
  using Value = std::vector<Foot>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
