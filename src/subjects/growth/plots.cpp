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
  const std::vector<int>& sizes = run.lesson.table.as<LessonGrowth>()->vertices;
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

PlotSeries series_of(std::span<const Sample> measured, PlotStyle style, std::string name,
                     double Sample::*counted) {
  PlotSeries series{style, std::move(name), {}};
  for (const Sample& sample : measured)
    series.points.emplace_back(sample.vertices, sample.*counted);
  return series;
}

}  // namespace

Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  const std::span<const Sample> measured = measured_by(run, effects, frame);
  const LessonGrowth& growth = *run.lesson.table.as<LessonGrowth>();
  Plot plot = against_vertices(run, frame);
  double most = Growth::kLarsenMost;
  for (const Sample& sample : effects.get<Growth>(frame)) most = std::max(most, sample.iterations);
  constexpr double kStep = 4.0;  // the axis ends at a multiple
  plot.y = {0.0, kStep * std::ceil(most / kStep), false,
            fmt::format("average of {} runs", growth.runs)};
  plot.bands = {{Growth::kLarsenLeast, Growth::kLarsenMost,
                 fmt::format("Larsen: {} to {}", Growth::kLarsenLeast, Growth::kLarsenMost)}};
  plot.series = {series_of(measured, PlotStyle::first, "iterations", &Sample::iterations),
                 series_of(measured, PlotStyle::second, "support calls", &Sample::support_calls),
                 series_of(measured, PlotStyle::third,
                           fmt::format("iterations to {:g} %", 100.0 * growth.tolerance),
                           &Sample::within_tolerance)};
  return plot;
}

Plot points_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  const std::span<const Sample> measured = measured_by(run, effects, frame);
  Plot plot = against_vertices(run, frame);
  const double largest = run.lesson.table.as<LessonGrowth>()->vertices.back();
  plot.y = {1.0, power_of_ten_from(largest * largest), true, ""};
  PlotSeries all{PlotStyle::fourth, "n · n differences", {}};
  for (const Sample& sample : measured)
    all.points.emplace_back(sample.vertices, 1.0 * sample.vertices * sample.vertices);
  plot.series = {series_of(measured, PlotStyle::first, "computed by GJK", &Sample::touched_points),
                 series_of(measured, PlotStyle::second, "scanned", &Sample::scanned_vertices),
                 series_of(measured, PlotStyle::third, "climbed", &Sample::seen_vertices),
                 std::move(all)};
  return plot;
}

}  // namespace gjkscope
