#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// The simplices after drop, and closest points of the iterations that were complete before a
/// frame's.
struct History {
  static constexpr std::string_view kName = "history";
  static constexpr std::string_view kNeeds = "";
  struct Entry {
    int iteration = 1;
    WideSimplex simplex;
    Eigen::Vector3d p;
  };
  using Value = std::vector<Entry>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
