#include <openGJK/openGJK.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

/// A shape, which has no pose: its vertices are moved before each query.
struct Body {
  std::vector<Point<3>> local;
  gjk::Pose<double, 3> pose;
  std::vector<Point<3>> world = local;
  std::vector<gkFloat*> rows = {};
};

gkPolytope placed(Body& body) {
  for (std::size_t i = 0; i < body.local.size(); ++i) {
    body.world[i] = body.pose.rotated(body.local[i]) + body.pose.translation;
  }
  gkPolytope out = {};
  out.numpoints = static_cast<int>(body.rows.size());
  out.coord = body.rows.data();
  return out;
}

Contestant prepare_all(std::span<const Pair<3>> pairs) {
  const auto prepared = std::make_shared<std::vector<std::array<Body, 2>>>();
  for (const Pair<3>& pair : pairs) {
    prepared->push_back({{{pair.x, pair.x_pose}, {pair.y, pair.y_pose}}});
    for (Body& body : prepared->back()) {
      for (Point<3>& point : body.world) body.rows.push_back(point.data());
    }
  }
  return contestant(
      pairs.size(),
      [prepared](std::size_t i) {
        auto& [x, y] = (*prepared)[i];
        gkSimplex simplex = {};
        return compute_minimum_distance(placed(x), placed(y), &simplex);
      },
      [](double distance) { return distance; });
}

}  // namespace

Library<3> opengjk() {
  return {.name = "openGJK",
          .how = "compute_minimum_distance, vertices moved before each query",
          .in_double = true,
          .prepare = prepare_all};
}

}  // namespace bench
