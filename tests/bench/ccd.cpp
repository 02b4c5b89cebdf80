#include <ccd/ccd.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

/// A polygon in the plane z = 0.
struct Shape {
  std::vector<Point> vertices;
  gjk::Pose<double, 2> pose;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Shape& shape = *static_cast<const Shape*>(object);
  const Point local = shape.pose.direction_to_local(Point(direction->v[0], direction->v[1]));
  const auto farther = [&](const Point& a, const Point& b) { return local.dot(a) < local.dot(b); };
  const Point best = *std::max_element(shape.vertices.begin(), shape.vertices.end(), farther);
  const Point world = shape.pose.rotated(best) + shape.pose.translation;
  ccdVec3Set(out, world[0], world[1], 0.0);
}

Contestant prepare_all(std::span<const Pair> pairs) {
  const auto shapes = std::make_shared<std::vector<std::pair<Shape, Shape>>>();
  for (const Pair& pair : pairs) shapes->push_back({{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support;
  ccd.support2 = support;
  ccd.max_iterations = 1000;
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        const auto& [x, y] = (*shapes)[i];
        return ccdGJKIntersect(&x, &y, &ccd);
      },
      [](int intersect) { return intersect != 0 ? 0.0 : 1.0; });
}

}  // namespace

Library libccd() {
  return {.name = "libccd " PEER_VERSION,
          .how = "ccdGJKIntersect on flat shapes; it tells overlap only",
          .in_double = sizeof(ccd_real_t) == sizeof(double),
          .measures = false,
          .prepare = prepare_all};
}

}  // namespace bench
