#pragma once
#include "effects/graph.hpp"

namespace gjkscope {

/// The pair of shapes that the configuration of a frame answers worst, by the lesson's [study];
/// with granularity `study`, and a frame that shows a configuration.
struct WorstPair {
  static constexpr std::string_view kName = "worst-pair";
  static constexpr std::string_view kNeeds = "";
  struct Value {
    std::vector<Eigen::Vector2d> x;  ///< Corners of the hull, counter-clockwise.
    std::vector<Eigen::Vector2d> y;
    Eigen::Vector2d on_x;  ///< The closest points, in double with proof.
    Eigen::Vector2d on_y;
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
