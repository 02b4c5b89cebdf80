#pragma once
#include <optional>

#include "run/graph.hpp"

namespace gjkscope {

/// The support line, of those found by a frame's step, that proves the widest strip between X and Y
/// empty (Larsen 1998, "Proof of Local Verification"). All of Y lies on one side of the line
/// through its support point along d, normal to d; all of X on the other side of the line through
/// its own along -d. The strip between them, seen in the difference, lies between O and the support
/// line of Z: its width is a lower bound of the distance.
struct BestSupport {
  static constexpr std::string_view kName = "best-support";
  static constexpr std::string_view kNeeds = "";
  struct Strip {
    WideVertex support;
    Eigen::Vector3d normal;  ///< d as a unit vector: from Y to X.
    double width = 0.0;
  };
  /// Empty until a support line has X and Y on its two sides.
  using Value = std::optional<Strip>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// True when the search that led to `state` found the strip, and no earlier one.
[[nodiscard]] bool is_found_by(const BestSupport::Strip& strip, const WideState& state);

/// The strip itself. The slab of subjects/slab_proof is between two points instead, and may hold
/// vertices.
struct Slab {
  static constexpr std::string_view kName = "slab";
  static constexpr std::string_view kNeeds = "best-support";
  using Value = BestSupport::Value;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
