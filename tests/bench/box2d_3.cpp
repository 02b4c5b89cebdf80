#include <box2d/collision.h>
#include <box2d/math_functions.h>

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

b2Vec2 to_box2d(const Point<2>& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1])};
}

b2Transform to_box2d(const gjk::Pose<double, 2>& pose) {
  return {to_box2d(pose.translation),
          {static_cast<float>(pose.rotation(0, 0)), static_cast<float>(pose.rotation(1, 0))}};
}

auto proxy(const std::vector<Point<2>>& shape) {
  std::vector<b2Vec2> points;
  for (const Point<2>& point : shape) points.push_back(to_box2d(point));
  return b2MakeProxy(points.data(), static_cast<int>(points.size()), 0.0F);
}

/// Up to 3.1 the input has a pose for each shape, after it one: that of Y in the frame of X.
template <class Input>
void set_poses(Input& input, const b2Transform& x, const b2Transform& y) {
  if constexpr (requires { input.transform; }) {
    input.transform = b2InvMulTransforms(x, y);
  } else {
    input.transformA = x;
    input.transformB = y;
  }
}

/// From 3.1 on.
template <class Cache, class Simplex>
b2DistanceOutput ask(b2DistanceOutput (*distance)(const b2DistanceInput*, Cache*, Simplex*, int),
                     const b2DistanceInput& input) {
  Cache cache = {};
  return distance(&input, &cache, nullptr, 0);
}
/// In 3.0.
template <class Cache, class Simplex>
b2DistanceOutput ask(b2DistanceOutput (*distance)(Cache*, const b2DistanceInput*, Simplex*, int),
                     const b2DistanceInput& input) {
  Cache cache = {};
  return distance(&cache, &input, nullptr, 0);
}

Contestant prepare_all(std::span<const Pair<2>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair<2>& pair : pairs) {
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
        set_poses(pair.input, pair.x_pose, pair.y_pose);
        return ask(b2ShapeDistance, pair.input);
      },
      [](const b2DistanceOutput& output) { return output.distance; });
}

}  // namespace

Library<2> box2d_3() {
  return {.name = "Box2D " PEER_VERSION,
          .how = "b2ShapeDistance, useRadii false, an empty cache; a short direction means overlap",
          .max_vertices = sizeof(b2DistanceInput{}.proxyA.points) / sizeof(b2Vec2),
          .prepare = prepare_all};
}

}  // namespace bench
