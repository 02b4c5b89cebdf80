#include "subjects/regions/sign_map.hpp"

#include "subjects/regions/subject.hpp"
#include "subjects/run/voronoi.hpp"

namespace gjkscope {

using Eigen::Vector2d;

EffectKey SignMap::key(const LessonRun& run, const Frame& frame) {
  return VoronoiRegions::key(run, frame);
}

SignMap::Value SignMap::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const WideSimplex& simplex = run.state(frame).simplex;
  Value regions;
  if (simplex.count != 3) return regions;
  for (gjk::Face positive = 1; positive <= simplex.all(); ++positive) {
    Region region{positive, {}};
    for (int i = 0; i < 3; ++i) {
      const Vector2d from = in_plane(simplex.vertices[(i + 1) % 3].w);
      const Vector2d edge = in_plane(simplex.vertices[(i + 2) % 3].w) - from;
      Vector2d inwards(edge.y(), -edge.x());
      if (inwards.dot(in_plane(simplex.vertices[i].w) - from) < 0.0) inwards = -inwards;
      region.half_planes.push_back(
          {from, gjk::contains(positive, i) ? Vector2d(-inwards) : inwards});
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

EffectKey MapDifference::key(const LessonRun& run, const Frame& frame) {
  return VoronoiRegions::key(run, frame);
}

MapDifference::Value MapDifference::compute(EffectGraph& graph, const LessonRun&,
                                            const Frame& frame) {
  Value parts;
  for (const SignMap::Region& signs : graph.get<SignMap>(frame)) {
    for (const VoronoiRegions::Region& voronoi : graph.get<VoronoiRegions>(frame)) {
      if (signs.positive == voronoi.face) continue;
      Part part{signs.positive, voronoi.face, signs.half_planes};
      part.half_planes.insert(part.half_planes.end(), voronoi.half_planes.begin(),
                              voronoi.half_planes.end());
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

const EffectInfo effect_infos::kSignMap =
    effect_info<SignMap>("view", "where u, v and w are negative");

const EffectInfo effect_infos::kMapDifference = effect_info<MapDifference>(
    "view", "where the signs and the Voronoi regions name different features");

}  // namespace gjkscope
