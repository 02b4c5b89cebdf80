#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "subjects/general_growth/shown.hpp"
#include "subjects/growth/choices.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::costs {
namespace {

using general_growth::Sample;
using namespace sizes;
using Times = std::vector<double> GrowthTimes::*;

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
  scene.length_label("distance", sample.answer.distance, x, y);
}

PlotSeries series(const Shown& shown, PlotStyle style, std::string name, double Sample::*counted) {
  PlotSeries out{style, std::move(name), {}};
  const int known = std::clamp(shown.over, 1, shown.sizes());
  for (int i = 0; i < known; ++i) {
    const Sample& sample = shown.trace.samples[i];
    if (sample.*counted >= 0.0) out.points.emplace_back(sample.segments, sample.*counted);
  }
  return out;
}

PlotSeries series(const Shown& shown, PlotStyle style, std::string name, Times times) {
  PlotSeries out{style, std::move(name), {}};
  const std::vector<double>& all = (*shown.trace.times).*times;
  for (std::size_t i = 0; i < all.size(); ++i)
    out.points.emplace_back(shown.trace.samples[i].segments, all[i]);
  return out;
}

double power_of_ten_from(double value) { return std::pow(10.0, std::ceil(std::log10(value))); }

Plot against_segments(const Shown& shown, double most, std::string title) {
  Plot plot;
  const double largest = shown.trace.samples.back().segments;
  plot.x = {10.0, std::max(100.0, power_of_ten_from(largest)), true, "segments n of each outline"};
  plot.y = {1.0, std::max(100.0, power_of_ten_from(most)), true, std::move(title)};
  if (shown.is(GrowthPhase::size)) plot.current = shown.sample().segments;
  return plot;
}

Plot times_plot(const Shown& shown) {
  const GrowthTimes& times = *shown.trace.times;
  Plot plot = against_segments(shown, times.pairs.back(), "nanoseconds for one distance");
  plot.y.low = 10.0;
  PlotSeries all = series(shown, PlotStyle::limit, "all n · n pairs", &GrowthTimes::pairs);
  all.has_symbols = false;
  plot.series = {
      series(shown, PlotStyle::first, "boxes", &GrowthTimes::boxes),
      series(shown, PlotStyle::second, "circles", &GrowthTimes::circles),
      series(shown, PlotStyle::third, "boxes, from the last pair", &GrowthTimes::remembered),
      series(shown, PlotStyle::fourth, "convex pieces", &GrowthTimes::pieces), std::move(all)};
  return plot;
}

/// The places that a question about a size chooses from; the frame that tells keeps them.
void add_choices(Plot& plot, const Lesson& lesson, const Shown& shown, bool is_asked) {
  const std::size_t size = shown.size() + (is_asked ? 1 : 0);
  const bool is_shown = lesson.asks(kAskVisits.name, static_cast<long>(size) + 1);
  if (!shown.is(GrowthPhase::size) || size == 0 || !(is_asked || is_shown)) return;
  const Sample& before = shown.trace.samples[size - 1];
  const Sample& sample = shown.trace.samples[size];
  add_choices(plot, sample.segments, before.boxes, growth_choices(before, sample));
}

Plot visits_plot(const Shown& shown) {
  Plot plot = against_segments(shown, shown.trace.samples.back().pairs(), "pairs visited");
  PlotSeries all{PlotStyle::limit, "all n · n pairs", {}, PlotJoin::lines, false};
  for (const Sample& sample : shown.trace.samples) {
    if (sample.segments <= shown.sample().segments)
      all.points.emplace_back(sample.segments, sample.pairs());
  }
  plot.series = {series(shown, PlotStyle::first, "boxes", &Sample::boxes),
                 series(shown, PlotStyle::second, "circles", &Sample::circles),
                 series(shown, PlotStyle::third, "boxes, from the last pair", &Sample::remembered),
                 series(shown, PlotStyle::fourth, "convex pieces", &Sample::pieces),
                 std::move(all)};
  return plot;
}

}  // namespace

bool fill(SceneBuilder& scene, const Fonts& fonts) {
  const Shown& shown = shown_in<Shown>(scene);
  if (scene.view.kind == ViewKind::plot) {
    Plot plot = shown.plots_times() ? times_plot(shown) : visits_plot(shown);
    add_choices(plot, scene.run.lesson, shown,
                scene.frame.question >= 0 && scene.run.asked(scene.frame).ask == kAskVisits.name);
    layers::add_plot(scene, plot, fonts);
  } else {
    example(scene, shown);
  }
  return true;
}

}  // namespace gjkscope::costs
