#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btMinkowskiPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "bullet_shapes.hpp"
#include "depths.hpp"

namespace bench {
namespace {

struct Prepared {
  std::unique_ptr<btConvexHullShape> x;
  std::unique_ptr<btConvexHullShape> y;
  btTransform x_pose;
  btTransform y_pose;
};

template <class Solver>
std::function<Depth(std::size_t)> prepare(std::span<const Pair<3>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair<3>& pair : pairs) {
    prepared->push_back(
        {to_bullet(pair.x), to_bullet(pair.y), to_bullet(pair.x_pose), to_bullet(pair.y_pose)});
  }
  return [prepared](std::size_t i) {
    const Prepared& pair = (*prepared)[i];
    btVoronoiSimplexSolver simplex;
    Solver solver;
    btVector3 normal;
    btVector3 on_x;
    btVector3 on_y;
    if (!solver.calcPenDepth(simplex, pair.x.get(), pair.y.get(), pair.x_pose, pair.y_pose, normal,
                             on_x, on_y, nullptr))
      return Depth{};
    const btVector3 t = on_y - on_x;
    return Depth{true, t.length(), Point<3>(t.x(), t.y(), t.z())};
  };
}

}  // namespace

std::vector<DepthLibrary> bullet_depths() {
  constexpr bool kInDouble = sizeof(btScalar) == sizeof(double);
  return {{"Bullet " PEER_VERSION " EPA",
           "btGjkEpaPenetrationDepthSolver on btConvexHullShape, margin 0", kInDouble,
           prepare<btGjkEpaPenetrationDepthSolver>},
          {"Bullet " PEER_VERSION " Minkowski",
           "btMinkowskiPenetrationDepthSolver, margin 0; it tries some fixed directions and the "
           "normals that shapes name",
           kInDouble, prepare<btMinkowskiPenetrationDepthSolver>}};
}

}  // namespace bench
