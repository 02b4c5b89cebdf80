#include <algorithm>

#include "effects/minkowski.hpp"
#include "picture/layers/layers.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

/// How many differences have been made by this frame.
int pairs_made(const SceneBuilder& scene, int all) {
  return std::min(scene.frame.pairs.value_or(all), all);
}
bool hull_is_shown(const SceneBuilder& scene, int all) {
  return !scene.frame.pairs || *scene.frame.pairs > all;
}

/// An arrow that is there for one frame.
void difference_arrow(SceneBuilder& scene, const Point& from, const Point& to) {
  scene.add("difference.arrow", Arrow{from, to});
  scene.out.obstacles.passing.push_back({from, to});
}

void difference(SceneBuilder& scene) {
  const bool wants_hull = scene.shows(MinkowskiHull::kName);
  const bool wants_cloud = scene.shows(MinkowskiCloud::kName);
  if (!wants_hull && !wants_cloud) return;
  const int all =
      static_cast<int>(scene.positioned.x().world.size() * scene.positioned.y().world.size());
  const bool names_all = all <= 12 && scene.frame.pairs;
  if (wants_hull && hull_is_shown(scene, all)) {
    const MinkowskiCloud::Value& cloud = scene.effects.get<MinkowskiCloud>(scene.frame);
    const MinkowskiHull::Value& hull = scene.effects.get<MinkowskiHull>(scene.frame);
    std::vector<Point> points;
    for (const int index : hull) points.push_back(scene.at(cloud[index].z));
    // While a run is followed Z is what GJK does without.
    const bool is_ghost = scene.run.act->follows_run || scene.frame.support_part;
    scene.area(is_ghost ? "hull.ghost" : "hull", points, {Subject::Kind::difference});
    scene.outline(points);
  }
  if (wants_cloud && pairs_made(scene, all) > 0) {
    const MinkowskiCloud::Value& cloud = scene.effects.get<MinkowskiCloud>(scene.frame);
    const int made = pairs_made(scene, all);
    Point middle = Point::Zero();
    for (const CloudPoint& point : cloud) middle += scene.at(point.z) / static_cast<double>(all);
    for (int i = 0; i < made; ++i) {
      const Point point = scene.at(cloud[i].z);
      scene.disk("cloud.point", point, kCloudRadius,
                 {Subject::Kind::difference_vertex, cloud[i].pair.x, cloud[i].pair.y});
      if (names_all) {
        const std::string name = scene.run.pair_name(cloud[i].pair);
        LabelRequest label = scene.label("cloud:" + name, name, "cloud.label", type::kSmallVertex,
                                         point, kCloudRadius, point - middle);
        label.steps_aside = true;
        scene.out.fixed_labels.push_back(std::move(label));
      }
    }
  }
}

}  // namespace

const Layer kDifference{.effect = {}, .on = Layer::On::difference, .order = 70, .draw = difference};

void pair_under_construction(SceneBuilder& scene) {
  const int all =
      static_cast<int>(scene.positioned.x().world.size() * scene.positioned.y().world.size());
  const int made = *scene.frame.pairs;
  if (made > all) {
    if (scene.view.kind == ViewKind::difference) {
      scene.line("closest.line", scene.at(Vector2d::Zero()),
                 scene.at(scene.positioned.trace.result.y - scene.positioned.trace.result.x));
      scene.disk("closest",
                 scene.at(scene.positioned.trace.result.y - scene.positioned.trace.result.x),
                 kClosestRadius);
    } else {
      scene.line("closest.line", scene.at(scene.positioned.trace.result.x),
                 scene.at(scene.positioned.trace.result.y));
      scene.disk("closest", scene.at(scene.positioned.trace.result.x), kClosestRadius);
      scene.disk("closest", scene.at(scene.positioned.trace.result.y), kClosestRadius);
    }
    return;
  }
  if (made < 1) return;
  const int per_x = static_cast<int>(scene.positioned.y().world.size());
  const gjk::VertexPair pair{(made - 1) / per_x, (made - 1) % per_x};
  const Vector2d x = scene.positioned.x().world[pair.x];
  const Vector2d y = scene.positioned.y().world[pair.y];
  if (scene.view.kind == ViewKind::world) {
    difference_arrow(scene, scene.at(x), scene.at(y));
    scene.disk("cloud.current", scene.at(x), kSimplexRadius);
    scene.disk("cloud.current", scene.at(y), kSimplexRadius);
  } else {
    difference_arrow(scene, scene.at(Vector2d::Zero()), scene.at(y - x));
    scene.disk("cloud.current", scene.at(y - x), kSimplexRadius);
  }
}

namespace {

void corner_names(SceneBuilder& scene) {
  const Lesson& lesson = scene.run.lesson;
  // Where shapes turn, corners come and go; those of the simplex are named in any case.
  const bool turns = lesson.path_of_shapes && (!lesson.path_of_shapes->x().turns.empty() ||
                                               !lesson.path_of_shapes->y().turns.empty());
  if (scene.frame.pairs || turns) return;
  const MinkowskiCloud::Value& cloud = scene.effects.get<MinkowskiCloud>(scene.frame);
  const MinkowskiHull::Value& hull = scene.effects.get<MinkowskiHull>(scene.frame);
  constexpr std::size_t kMostNames = 16;  // more would hide what they name
  if (hull.size() > kMostNames) return;
  Point middle = Point::Zero();
  for (const int index : hull)
    middle += scene.at(cloud[index].z) / static_cast<double>(hull.size());
  for (const int index : hull) {
    const std::string name = scene.run.pair_name(cloud[index].pair);
    const Point point = scene.at(cloud[index].z);
    LabelRequest label = scene.label("cloud:" + name, name, "cloud.label", type::kSmallVertex,
                                     point, sizes::kSimplexRadius, point - middle);
    label.steps_aside = true;
    auto& labels = scene.labels_of_difference();
    const bool named = std::any_of(labels.begin(), labels.end(),
                                   [&](const auto& other) { return other.id == label.id; });
    if (!named) labels.push_back(label);
  }
}

}  // namespace

const Layer kCornerNames{.effect = gjkscope::MinkowskiHull::kName,
                         .on = Layer::On::every_view,
                         .order = 1030,
                         .draw = corner_names};

}  // namespace gjkscope::layers
