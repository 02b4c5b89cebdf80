#include <fmt/format.h>

#include <algorithm>

#include "picture/words.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/growth/plots.hpp"
#include "subjects/growth/subject.hpp"

namespace gjkscope::layers {

void add_plot(SceneBuilder& scene, const Plot& plot, const Fonts& fonts) {
  constexpr double kTitle = 46.0;  // of the view
  constexpr double kMargin = 14.0;
  const Rect& card = scene.map.area();
  const Rect area{card.min + Point(kMargin, kTitle), card.max - Point(kMargin, 0.5 * kMargin)};
  for (Mark& mark : plot_marks(plot, fonts, area)) scene.out.marks.push_back(std::move(mark));
}

void growth(SceneBuilder& scene, const Fonts& fonts) {
  add_plot(scene, iterations_plot(scene.run, scene.effects, scene.frame), fonts);
}

void growth_example(SceneBuilder& scene) {
  using namespace sizes;
  const bool is_built = is_slow(scene.run, scene.frame) && scene.frame.question < 0;
  const Growth::Value& measured = scene.effects.get<Growth>(scene.frame);
  const auto index = static_cast<std::size_t>(*shown_size(scene.run, scene.frame));
  const Growth::Sample& sample = measured[std::min(index, measured.size() - 1)];
  const Growth::Example built =
      is_built ? SlowGrowth::example(SlowGrowth::kDrawn) : Growth::Example{};
  const Growth::Example& example = is_built ? built : sample.example;
  Eigen::AlignedBox2d seen(Eigen::Vector2d(0.0, 0.0));
  for (const Eigen::Vector2d& corner : example.hull) seen.extend(corner);
  constexpr double kBand = 26.0;  // for words, at the lower edge
  const Rect& card = scene.map.area();
  const Rect area{card.min, card.max - Point(0.0, kBand)};
  const StageMap map(area, camera_around(seen, area));
  const auto mapped = [&](const std::vector<Eigen::Vector2d>& points) {
    std::vector<Point> out;
    for (const Eigen::Vector2d& point : points) out.push_back(map(point));
    return out;
  };
  const std::vector<Point> hull = mapped(example.hull);
  scene.area("hull", hull);
  scene.outline(hull);
  for (const Point& point : mapped(example.cloud)) scene.disk("cloud.point", point, kCloudRadius);
  const Point o = map(Eigen::Vector2d(0.0, 0.0));
  const Point p = map(example.closest);
  scene.line("closest.line", o, p);
  for (const Point& point : mapped(example.touched))
    scene.disk("cloud.touched", point, kTouchedRadius);
  // The order in which they are found, as long as they are apart.
  constexpr int kNumbered = 4;
  for (int i = 0; is_built && i < kNumbered; ++i) {
    const Point at = map(example.touched[i]);
    scene.out.moving_labels.push_back(scene.label(fmt::format("example {}", i),
                                                  std::to_string(i + 1), "cloud.label", type::kName,
                                                  at, kTouchedRadius, at - p));
  }
  scene.disk("closest", p, kClosestRadius);
  scene.add("origin", Cross{o, kOriginRadius});
  scene.out.obstacles.circles.push_back({o, kOriginRadius});
  scene.add(
      "body.muted",
      Text{{card.min.x() + 14.0, card.max.y() - 14.0},
           is_built ? fmt::format("built to be slow, n = {}", SlowGrowth::kDrawn)
                    : fmt::format("run 1 of {}, n = {}", sample.runs, grouped(sample.vertices)),
           type::kBody});
  scene.out.moving_labels.push_back(
      scene.label("example O", "O", "origin.label", type::kVertex, o, kOriginRadius, o - p));
  scene.out.moving_labels.push_back(
      scene.label("example P", "P", "closest.label", type::kVertex, p, kClosestRadius, p - o));
}

}  // namespace gjkscope::layers
