#include <ccd/ccd.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

/// A prism over a polygon, from z = -1 to 1: ccdGJKIntersect needs volume to find overlap.
struct Prism {
  std::vector<Point> vertices;
  gjk::Pose<double, 2> pose;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Prism& prism = *static_cast<const Prism*>(object);
  const Point local = prism.pose.direction_to_local(Point(direction->v[0], direction->v[1]));
  const auto farther = [&](const Point& a, const Point& b) { return local.dot(a) < local.dot(b); };
  const Point best = *std::max_element(prism.vertices.begin(), prism.vertices.end(), farther);
  const Point world = prism.pose.rotated(best) + prism.pose.translation;
  ccdVec3Set(out, world[0], world[1], direction->v[2] < 0.0 ? -1.0 : 1.0);
}

Contestant prepare_all(std::span<const Pair> pairs) {
  const auto prisms = std::make_shared<std::vector<std::pair<Prism, Prism>>>();
  for (const Pair& pair : pairs) prisms->push_back({{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support;
  ccd.support2 = support;
  ccd.max_iterations = 1000;
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        const auto& [x, y] = (*prisms)[i];
        return ccdGJKIntersect(&x, &y, &ccd);
      },
      [](int intersect) { return intersect != 0 ? 0.0 : 1.0; });
}

}  // namespace

Library libccd() {
  return {.name = "libccd " PEER_VERSION,
          .how = "ccdGJKIntersect on prisms; it tells overlap only, to an absolute 2.2e-16",
          .in_double = sizeof(ccd_real_t) == sizeof(double),
          .measures = false,
          .prepare = prepare_all};
}

}  // namespace bench
