#include "subjects/growth/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "subjects/growth/growth.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope {
namespace {

using Sample = Growth::Sample;

double power_of_ten_from(double value) { return std::pow(10.0, std::ceil(std::log10(value))); }

/// A plot without series: n along x, and the frame's n.
Plot against_vertices(const LessonRun& run, const Frame& frame) {
  const std::vector<int>& sizes = run.lesson.settings.as<LessonGrowth>()->vertices;
  Plot plot;
  plot.x = {1.0, power_of_ten_from(sizes.back()), true, "vertices n of each polygon"};
  const int size = shown_size(run, frame).value_or(-1);
  if (size >= 0 && size < static_cast<int>(sizes.size())) plot.current = sizes[size];
  return plot;
}

/// Up to the frame's n: what comes is the question. The outcome shows them all.
std::span<const Sample> measured_by(const LessonRun& run, EffectGraph& effects,
                                    const Frame& frame) {
  const std::span<const Sample> all(effects.get<Growth>(frame));
  const int size = shown_size(run, frame).value_or(-1);
  return all.first(std::min(all.size(), static_cast<std::size_t>(size + 1)));
}

template <class Number>
PlotSeries series_of(std::span<const Sample> measured, PlotStyle style, std::string name,
                     Number Sample::*counted) {
  PlotSeries series{style, std::move(name), {}};
  for (const Sample& sample : measured)
    series.points.emplace_back(sample.vertices, sample.*counted);
  return series;
}

/// The size whose iterations a frame asks about, or tells; 0 where there is none.
int size_in_question(const LessonRun& run, const Frame& frame) {
  const int size = shown_size(run, frame).value_or(-1) + (frame.question >= 0 ? 1 : 0);
  const bool is_asked = run.lesson.asks(kAskIterations.name, size + 1);
  const auto sizes = static_cast<int>(run.lesson.settings.as<LessonGrowth>()->vertices.size());
  return is_asked && size > 0 && size < sizes ? size : 0;
}

/// The places that a frame's question chooses from; a frame that tells of a size keeps them.
void add_choices(Plot& plot, const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  const LessonGrowth& growth = *run.lesson.settings.as<LessonGrowth>();
  if (const int size = size_in_question(run, frame); size > 0) {
    add_choices(plot, growth.vertices[size], effects.get<Growth>(frame)[size - 1].iterations,
                growth_choices(growth, size, kAskIterations.name));
  } else if (is_slow(run, frame) && frame.question >= 0) {
    const Slowest both = slowest(effects, frame);
    add_choices(plot, both.built.vertices, both.random.most_iterations, slow_choices(both));
  }
}

}  // namespace

std::array<GrowthChoice, 3> growth_choices(const LessonGrowth& growth, int size,
                                           std::string_view counted) {
  constexpr double kLittle = 1.2;
  const double n = 1.0 * growth.vertices[size] / growth.vertices[size - 1];
  if (counted != kAskIterations.name)
    return {{{"a little", kLittle}, {"like n", n}, {"like n · n", n * n}}};
  return {{{"a little", kLittle}, {"twice as many", 2.0}, {"like n", n}}};
}

Slowest slowest(EffectGraph& effects, const Frame& frame) {
  const SlowGrowth::Value& built = effects.get<SlowGrowth>(frame);
  return {effects.get<Growth>(frame)[built.size() - 1], built.back()};
}

std::array<GrowthChoice, 3> slow_choices(const Slowest& slowest) {
  constexpr double kLittle = 1.2;
  return {{{"a few more", kLittle},
           {"twice as many", 2.0},
           {"like n", 1.0 * slowest.built.vertices / slowest.random.most_iterations}}};
}

Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  const std::span<const Sample> measured = measured_by(run, effects, frame);
  const LessonGrowth& growth = *run.lesson.settings.as<LessonGrowth>();
  Plot plot = against_vertices(run, frame);
  plot.bands = {{Growth::kLarsenLeast, Growth::kLarsenMost,
                 fmt::format("Larsen: {} to {}", Growth::kLarsenLeast, Growth::kLarsenMost)}};
  plot.series = {series_of(measured, PlotStyle::first, "iterations", &Sample::iterations),
                 series_of(measured, PlotStyle::second, "the worst run", &Sample::most_iterations),
                 series_of(measured, PlotStyle::third,
                           fmt::format("iterations to {:g} %", 100.0 * growth.tolerance),
                           &Sample::within_tolerance)};
  if (is_slow(run, frame) && frame.question < 0) {
    PlotSeries built{PlotStyle::fourth, "built to be slow", {}};
    for (const SlowGrowth::Run& each : effects.get<SlowGrowth>(frame))
      built.points.emplace_back(each.vertices, each.iterations);
    plot.series.push_back(std::move(built));
  }
  add_choices(plot, run, effects, frame);
  double most = effects.get<Growth>(frame).back().most_iterations;
  for (const PlotSeries& series : plot.series) {
    for (const Eigen::Vector2d& point : series.points) most = std::max(most, point.y());
  }
  constexpr double kStep = 4.0;  // the axis ends at a multiple
  plot.y = {0.0, kStep * std::ceil(most / kStep), false,
            fmt::format("average of {} runs; green: Larsen's {} to {}", growth.runs,
                        Growth::kLarsenLeast, Growth::kLarsenMost)};
  return plot;
}

Plot points_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  const std::span<const Sample> measured = measured_by(run, effects, frame);
  Plot plot = against_vertices(run, frame);
  const double largest = run.lesson.settings.as<LessonGrowth>()->vertices.back();
  plot.y = {1.0, power_of_ten_from(largest * largest), true, ""};
  PlotSeries all{PlotStyle::fourth, "n · n differences", {}};
  for (const Sample& sample : measured)
    all.points.emplace_back(sample.vertices, 1.0 * sample.vertices * sample.vertices);
  plot.series = {series_of(measured, PlotStyle::first, "computed by GJK", &Sample::touched_points),
                 series_of(measured, PlotStyle::second, "scanned", &Sample::scanned_vertices),
                 series_of(measured, PlotStyle::third, "climbed", &Sample::seen_vertices),
                 std::move(all)};
  PlotSeries edges{PlotStyle::limit, "edges of Z", {}, PlotJoin::lines, false};
  for (const Sample& sample : measured)
    edges.points.emplace_back(sample.vertices, 2.0 * sample.vertices);
  plot.series.push_back(std::move(edges));
  return plot;
}

}  // namespace gjkscope
