#include <box2d/collision.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

/// A local type: Box2D 2 has other structures of the same names.
struct Prepared {
  b2Transform x_pose;
  b2Transform y_pose;
  b2DistanceInput input;
};

b2Vec2 to_box2d(const Point& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1])};
}

b2Transform to_box2d(const gjk::Pose<double, 2>& pose) {
  return {to_box2d(pose.translation),
          {static_cast<float>(pose.rotation(0, 0)), static_cast<float>(pose.rotation(1, 0))}};
}

b2ShapeProxy proxy(const std::vector<Point>& shape) {
  b2Vec2 points[B2_MAX_POLYGON_VERTICES];
  std::transform(shape.begin(), shape.end(), points, [](const Point& p) { return to_box2d(p); });
  return b2MakeProxy(points, static_cast<int>(shape.size()), 0.0F);
}

Contestant prepare_all(std::span<const Pair> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair& pair : pairs) {
    prepared->push_back({to_box2d(pair.x_pose), to_box2d(pair.y_pose), {}});
    b2DistanceInput& input = prepared->back().input;
    input.proxyA = proxy(pair.x);
    input.proxyB = proxy(pair.y);
    input.useRadii = false;
  }
  return contestant(
      pairs.size(),
      [prepared](std::size_t i) {
        Prepared& pair = (*prepared)[i];
        pair.input.transformA = pair.x_pose;
        pair.input.transformB = pair.y_pose;
        b2SimplexCache cache = {};
        return b2ShapeDistance(&pair.input, &cache, nullptr, 0);
      },
      [](const b2DistanceOutput& output) { return output.distance; });
}

}  // namespace

Library box2d_3() {
  return {.name = "Box2D " PEER_VERSION,
          .how = "b2ShapeDistance, useRadii false, an empty cache",
          .max_vertices = B2_MAX_POLYGON_VERTICES,
          .prepare = prepare_all};
}

}  // namespace bench
