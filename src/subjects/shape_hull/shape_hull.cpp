#include "subjects/shape_hull/shape_hull.hpp"

#include <algorithm>
#include <limits>

#include "outlines/polygon.hpp"
#include "subjects/shape_hull/subject.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

/// Vertices this close to the hull, relative to its size, count as on it: about what rounding puts
/// between three points of a line whose coordinates are not dyadic.
constexpr double kOnHull = 1e-12;

ShapeHull::Hull hull_of(const std::vector<Vector2d>& points) {
  ShapeHull::Hull hull{convex_hull(points), {}};
  const std::size_t count = hull.corners.size();
  const double size = (points[hull.corners[0]] - points[hull.corners[count / 2]]).norm();
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    // Points on an edge of the hull belong to it, too.
    const bool on_hull = std::any_of(hull.corners.begin(), hull.corners.end(), [&](const int& a) {
      const std::size_t k = static_cast<std::size_t>(&a - hull.corners.data());
      return segment_distance(points[i], points[a], points[hull.corners[(k + 1) % count]]) <=
             kOnHull * size;
    });
    if (!on_hull) hull.inside.push_back(i);
  }
  return hull;
}

}  // namespace

EffectKey ShapeHull::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

ShapeHull::Value ShapeHull::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const PositionedRun& positioned = run.run(frame);
  const std::vector<Vector2d> y = in_plane(positioned.y().world);
  const Vector2d x = in_plane(positioned.x().world[0]);
  Value value{hull_of(in_plane(positioned.x().world)), hull_of(y), Vector2d::Zero(),
              std::numeric_limits<double>::infinity()};
  if (is_inside(y, x)) {
    value.outline_point = x;
    value.outline_distance = 0.0;
  }
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Vector2d point = closest_on_segment(x, y[i], y[(i + 1) % y.size()]);
    const double distance = (x - point).norm();
    if (distance >= value.outline_distance) continue;
    value.outline_point = point;
    value.outline_distance = distance;
  }
  return value;
}

const EffectInfo effect_infos::kShapeHull =
    effect_info<ShapeHull>("view", "convex hulls of shapes that are not convex");

}  // namespace gjkscope
