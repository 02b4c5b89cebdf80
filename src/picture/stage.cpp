#include "picture/stage.hpp"

#include <algorithm>

#include "effects/balance.hpp"
#include "effects/barycentric.hpp"
#include "effects/history.hpp"
#include "effects/motion.hpp"
#include "effects/projection.hpp"
#include "effects/region_orders.hpp"
#include "effects/second_run.hpp"
#include "effects/shape_hull.hpp"
#include "effects/sign_map.hpp"
#include "effects/slab.hpp"
#include "effects/touched_points.hpp"
#include "effects/voronoi.hpp"
#include "picture/layers/layers.hpp"

namespace gjkscope {

using Eigen::Vector2d;

Camera camera_around(const Eigen::AlignedBox2d& box, const Rect& area) {
  constexpr double kSide = 64.0;
  constexpr double kTop = 64.0;
  constexpr double kBottom = 52.0;
  const Vector2d room = area.size() - Vector2d(2.0 * kSide, kTop + kBottom);
  const Vector2d extent = box.sizes();
  double scale = std::min(extent.x() > 0.0 ? room.x() / extent.x() : 1e300,
                          extent.y() > 0.0 ? room.y() / extent.y() : 1e300);
  if (scale >= 1e300) scale = room.y();
  Camera camera;
  camera.height = area.size().y() / scale;
  camera.center = 0.5 * (box.min() + box.max()) + Vector2d(0.0, 0.5 * (kTop - kBottom) / scale);
  return camera;
}

Camera camera_of(const LessonRun& run, const LessonView& view, const Rect& area) {
  if (view.camera) {
    // On a page narrower than the usual one the height gives way, so that nothing is cut off at the
    // sides.
    const double usual_aspect = run.lesson.views.size() == 1 ? 1.8 : 0.95;
    Camera camera = *view.camera;
    camera.height *= std::max(1.0, usual_aspect * area.size().y() / area.size().x());
    return camera;
  }
  Eigen::AlignedBox2d seen;
  for (const PositionedRun& positioned : run.runs) {
    Eigen::AlignedBox2d x;
    Eigen::AlignedBox2d y;
    for (const Vector2d& vertex : positioned.x_world) x.extend(vertex);
    for (const Vector2d& vertex : positioned.y_world) y.extend(vertex);
    const bool is_world = view.kind == ViewKind::world;
    if (is_world) seen.extend(x).extend(y);
    if (is_world && !calls_for(view, GrownObstacle::kName)) continue;
    const Vector2d shift = is_world ? positioned.x.translate : Vector2d(0.0, 0.0);
    seen.extend(shift);
    seen.extend(y.min() - x.max() + shift).extend(y.max() - x.min() + shift);
  }
  return camera_around(seen, area);
}

Scene stage_scene(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                  const LessonView& view, const StageMap& map, const Fonts& fonts) {
  SceneBuilder scene(run, effects, frame, view, map);
  if (view.kind == ViewKind::growth) {
    layers::growth(scene, fonts);
    return std::move(scene.out);
  }
  if (view.kind == ViewKind::study) {
    layers::study(scene, fonts);
    return std::move(scene.out);
  }
  if (run.lesson.granularity == Granularity::growth && frame.detail >= 0 &&
      view.kind == ViewKind::difference) {
    layers::growth_example(scene);
    return std::move(scene.out);
  }
  if (scene.shows(VoronoiRegions::kName)) layers::regions(scene);
  if (scene.shows(SignMap::kName)) layers::signs(scene);
  if (scene.shows(MapDifference::kName)) layers::map_difference(scene);
  if (scene.shows(RegionOrders::kName)) layers::short_test(scene);
  if (view.kind == ViewKind::world) {
    if (calls_for(view, ShapeHull::kName)) layers::shape_hull(scene);
    layers::shapes(scene);
  }
  if (view.kind == ViewKind::difference) layers::difference(scene);
  if (calls_for(view, Projection::kName)) layers::projection(scene);
  if (calls_for(view, BarycentricParts::kName)) layers::parts(scene);
  if (calls_for(view, UnitVector::kName)) layers::unit_vector(scene);
  if (calls_for(view, Balance::kName)) layers::balance(scene);
  if (calls_for(view, GrownObstacle::kName)) layers::grown_obstacle(scene);
  if (calls_for(view, LastPosition::kName)) layers::last_position(scene);
  if (calls_for(view, Slab::kName)) layers::slab(scene);
  if (calls_for(view, TouchedPoints::kName)) layers::touched_points(scene);
  const bool shows_last = calls_for(view, LastPosition::kName);  // arrows, in place of a way
  if (run.lesson.path_of_shapes && view.kind == ViewKind::world && !shows_last) layers::path(scene);
  const Granularity granularity = run.lesson.granularity;
  if (granularity == Granularity::pairs) {
    layers::pair_under_construction(scene);
  } else if (granularity == Granularity::support && frame.detail >= 0) {
    layers::support_in_parts(scene);
  } else if (granularity == Granularity::answer || granularity == Granularity::witness ||
             granularity == Granularity::study) {
    layers::answer(scene);
  } else {
    if (scene.shows_difference && !calls_for(view, Slab::kName)) layers::best_support_line(scene);
    if (calls_for(view, History::kName)) layers::history(scene);
    layers::simplex(scene);
    if (scene.shows_difference) {
      layers::closest_line(scene);
      if (calls_for(view, SecondRun::kName)) layers::second_run(scene);
      layers::search(scene);
      layers::closest_point(scene);
    } else {
      layers::witness_points(scene);
      layers::search_between_shapes(scene);
    }
  }
  if (scene.shows(RegionOrders::kName)) layers::wrong_point(scene);
  layers::query_point(scene);
  if (calls_for(view, MinkowskiHull::kName)) layers::corner_names(scene);
  return std::move(scene.out);
}

}  // namespace gjkscope
