#pragma once
// Shapes and poses as Bullet has them, in the scalar that it was built with.

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>
#include <vector>

#include "grid_pairs.hpp"

namespace bench {

inline btVector3 to_bullet(const Point<3>& point) {
  const auto p = point.cast<btScalar>().eval();
  return {p[0], p[1], p[2]};
}

inline std::unique_ptr<btConvexHullShape> to_bullet(const std::vector<Point<3>>& shape) {
  auto out = std::make_unique<btConvexHullShape>();
  for (const Point<3>& point : shape) out->addPoint(to_bullet(point), false);
  out->recalcLocalAabb();
  out->setMargin(0);
  return out;
}

inline btTransform to_bullet(const gjk::Pose<double, 3>& pose) {
  const auto r = pose.rotation.matrix().cast<btScalar>().eval();
  const btMatrix3x3 turn(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1),
                         r(2, 2));
  return btTransform(turn, to_bullet(pose.translation));
}

}  // namespace bench
