#pragma once
#include <optional>

#include "run/graph.hpp"

namespace gjkscope {

/// The normal that the run did not take, and its support point, when the query point lies on the
/// line of the simplex, a segment (Catto 2010, slides "Case 3b: edge overlap", "Case 4: interior
/// edge"). Nothing elsewhere, and before d is known.
struct OtherNormal {
  static constexpr std::string_view kName = "other-normal";
  static constexpr std::string_view kNeeds = "facts";
  struct Search {
    Eigen::Vector3d d = Eigen::Vector3d::Zero();
    gjk::VertexPair support;
    bool in_simplex = false;
  };
  using Value = std::optional<Search>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
