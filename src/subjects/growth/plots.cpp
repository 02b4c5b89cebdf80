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

/// The size that a frame asks about, or that tells what was asked; 0 where there is none.
int size_in_question(const LessonRun& run, const Frame& frame) {
  const int size = shown_size(run, frame).value_or(-1) + (frame.question >= 0 ? 1 : 0);
  const auto& questions = run.lesson.questions;
  const bool is_asked = std::any_of(questions.begin(), questions.end(), [&](const auto& question) {
    return question.at.value_or(size + 1) == size + 1;
  });
  const auto sizes = static_cast<int>(run.lesson.table.as<LessonGrowth>()->vertices.size());
  return is_asked && size > 0 && size < sizes ? size : 0;
}

void add_choices(Plot& plot, const LessonRun& run, const Growth::Value& measured, int size) {
  const double before = measured[size - 1].iterations;
  PlotSeries places{PlotStyle::other, "", {}, PlotJoin::none};
  for (const WayToGrow& way : ways_to_grow(*run.lesson.table.as<LessonGrowth>(), size)) {
    places.subjects.push_back({Subject::Kind::study_dot, static_cast<int>(places.points.size())});
    places.points.emplace_back(measured[size].vertices, before * way.ratio);
    plot.notes.push_back({PlotStyle::other, places.points.back(), way.name});
  }
  plot.series.push_back(std::move(places));
}

}  // namespace

std::array<WayToGrow, 3> ways_to_grow(const LessonGrowth& growth, int size) {
  constexpr double kLittle = 1.2;
  return {{{"a little", kLittle},
           {"twice as many", 2.0},
           {"as n", 1.0 * growth.vertices[size] / growth.vertices[size - 1]}}};
}

Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  const std::span<const Sample> measured = measured_by(run, effects, frame);
  const LessonGrowth& growth = *run.lesson.table.as<LessonGrowth>();
  Plot plot = against_vertices(run, frame);
  double most = Growth::kLarsenMost;
  for (const Sample& sample : effects.get<Growth>(frame)) most = std::max(most, sample.iterations);
  const int asked = size_in_question(run, frame);
  if (asked > 0) {
    for (const WayToGrow& way : ways_to_grow(growth, asked))
      most = std::max(most, effects.get<Growth>(frame)[asked - 1].iterations * way.ratio);
  }
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
  if (asked > 0) add_choices(plot, run, effects.get<Growth>(frame), asked);
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
