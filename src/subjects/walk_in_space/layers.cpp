#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/feature_regions/drawing.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/walk_in_space/growth.hpp"
#include "subjects/walk_in_space/shown.hpp"

namespace gjkscope::space_walks {
namespace {

using cells::Feature;

/// The region that the step is about; before its body if it faces the eye, else behind it.
void region(SceneBuilder& scene, const Shown& shown, bool in_front) {
  if (!shown.is_step() || shown.trace.overlaps()) return;
  const SpaceWalk::Step& step = shown.step();
  const Feature& feature = shown.trace.feature(step);
  if ((scene.map.towards_eye(feature.outwards) > 0.0) != in_front) return;
  const std::vector<Eigen::Vector3d>& points = scene.positioned.bodies[step.body].world;
  // Beyond the point, unless it is so far off that the region would fill the picture.
  constexpr double kBeyond = 1.15;
  const double reach = kBeyond * std::min(step.distance(), cells::radius_of(points));
  const SolidPart part = cells::region_of(feature, shown.trace.features[step.body], points, reach);
  if (!part.points.empty())
    draw_solid(scene, part.hull, part.points, step.body == 0 ? "cell.x" : "cell.y");
}

/// The border that the point lies beyond, and the features that are next.
void move_of_pair(SceneBuilder& scene, const Shown& shown) {
  const SpaceWalk::Step& step = shown.step();
  if (shown.trace.beyond(step) > 0.0)
    cells::draw_refuting_plane(scene, shown.trace.border(step), step.points[step.body],
                               step.points[1 - step.body],
                               cells::radius_of(scene.positioned.bodies[step.body].world));
  for (const std::size_t body : {0, 1}) {
    if (step.next[body] == step.at[body]) continue;
    const Feature& next = shown.trace.features[body][step.next[body]];
    cells::draw_neighbour(scene, body, next);
    if (next.kind() == cells::Kind::face)
      scene.add("cell.beside", Polyline{cells::corners_of(scene, body, next), true});
  }
}

}  // namespace

const Layer kBehind{
    .effect = {}, .on = Layer::On::world, .order = 50, .draw = [](SceneBuilder& scene) {
      if (scene.run.tour->algorithm == &kWalkInSpaceAlgorithm)
        region(scene, Shown(scene.run, scene.frame), false);
    }};

bool fill(SceneBuilder& scene, const Fonts& fonts) {
  const std::optional<WalkGrowing> growing = growth_of(scene.run, scene.frame);
  if (scene.view.kind != ViewKind::plot && !growing) return false;
  layers::add_plot(
      scene,
      space_walk_plot(growing.value_or(WalkGrowing::beside_gjk), scene.frame.question >= 0,
                      scene.effects.get<SpaceWalkGrowth>(scene.frame)),
      fonts);
  return true;
}

void stage(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  if (scene.view.kind != ViewKind::world || shown.trace.all.empty()) return;
  region(scene, shown, true);
  const SpaceWalk::Step& step = shown.step();
  for (const std::size_t body : {0, 1})
    cells::draw_feature(scene, body, shown.trace.features[body][step.at[body]]);
  if (shown.index < 0) return;
  if (shown.is_step() && !shown.asks && step.moves()) move_of_pair(scene, shown);
  if (shown.trace.overlaps() && step.distance() == 0.0)
    return cells::draw_pair(scene, step.points, "closest.line", {"x = y", ""});
  cells::draw_pair(scene, step.points, "closest.line", {"x", "y"});
}

}  // namespace gjkscope::space_walks
