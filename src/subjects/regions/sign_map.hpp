#pragma once
#include "outlines/polygon.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// The plane around a triangle by the signs of u, v and w: three lines cut it into seven regions,
/// which are not the Voronoi regions (Catto 2010, slides "Barycentric regions of a triangle" to
/// "The uv regions are not exclusive"). In the coordinates of the Minkowski difference; empty where
/// the simplex is no triangle.
struct SignMap {
  static constexpr std::string_view kName = "sign-map";
  static constexpr std::string_view kNeeds = "";
  struct Region {
    gjk::Face positive =
        0;  ///< Vertices of positive weight: the feature that the signs would name.
    std::vector<HalfPlane> half_planes;
  };
  using Value = std::vector<Region>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The area in which the signs name one feature and the Voronoi regions another (Catto 2010, slide
/// "Voronoi versus Barycentric"). Convex, possibly unbounded or empty parts.
struct MapDifference {
  static constexpr std::string_view kName = "map-difference";
  static constexpr std::string_view kNeeds = "sign-map,voronoi-regions";
  struct Part {
    gjk::Face by_signs = 0;
    gjk::Face closest = 0;
    std::vector<HalfPlane> half_planes;
  };
  using Value = std::vector<Part>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
