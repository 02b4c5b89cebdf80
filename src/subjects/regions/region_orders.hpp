#pragma once
#include <array>
#include <vector>

#include "run/graph.hpp"
#include "subjects/regions/tour.hpp"

namespace gjkscope {

/// The region tests of a triangle in three chains, one for each OrderStage after the numbers: short
/// tests with vertices first and with edges first, whole tests with edges first. A short test of an
/// edge asks for the sign of the area alone, as is enough once the vertices are ruled out (Catto
/// 2010, slides "Second: edge regions" and "solved"); whole tests are those of the core. Computed
/// in the lesson's scalar from the coordinates of the simplex; empty where it is no triangle.
struct RegionOrders {
  static constexpr std::string_view kName = "region-orders";
  static constexpr std::string_view kNeeds = "";
  struct Chain {
    gjk::RegionOrder order = gjk::RegionOrder::vertices_first;
    bool whole = false;
    std::vector<gjk::RegionTest<double>> tests;   ///< Those tried; the last one holds.
    gjk::Face region = 0;                         ///< The region taken.
    std::array<double, 3> weights = {};           ///< Those of the point; negative beyond an edge.
    Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< The point taken, in the difference.
    double error = 0.0;                           ///< Its distance from the run's P.
  };
  using Value = std::vector<Chain>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
