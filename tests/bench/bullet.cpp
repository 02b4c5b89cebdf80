#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "bullet_shapes.hpp"
#include "libraries.hpp"

namespace bench {
namespace {

struct Prepared {
  std::unique_ptr<btConvexHullShape> x;
  std::unique_ptr<btConvexHullShape> y;
  btDiscreteCollisionDetectorInterface::ClosestPointInput poses;
};

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
