#include <ccd/ccd.h>

#include <memory>

#include "depths.hpp"

namespace bench {
namespace {

struct Solid {
  std::vector<Point<3>> vertices;
  gjk::Pose<double, 3> pose;
  Point<3> mean;  ///< In the world.

  Solid(const std::vector<Point<3>>& points, const gjk::Pose<double, 3>& at)
      : vertices(points), pose(at), mean(Point<3>::Zero()) {
    for (const Point<3>& p : points) mean += world(p) / static_cast<double>(points.size());
  }
  [[nodiscard]] Point<3> world(const Point<3>& p) const {
    return pose.rotated(p) + pose.translation;
  }
};

/// Scans all vertices, as the core does.
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const auto& solid = *static_cast<const Solid*>(object);
  const Point<3> d =
      solid.pose.direction_to_local(Point<3>(direction->v[0], direction->v[1], direction->v[2]));
  std::size_t farthest = 0;
  double most = d.dot(solid.vertices[0]);
  for (std::size_t i = 1; i < solid.vertices.size(); ++i) {
    const double value = d.dot(solid.vertices[i]);
    farthest = most < value ? i : farthest;
    most = std::max(most, value);
  }
  const Point<3> world = solid.world(solid.vertices[farthest]);
  ccdVec3Set(out, world[0], world[1], world[2]);
}

void center(const void* object, ccd_vec3_t* out) {
  const Point<3>& mean = static_cast<const Solid*>(object)->mean;
  ccdVec3Set(out, mean[0], mean[1], mean[2]);
}

template <auto penetration>
std::function<Depth(std::size_t)> prepare(std::span<const Pair<3>> pairs) {
  const auto solids = std::make_shared<std::vector<std::pair<Solid, Solid>>>();
  for (const Pair<3>& pair : pairs) {
    solids->push_back({{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
  }
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = center;
  ccd.max_iterations = 1000;
  ccd.epa_tolerance = ccd.mpr_tolerance = ccd.dist_tolerance = 1e-10;
  return [=](std::size_t i) {
    const auto& [x, y] = (*solids)[i];
    ccd_real_t depth = 0;
    ccd_vec3_t of_y;
    ccd_vec3_t position;
    if (penetration(&x, &y, &ccd, &depth, &of_y, &position) != 0) return Depth{};
    return Depth{true, depth, Point<3>(of_y.v[0], of_y.v[1], of_y.v[2]) * -depth};
  };
}

}  // namespace

std::vector<DepthLibrary> ccd_depths() {
  constexpr bool kInDouble = sizeof(ccd_real_t) == sizeof(double);
  return {{"libccd " PEER_VERSION " EPA", "ccdGJKPenetration, tolerances 1e-10", kInDouble,
           prepare<ccdGJKPenetration>},
          {"libccd " PEER_VERSION " MPR",
           "ccdMPRPenetration, tolerances 1e-10; the depth of the portal that the ray from the "
           "centers meets, which need not be the least",
           kInDouble, prepare<ccdMPRPenetration>}};
}

}  // namespace bench
