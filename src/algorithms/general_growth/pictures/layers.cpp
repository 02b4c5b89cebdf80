#include "picture/layers/layers.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "algorithms/general_growth/pictures/shown.hpp"
#include "picture/stage.hpp"

namespace gjkscope::costs {
namespace {

using general_growth::Sample;
using namespace sizes;

constexpr std::size_t kMostDrawn = 700;  // points of an outline: more are thinned evenly

/// The first pair of the frame's size.
void example(SceneBuilder& scene, const Shown& shown) {
  const Sample& sample = shown.sample();
  Eigen::AlignedBox2d seen;
  for (const models::Model* model : {&sample.x, &sample.y}) {
    for (const models::Point& point : model->outlines[0].points) seen.extend(point);
  }
  const StageMap map(scene.map.area(), camera_around(seen, scene.map.area()));
  for (const models::Model* model : {&sample.x, &sample.y}) {
    std::vector<Point> line;
    const std::vector<models::Point>& points = model->outlines[0].points;
    const std::size_t every = 1 + points.size() / kMostDrawn;
    for (std::size_t i = 0; i < points.size(); i += every) line.push_back(map(points[i]));
    scene.add(model == &sample.x ? "shape.x" : "shape.y", Polyline{std::move(line), true});
  }
  const Point x = map(sample.answer.a);
  const Point y = map(sample.answer.b);
  scene.line("closest.line", x, y);
  for (const Point& point : {x, y}) scene.disk("closest", point, kClosestRadius);
  layers::length_label(scene, "distance", sample.answer.distance, x, y);
}

PlotSeries series(const Shown& shown, PlotStyle style, std::string name, double Sample::*counted) {
  PlotSeries out{style, std::move(name), {}};
  const int known = std::clamp(shown.over, 1, shown.sizes());
  for (int i = 0; i < known; ++i) {
    const Sample& sample = shown.told.samples[static_cast<std::size_t>(i)];
    if (sample.*counted >= 0.0) out.points.emplace_back(sample.segments, sample.*counted);
  }
  return out;
}

void plot(SceneBuilder& scene, const Shown& shown, const Fonts& fonts) {
  Plot plot;
  const Sample& last = shown.told.samples.back();
  const auto end = [](double value) { return std::pow(10.0, std::ceil(std::log10(value))); };
  plot.x = {10.0, std::max(100.0, end(last.segments)), true, "segments n of each outline"};
  plot.y = {1.0, std::max(100.0, end(last.pairs())), true, ""};
  if (shown.is_size()) plot.current = shown.sample().segments;
  PlotSeries all{PlotStyle::limit, "all n · n pairs", {}, PlotJoin::lines, false};
  for (const Sample& sample : shown.told.samples) {
    if (sample.segments <= shown.sample().segments)
      all.points.emplace_back(sample.segments, sample.pairs());
  }
  plot.series = {series(shown, PlotStyle::first, "boxes", &Sample::boxes),
                 series(shown, PlotStyle::second, "circles", &Sample::circles),
                 series(shown, PlotStyle::third, "boxes, from the last pair", &Sample::remembered),
                 series(shown, PlotStyle::fourth, "convex pieces", &Sample::pieces),
                 std::move(all)};
  layers::add_plot(scene, plot, fonts);
}

}  // namespace

bool fill(SceneBuilder& scene, const Fonts& fonts) {
  const Shown shown(scene.run, scene.frame);
  scene.view.kind == ViewKind::plot ? plot(scene, shown, fonts) : example(scene, shown);
  return true;
}

}  // namespace gjkscope::costs
