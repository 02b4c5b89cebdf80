#include <box2d/b2_distance.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

/// A local type: Box2D 3 has other structures of the same names.
struct Prepared {
  std::vector<b2Vec2> x;
  std::vector<b2Vec2> y;
  b2Transform x_pose;
  b2Transform y_pose;
  b2DistanceInput input;
};

b2Vec2 to_box2d(const Point<2>& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1])};
}

b2Transform to_box2d(const gjk::Pose<double, 2>& pose) {
  b2Transform out;
  out.p = to_box2d(pose.translation);
  out.q.c = static_cast<float>(pose.rotation(0, 0));
  out.q.s = static_cast<float>(pose.rotation(1, 0));
  return out;
}

void prepare(const Pair<2>& pair, Prepared& out) {
  for (const Point<2>& point : pair.x) out.x.push_back(to_box2d(point));
  for (const Point<2>& point : pair.y) out.y.push_back(to_box2d(point));
  out.x_pose = to_box2d(pair.x_pose);
  out.y_pose = to_box2d(pair.y_pose);
  out.input.proxyA.Set(out.x.data(), static_cast<int32>(out.x.size()), 0.0F);
  out.input.proxyB.Set(out.y.data(), static_cast<int32>(out.y.size()), 0.0F);
  out.input.useRadii = false;
}

Contestant prepare_all(std::span<const Pair<2>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) prepare(pairs[i], (*prepared)[i]);
  return contestant(
      pairs.size(),
      [prepared](std::size_t i) {
        Prepared& pair = (*prepared)[i];
        pair.input.transformA = pair.x_pose;
        pair.input.transformB = pair.y_pose;
        b2SimplexCache cache;
        cache.count = 0;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &pair.input);
        return output;
      },
      [](const b2DistanceOutput& output) { return output.distance; });
}

}  // namespace

Library<2> box2d_2() {
  return {.name = "Box2D 2.4",
          .how = "b2Distance, useRadii false, an empty cache; a short direction means overlap",
          .prepare = prepare_all};
}

}  // namespace bench
