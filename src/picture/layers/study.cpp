#include <fmt/format.h>

#include "effects/worst_pair.hpp"
#include "geometry/polygon.hpp"
#include "picture/layers/layers.hpp"
#include "picture/stage.hpp"
#include "picture/study_plot.hpp"

namespace gjkscope::layers {

void study(SceneBuilder& scene, const Fonts& fonts) {
  const LessonStudy& shown = *scene.run.lesson.study;
  Plot plot = study_plot(of_family(shown.dots, shown.family));
  const auto index = static_cast<std::size_t>(scene.frame.detail);
  if (scene.frame.detail >= 0 && index < shown.configurations.size()) {
    const StudyDot& dot = shown.dot(shown.configurations[index]);
    if (dot.error) {
      plot.current_point = place_of(dot);
      plot.notes = {{style_of(dot), place_of(dot), dot.configuration}};
    }
  }
  add_plot(scene, plot, fonts);
}

void worst_pair(SceneBuilder& scene) {
  using namespace sizes;
  const LessonStudy& shown = *scene.run.lesson.study;
  const StudyDot& dot =
      shown.dot(shown.configurations[static_cast<std::size_t>(scene.frame.detail)]);
  const WorstPair::Value& pair = scene.effects.get<WorstPair>(scene.frame);
  Eigen::AlignedBox2d seen;
  for (const auto* corners : {&pair.x, &pair.y}) {
    for (const Eigen::Vector2d& corner : *corners) seen.extend(corner);
  }
  const StageMap map(scene.map.area(), camera_around(seen, scene.map.area()));
  const auto draw = [&](const std::vector<Eigen::Vector2d>& corners, const std::string& role,
                        const std::string& name) {
    std::vector<Point> points;
    for (const Eigen::Vector2d& corner : corners) points.push_back(map(corner));
    if (points.size() > 1) scene.area(role, points);
    scene.outline(points);
    for (const Point& point : points) scene.disk(role + ".vertex", point, kVertexRadius);
    const Point middle = centroid(points);
    scene.out.moving_labels.push_back(
        scene.label("worst " + name, name, role + ".label", type::kVertex, middle, 0.0, {0, -1}));
  };
  draw(pair.x, "shape.x", scene.run.lesson.x.name);
  draw(pair.y, "shape.y", scene.run.lesson.y.name);
  scene.line("closest.line", map(pair.on_x), map(pair.on_y));
  for (const Eigen::Vector2d& point : {pair.on_x, pair.on_y})
    scene.disk("closest", map(point), kSimplexRadius);
  const Rect& card = scene.map.area();
  scene.add("body.muted",
            Text{{card.min.x() + 14.0, card.max.y() - 14.0},
                 fmt::format("the worst of {} pairs for: {}", dot.pairs, dot.configuration),
                 type::kBody});
}

}  // namespace gjkscope::layers
