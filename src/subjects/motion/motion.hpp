#pragma once
#include <optional>

#include "subjects/difference/minkowski.hpp"

namespace gjkscope {

/// The shapes and their difference a position ago, and how far each went since. A shape that turns
/// changes the difference; one that only moves slides it: Z by what Y moved, less what X moved.
struct LastPosition {
  static constexpr std::string_view kName = "last-position";
  static constexpr std::string_view kNeeds = "minkowski-hull";
  struct Positions {
    std::vector<Eigen::Vector2d> x;
    std::vector<Eigen::Vector2d> y;
    std::vector<Eigen::Vector2d> z;  ///< Corners of the hull, counter-clockwise.
    Eigen::Vector2d x_by;
    Eigen::Vector2d y_by;
    bool turned = false;  ///< One of the shapes turned; then Z did more than slide.
  };
  /// Empty at the first position.
  using Value = std::optional<Positions>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Y grown by X: where the point that X's vertices are given from cannot be without X touching Y.
/// It equals Y - X with X at its own origin: the difference, moved by the place of X (Larsen 1998,
/// "Minkowski Difference and Translation"). Corners in the world, counter-clockwise.
struct GrownObstacle {
  static constexpr std::string_view kName = "grown-obstacle";
  static constexpr std::string_view kNeeds = "minkowski-hull";
  using Value = std::vector<Eigen::Vector2d>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
