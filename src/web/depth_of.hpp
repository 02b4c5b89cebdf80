#pragma once

#include <Eigen/Core>
#include <optional>

#include "lesson/run.hpp"

namespace gjkscope {

/// How deep the shapes of a run lie in each other, and the shortest motion of X after which they
/// just touch; lower <= exact depth <= upper.
struct Depth {
  double depth = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();
  Eigen::Vector2d contact = Eigen::Vector2d::Zero();  ///< Of X, before the motion.
};
/// Computed in `scalar`; nothing for shapes apart.
[[nodiscard]] std::optional<Depth> depth_of(const PositionedRun& run, ScalarKind scalar);

}  // namespace gjkscope
