#include "subjects/run/voronoi.hpp"

#include "subjects/run/subject.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

Vector2d perpendicular(const Vector2d& v) { return {v.y(), -v.x()}; }

/// Johnson's condition for each face, as half-planes: those of a vertex end at its edges' normals,
/// those of an edge at both ends and at the edge itself, away from the third vertex.
std::vector<HalfPlane> region_of(const std::vector<Vector2d>& points, gjk::Face face) {
  std::vector<HalfPlane> out;
  const int count = static_cast<int>(points.size());
  const int size = gjk::vertex_count(face);
  for (int i = 0; i < count; ++i) {
    if (!gjk::contains(face, i)) continue;
    for (int j = 0; j < count; ++j) {
      if (j == i) continue;
      const Vector2d edge = points[j] - points[i];
      if (size == 1) {
        out.push_back({points[i], edge});
      } else if (size == 2 && gjk::contains(face, j)) {
        out.push_back({points[i], -edge});
      }
    }
  }
  for (int k = 0; k < count && count == 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const bool edge_of_face = gjk::contains(face, i) && gjk::contains(face, j);
    if (!edge_of_face) continue;
    Vector2d inwards = perpendicular(points[j] - points[i]);
    if (inwards.dot(points[k] - points[i]) < 0.0) inwards = -inwards;
    out.push_back({points[i], size == 3 ? Vector2d(-inwards) : inwards});
  }
  return out;
}

}  // namespace

EffectKey VoronoiRegions::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), -1};
}

VoronoiRegions::Value VoronoiRegions::compute(EffectGraph&, const LessonRun& run,
                                              const Frame& frame) {
  const WideSimplex& simplex = run.state(frame).simplex;
  std::vector<Vector2d> points;
  for (int i = 0; i < simplex.count; ++i) points.push_back(in_plane(simplex.vertices[i].w));
  Value regions;
  for (gjk::Face face = 1; face <= simplex.all(); ++face) {
    const bool interior_of_degenerate = gjk::vertex_count(face) == 3 && signed_area(points) == 0.0;
    if (!interior_of_degenerate) regions.push_back({face, region_of(points, face)});
  }
  return regions;
}

const EffectInfo effect_infos::kVoronoiRegions =
    effect_info<VoronoiRegions>("view", "Voronoi regions of the current simplex");

}  // namespace gjkscope
