#include "outlines/polygon.hpp"
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

}  // namespace

void strip(SceneBuilder& scene, const Vector2d& x, const Vector2d& y) {
  const Vector2d way = y - x;
  std::vector<Vector2d> seen = scene.map.visible();
  seen = clip(seen, {y, way});
  seen = clip(seen, {x, -way});
  std::vector<Point> area;
  for (const Vector2d& point : seen) area.push_back(scene.at(point));
  if (area.size() > 2) scene.area("slab", area);
  const double reach = (scene.map.visible()[2] - scene.map.visible()[0]).norm();
  const Vector2d along = reach * Vector2d(-way.y(), way.x()).normalized();
  for (const Vector2d& point : {x, y})
    scene.line("slab.side", scene.at(point - along), scene.at(point + along));
}

void stage(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (!shown.has_points()) return;
  const slab_proof::State& now = shown.state();
  if (shown.is(Phase::slab) || shown.is_answer) strip(scene, now.x, now.y);
  if (shown.is(Phase::slab)) {
    for (const Reach& reach : shown.step->reaches) {
      const auto& shape = reach.of_x ? scene.positioned.x().world : scene.positioned.y().world;
      scene.disk("slab.vertex", scene.at(shape[reach.vertex]), kSimplexRadius);
    }
  }
  if (shown.is(Phase::closer)) {
    const Reach& c = shown.step->towards;
    const Vector2d was = c.of_x ? shown.step->before.x : shown.step->before.y;
    const auto& shape = c.of_x ? scene.positioned.x().world : scene.positioned.y().world;
    const Vector2d corner = in_plane(shape[c.vertex]);
    scene.line("simplex.edge", scene.at(was), scene.at(corner));
    scene.disk("slab.vertex", scene.at(corner), kSimplexRadius);
    scene.disk("slab.was", scene.at(was), kClosestRadius);
    scene.line("slab.was.line", scene.at(was), scene.at(c.of_x ? now.y : now.x));
  }
  scene.line("closest.line", scene.at(now.x), scene.at(now.y));
  point(scene, "x", now.x, now.y);
  point(scene, "y", now.y, now.x);
  scene.length_label("distance", now.distance(), scene.at(now.x), scene.at(now.y));
}

}  // namespace gjkscope::slabs
