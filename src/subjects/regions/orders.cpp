#include "outlines/polygon.hpp"
#include "picture/words.hpp"
#include "subjects/regions/region_orders.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

/// The chain of tests that the frame shows; none beside the numbers.
const RegionOrders::Chain* chain_of(const SceneBuilder& scene) {
  const RegionOrders::Value& chains = scene.effects.get<RegionOrders>(scene.frame);
  const int index =
      static_cast<int>(order_stage(scene.run, scene.frame).value_or(OrderStage::numbers)) - 1;
  if (index < 0 || chains.empty()) return nullptr;
  return &chains[index];
}

void short_test(SceneBuilder& scene) {
  const RegionOrders::Chain* chain = chain_of(scene);
  if (!chain || chain->whole || gjk::vertex_count(chain->region) != 2) return;
  const WideSimplex& simplex = scene.state.simplex;
  int opposite = 0;
  while (gjk::contains(chain->region, opposite)) ++opposite;
  const Vector2d from = in_plane(simplex.vertices[(opposite + 1) % 3].w) + in_plane(scene.shift);
  const Vector2d edge =
      in_plane(simplex.vertices[(opposite + 2) % 3].w) + in_plane(scene.shift) - from;
  Vector2d inwards(edge.y(), -edge.x());
  if (inwards.dot(in_plane(simplex.vertices[opposite].w) + in_plane(scene.shift) - from) < 0.0)
    inwards = -inwards;
  std::vector<Point> points;
  for (const Vector2d& corner : clip(scene.map.visible(), {from, inwards}))
    points.push_back(scene.at(corner));
  if (points.empty()) return;
  scene.area("wrong.area", points);
  scene.outline(points);
  const SimplexWords words(scene.run, simplex);
  const std::string condition = words.coordinate(simplex.all(), opposite) + " ≤ 0";
  scene.out.area_labels.push_back(
      {"short:" + condition, condition, "wrong.label", type::kSmallVertex, points, {}});
}

}  // namespace

const Layer kShortTest{.effect = gjkscope::RegionOrders::kName,
                       .on = Layer::On::every_view,
                       .order = 40,
                       .draw = short_test};

namespace {

void wrong_point(SceneBuilder& scene) {
  const RegionOrders::Chain* chain = chain_of(scene);
  if (!chain || chain->error == 0.0) return;
  const Point p = scene.at_difference(chain->p);
  const Point right = scene.at_difference(scene.state.p);
  const Point q = scene.at_difference(Vector2d::Zero());
  scene.line("wrong.line", p, q);
  scene.line("wrong.error", right, p);
  scene.disk("wrong", p, kPointRadius);
  scene.out.moving_labels.push_back(
      scene.label("P′", "P′", "wrong.label", type::kVertex, p, kPointRadius, p - q));
  scene.out.moving_labels.push_back(scene.label("error", Numbers(scene.run.lesson)(chain->error),
                                                "wrong.label", type::kSmallVertex,
                                                0.5 * (p + right), 4.0, p - q));
}

}  // namespace

const Layer kWrongPoint{.effect = gjkscope::RegionOrders::kName,
                        .on = Layer::On::every_view,
                        .order = 1011,
                        .draw = wrong_point};

}  // namespace gjkscope::layers
