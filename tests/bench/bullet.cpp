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

std::unique_ptr<btConvexHullShape> flat(const std::vector<Point>& shape) {
  auto out = std::make_unique<btConvexHullShape>();
  for (const Point& point : shape) {
    out->addPoint(btVector3(static_cast<btScalar>(point[0]), static_cast<btScalar>(point[1]), 0),
                  false);
  }
  out->recalcLocalAabb();
  out->setMargin(0);
  return out;
}

btTransform in_space(const gjk::Pose<double, 2>& pose) {
  const auto r = pose.rotation.matrix().cast<btScalar>().eval();
  const auto t = pose.translation.cast<btScalar>().eval();
  const btMatrix3x3 turn(r(0, 0), r(0, 1), 0, r(1, 0), r(1, 1), 0, 0, 0, 1);
  return btTransform(turn, btVector3(t[0], t[1], 0));
}

Contestant prepare_all(std::span<const Pair> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Prepared& out = (*prepared)[i];
    out.x = flat(pairs[i].x);
    out.y = flat(pairs[i].y);
    out.poses.m_transformA = in_space(pairs[i].x_pose);
    out.poses.m_transformB = in_space(pairs[i].y_pose);
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

Library bullet() {
  return {.name = "Bullet " PEER_VERSION,
          .how = "btGjkPairDetector on flat btConvexHullShape, margin 0, EPA; absolute thresholds",
          .in_double = sizeof(btScalar) == sizeof(double),
          .prepare = prepare_all};
}

}  // namespace bench
