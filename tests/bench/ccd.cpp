#include <ccd/ccd.h>

#include <algorithm>
#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

/// In the plane a prism over a polygon, from z = -1 to 1: ccdGJKIntersect needs volume to find
/// overlap.
template <int D>
struct Solid {
  std::vector<Point<D>> vertices;
  gjk::Pose<double, D> pose;
};

template <int D>
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const auto& solid = *static_cast<const Solid<D>*>(object);
  const Point<D> local =
      solid.pose.direction_to_local(Point<D>(Eigen::Map<const Point<D>>(direction->v)));
  const auto farther = [&](const Point<D>& a, const Point<D>& b) {
    return local.dot(a) < local.dot(b);
  };
  const Point<D> best = *std::max_element(solid.vertices.begin(), solid.vertices.end(), farther);
  const Point<D> world = solid.pose.rotated(best) + solid.pose.translation;
  const double of_prism = direction->v[2] < 0.0 ? -1.0 : 1.0;
  ccdVec3Set(out, world[0], world[1], D == 2 ? of_prism : world[D - 1]);
}

template <int D>
Contestant prepare_all(std::span<const Pair<D>> pairs) {
  const auto solids = std::make_shared<std::vector<std::pair<Solid<D>, Solid<D>>>>();
  for (const Pair<D>& pair : pairs) {
    solids->push_back({{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
  }
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support<D>;
  ccd.support2 = support<D>;
  ccd.max_iterations = 1000;
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        const auto& [x, y] = (*solids)[i];
        return ccdGJKIntersect(&x, &y, &ccd);
      },
      [](int intersect) { return intersect != 0 ? 0.0 : 1.0; });
}

}  // namespace

template <int D>
Library<D> libccd() {
  return {.name = "libccd " PEER_VERSION,
          .how = std::string("ccdGJKIntersect") + (D == 2 ? " on prisms" : "") +
                 "; it tells overlap only, to an absolute 2.2e-16",
          .in_double = sizeof(ccd_real_t) == sizeof(double),
          .measures = false,
          .prepare = prepare_all<D>};
}
template Library<2> libccd();
template Library<3> libccd();

}  // namespace bench
