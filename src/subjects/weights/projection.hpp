#pragma once
#include <optional>

#include "run/graph.hpp"

namespace gjkscope {

/// The point G(u, v) = uA + vB of a segment's line that the query point falls on, in the
/// coordinates of the Minkowski difference (Catto 2010, slides "Projection: region A" to "(u,v)
/// from Q"). Nothing where the simplex is no segment, or of length 0.
struct Projection {
  static constexpr std::string_view kName = "projection";
  static constexpr std::string_view kNeeds = "barycentric-weights";
  using Value = std::optional<Eigen::Vector3d>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The unit vector n = (B - A) / |B - A| of a segment, and the lengths along it that u and v are
/// fractions of: those from G, and those from Q itself, which are the same because Q - G is normal
/// to n (Catto 2010, slides "Unit vector", "(u,v) from G", "(u,v) from Q").
struct UnitVector {
  static constexpr std::string_view kName = "unit-vector";
  static constexpr std::string_view kNeeds = "barycentric-weights,projection";
  struct Lengths {
    double to_b = 0.0;    ///< dot(B - point, n); divided by `length`: u.
    double from_a = 0.0;  ///< dot(point - A, n); divided by `length`: v.
  };
  struct Built {
    Eigen::Vector3d n = Eigen::Vector3d::Zero();
    double length = 0.0;  ///< |B - A|
    Lengths of_g;
    Lengths of_q;
  };
  using Value = std::optional<Built>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
