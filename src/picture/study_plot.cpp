#include "picture/study_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gjkscope {
namespace {

struct Axis {
  PlotStyle style;
  std::string_view name;
};
constexpr std::array<Axis, 4> kAxes = {{{PlotStyle::first, "scalar and proof"},
                                        {PlotStyle::second, "rules and start"},
                                        {PlotStyle::third, "stop rule"},
                                        {PlotStyle::fourth, "cap on iterations"}}};

}  // namespace

void Decades::hold(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return;
  low_ = std::min(low_, std::floor(std::log10(value)));
  high_ = std::max(high_, std::ceil(std::log10(value)));
}

double Decades::low() const { return std::pow(10.0, low_); }

PlotAxis Decades::axis(std::string title) const {
  const bool is_empty = high_ < low_;
  const double low = is_empty ? 0.0 : low_;
  const double high = is_empty ? 1.0 : std::max(high_, low + 1.0);
  return {std::pow(10.0, low), std::pow(10.0, high), true, std::move(title)};
}

PlotStyle style_of(const StudyDot& dot) {
  if (dot.axis == "arithmetic" || dot.axis == "effort") return PlotStyle::first;
  if (dot.axis == "stop rule" || dot.axis == "bound gap") return PlotStyle::third;
  if (dot.axis == "cap") return PlotStyle::fourth;
  return PlotStyle::second;
}

Eigen::Vector2d place_of(const StudyDot& dot) { return {dot.ns, std::max(*dot.error, kNoError)}; }

Plot study_plot(const std::vector<StudyDot>& family) {
  Plot plot;
  Decades ns;
  Decades error;
  for (const Axis& axis : kAxes) {
    plot.series.push_back({axis.style, std::string(axis.name), {}, PlotJoin::none});
  }
  for (std::size_t i = 0; i < family.size(); ++i) {
    if (!family[i].error) continue;
    ns.hold(family[i].ns);
    error.hold(*family[i].error);
    PlotSeries& series = plot.series[static_cast<std::size_t>(style_of(family[i]))];
    series.points.push_back(place_of(family[i]));
    series.subjects.push_back({Subject::Kind::study_dot, static_cast<int>(i)});
  }
  std::erase_if(plot.series, [](const PlotSeries& series) { return series.points.empty(); });
  PlotSeries front{PlotStyle::limit, "Pareto front", {}, PlotJoin::stairs, false};
  for (const StudyDot& dot : front_of(family)) front.points.push_back(place_of(dot));
  plot.series.push_back(std::move(front));
  plot.x = ns.axis("time of a query, nanoseconds");
  plot.y =
      error.axis("largest error of the distance / scale (the largest distance between vertices)");
  return plot;
}

}  // namespace gjkscope
