#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "gjk/vector.hpp"
#include "outlines/polygon.hpp"
#include "picture/words.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/slab_proof/shown.hpp"

namespace gjkscope::slabs {
namespace {

using Eigen::Vector2d;
using slab_proof::Phase;
using slab_proof::Reach;
using namespace sizes;

void point(SceneBuilder& scene, const std::string& name, const Vector2d& at,
           const Vector2d& other) {
  const Point there = scene.at(at);
  scene.disk("slab.point", there, kClosestRadius);
  scene.out.moving_labels.push_back(scene.label("slab:" + name, name, "closest.label",
                                                type::kVertex, there, kClosestRadius,
                                                there - scene.at(other)));
}

/// The angle at `corner` between the ways to two points, with its degrees.
void angle(SceneBuilder& scene, const Point& corner, const Point& one, const Point& other,
           double degrees) {
  constexpr double kRadius = 34.0;
  constexpr int kParts = 16;
  const Point from = (one - corner).normalized();
  const Point to = (other - corner).normalized();
  Polyline arc;
  for (int i = 0; i <= kParts; ++i) {
    const double share = 1.0 * i / kParts;
    arc.points.push_back(corner + kRadius * ((1.0 - share) * from + share * to).normalized());
  }
  scene.add("slab.angle", std::move(arc));
  const Point middle = corner + kRadius * (from + to).normalized();
  scene.out.moving_labels.push_back(scene.label("slab:angle", fmt::format("{}°", fixed(degrees, 0)),
                                                "closest.label", type::kName, middle, 2.0,
                                                from + to));
}

}  // namespace

double degrees_between(const Vector2d& a, const Vector2d& b) {
  const double turned = a.x() * b.y() - a.y() * b.x();
  return std::abs(std::atan2(turned, gjk::dot(a, b))) * 180.0 / std::numbers::pi;
}

void strip(SceneBuilder& scene, const Vector2d& x, const Vector2d& y) {
  const Vector2d difference = y - x;
  std::vector<Vector2d> seen = scene.map.visible();
  seen = clip(seen, {y, difference});
  seen = clip(seen, {x, -difference});
  std::vector<Point> area;
  for (const Vector2d& point : seen) area.push_back(scene.at(point));
  if (area.size() > 2) scene.area("slab", area);
  const double reach = (scene.map.visible()[2] - scene.map.visible()[0]).norm();
  const Vector2d along = reach * Vector2d(-difference.y(), difference.x()).normalized();
  for (const Vector2d& point : {x, y})
    scene.line("slab.side", scene.at(point - along), scene.at(point + along));
}

void stage(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (!shown.has_points()) return;
  const slab_proof::State& now = shown.state();
  const bool asks_for_vertex =
      scene.frame.question >= 0 && scene.run.asked(scene.frame).ask == kAskVertex.name;
  if (shown.is(Phase::slab) || shown.is_answer || asks_for_vertex) strip(scene, now.x, now.y);
  if (shown.is(Phase::slab)) {
    for (const Reach& reach : shown.step->reaches) {
      const auto& shape = reach.of_x ? scene.positioned.x().world : scene.positioned.y().world;
      scene.disk("slab.vertex", scene.at(shape[reach.vertex]), kSimplexRadius);
    }
  }
  if (shown.is(Phase::closer) && !asks_for_vertex) {
    const Reach& c = shown.step->towards;
    const Vector2d was = c.of_x ? shown.step->before.x : shown.step->before.y;
    const auto& shape = c.of_x ? scene.positioned.x().world : scene.positioned.y().world;
    const Vector2d corner = in_plane(shape[c.vertex]);
    const Vector2d other = c.of_x ? now.y : now.x;
    strip(scene, shown.step->before.x, shown.step->before.y);
    angle(scene, scene.at(was), scene.at(corner), scene.at(other),
          degrees_between(corner - was, other - was));
    scene.line("simplex.edge", scene.at(was), scene.at(corner));
    scene.disk("slab.vertex", scene.at(corner), kSimplexRadius);
    scene.disk("slab.was", scene.at(was), kClosestRadius);
    scene.line("slab.was.line", scene.at(was), scene.at(other));
  }
  scene.line("closest.line", scene.at(now.x), scene.at(now.y));
  point(scene, "x", now.x, now.y);
  point(scene, "y", now.y, now.x);
  scene.length_label("distance", now.distance(), scene.at(now.x), scene.at(now.y));
}

}  // namespace gjkscope::slabs
