#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

struct Prepared {
  std::unique_ptr<btConvexHullShape> x;
  std::unique_ptr<btConvexHullShape> y;
  btDiscreteCollisionDetectorInterface::ClosestPointInput poses;
};

btVector3 to_bullet(const Point<3>& point) {
  const auto p = point.cast<btScalar>().eval();
  return {p[0], p[1], p[2]};
}

std::unique_ptr<btConvexHullShape> to_bullet(const std::vector<Point<3>>& shape) {
  auto out = std::make_unique<btConvexHullShape>();
  for (const Point<3>& point : shape) out->addPoint(to_bullet(point), false);
  out->recalcLocalAabb();
  out->setMargin(0);
  return out;
}

btTransform to_bullet(const gjk::Pose<double, 3>& pose) {
  const auto r = pose.rotation.matrix().cast<btScalar>().eval();
  const btMatrix3x3 turn(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1),
                         r(2, 2));
  return btTransform(turn, to_bullet(pose.translation));
}

Contestant prepare_all(std::span<const Pair<3>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Prepared& out = (*prepared)[i];
    out.x = to_bullet(pairs[i].x);
    out.y = to_bullet(pairs[i].y);
    out.poses.m_transformA = to_bullet(pairs[i].x_pose);
    out.poses.m_transformB = to_bullet(pairs[i].y_pose);
  }
  return contestant(
      pairs.size(),
      [prepared](std::size_t i) {
        const Prepared& pair = (*prepared)[i];
        btVoronoiSimplexSolver simplex;
        simplex.setEqualVertexThreshold(0);
        btGjkEpaPenetrationDepthSolver depth;
        btGjkPairDetector detector(pair.x.get(), pair.y.get(), &simplex, &depth);
        btPointCollector result;
        detector.getClosestPoints(pair.poses, result, nullptr);
        return result;
      },
      [](const btPointCollector& result) {
        return result.m_hasResult ? std::max(result.m_distance, btScalar(0)) : btScalar(0);
      });
}

}  // namespace

Library<3> bullet() {
  return {.name = "Bullet " PEER_VERSION,
          .how =
              "btGjkPairDetector on btConvexHullShape, margin 0, with EPA, which also measures "
              "depth; absolute thresholds",
          .in_double = sizeof(btScalar) == sizeof(double),
          .prepare = prepare_all};
}

}  // namespace bench
