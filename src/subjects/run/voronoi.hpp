#pragma once
#include "outlines/polygon.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// The Voronoi regions of the simplex that a frame shows, each as the half-planes whose
/// intersection it is, in the coordinates of the Minkowski difference (Catto 2010, slides "Voronoi
/// regions"). The stage clips them to what it shows. A region that a degenerate simplex does not
/// have is left out.
struct VoronoiRegions {
  static constexpr std::string_view kName = "voronoi-regions";
  static constexpr std::string_view kNeeds = "";
  struct Region {
    gjk::Face face = 0;
    std::vector<HalfPlane> half_planes;
  };
  using Value = std::vector<Region>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
