#include "subjects/study/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "subjects/study/dot_words.hpp"
#include "subjects/study/subject.hpp"
#include "subjects/study/tour.hpp"

namespace gjkscope {
namespace {

struct DotGroup {
  PlotStyle style;
  std::string_view name;
};
constexpr std::array<DotGroup, 4> kGroups = {{{PlotStyle::second, "loop only"},
                                              {PlotStyle::first, "bounds only"},
                                              {PlotStyle::third, "proved"},
                                              {PlotStyle::fourth, "stops early"}}};

constexpr const char* kTimeTitle = "time for one pair, nanoseconds";
constexpr const char* kErrorTitle = "largest error seen";

/// The plot of `dots` without a front: which of them has which subject, `subjects` says.
Plot plot_of(const std::vector<StudyDot>& dots, const std::vector<int>& subjects) {
  Plot plot;
  for (const DotGroup& group : kGroups)
    plot.series.push_back({group.style, std::string(group.name), {}, PlotJoin::none});
  for (std::size_t i = 0; i < dots.size(); ++i) {
    if (!dots[i].error) continue;
    const PlotStyle style = style_of(dots[i]);
    PlotSeries& series = *std::find_if(plot.series.begin(), plot.series.end(),
                                       [&](const PlotSeries& each) { return each.style == style; });
    series.points.push_back(plotted(dots[i]));
    series.subjects.push_back({Subject::Kind::study_dot, subjects[i]});
  }
  std::erase_if(plot.series, [](const PlotSeries& series) { return series.points.empty(); });
  return plot;
}

PlotSeries front_line(const std::vector<StudyDot>& front) {
  PlotSeries line{PlotStyle::limit, "front", {}, PlotJoin::stairs, false};
  for (const StudyDot& dot : front) line.points.push_back(plotted(dot));
  return line;
}

int index_of(const std::vector<StudyDot>& family, const std::string& configuration) {
  const auto found = std::find_if(family.begin(), family.end(), [&](const StudyDot& dot) {
    return dot.configuration == configuration;
  });
  return static_cast<int>(found - family.begin());
}

}  // namespace

void Decades::hold(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return;
  least_ = std::min(least_, value);
  most_ = std::max(most_, value);
}

double Decades::low() const { return std::pow(10.0, std::floor(std::log10(least_))); }

PlotAxis Decades::axis(std::string title) const {
  if (most_ < least_) return {1.0, 10.0, true, std::move(title)};
  const double high = std::pow(10.0, std::ceil(std::log10(most_)));
  return {low(), std::max(high, 10.0 * low()), true, std::move(title)};
}

PlotAxis Decades::close_axis(std::string title) const {
  if (most_ < least_) return axis(std::move(title));
  constexpr double kRoom = 1.4;
  return {least_ / kRoom, most_ * kRoom, true, std::move(title)};
}

PlotStyle style_of(const StudyDot& dot) {
  if (dot.axis == "tolerance" || dot.axis == "cap") return PlotStyle::fourth;
  if (dot.proof == "none") return PlotStyle::second;
  return dot.proof == "bounds" ? PlotStyle::first : PlotStyle::third;
}

Eigen::Vector2d plotted(const StudyDot& dot) { return {dot.ns, std::max(*dot.error, kNoError)}; }

Plot study_plot(const std::vector<StudyDot>& family) {
  std::vector<int> subjects;
  Decades ns;
  Decades error;
  for (const StudyDot& dot : family) {
    subjects.push_back(static_cast<int>(subjects.size()));
    if (!dot.error) continue;
    ns.hold(dot.ns);
    error.hold(*dot.error);
  }
  Plot plot = plot_of(family, subjects);
  plot.series.push_back(front_line(front_of(family)));
  plot.x = ns.axis(kTimeTitle);
  plot.y = error.axis(kErrorTitle);
  return plot;
}

Plot study_plot(const LessonStudy& study, const StudyFrame& frame) {
  const std::vector<StudyDot> family = of_family(study.dots(), study.family);
  const std::vector<StudyDot> front = front_of(family);
  const bool has_all = frame.stage == StudyStage::all || frame.stage == StudyStage::choice;
  const bool has_time = frame.stage != StudyStage::error_axis;

  // Room for every dot, and a little above an error of 1.
  Decades ns;
  Decades error;
  for (const StudyDot& dot : family) {
    if (!dot.error) continue;
    ns.hold(dot.ns);
    error.hold(std::max(*dot.error, kLeastShown));
  }
  constexpr double kRoomForNames = 2.5;  // left of the fastest marks
  PlotAxis time = ns.close_axis(kTimeTitle);
  time.low /= kRoomForNames;
  constexpr double kAbove = 30.0;

  std::vector<int> subjects;
  std::vector<StudyDot> shown = introduced(study, frame.marks);
  for (StudyDot& dot : shown) {
    subjects.push_back(index_of(family, dot.configuration));
    if (!has_time) dot.ns = std::sqrt(time.low * time.high);
  }
  Plot plot = plot_of(shown, subjects);
  plot.x = time;
  plot.x.is_shown = has_time;
  if (!has_time) plot.x.title.clear();
  const bool goes_beyond = std::any_of(shown.begin(), shown.end(), [](const StudyDot& dot) {
    return dot.error && *dot.error < kLeastShown;
  });
  plot.y =
      error.close_axis(fmt::format("{} on {} pairs{}", kErrorTitle, family.front().pairs,
                                   goes_beyond ? "; smaller ones are drawn at the bottom" : ""));
  plot.y.low = std::max(plot.y.low, kLeastShown);
  plot.y.high = kAbove;
  if (!has_all) {
    for (const StudyDot& dot : shown) {
      if (dot.error) plot.notes.push_back({style_of(dot), plotted(dot), dot.configuration});
    }
  }
  if (frame.stage == StudyStage::mark && shown.back().error)
    plot.current_point = plotted(shown.back());
  if (frame.stage == StudyStage::front) plot.series.push_back(front_line(front_among(shown)));
  if (has_all) {
    PlotSeries others{PlotStyle::other, "other ways", {}, PlotJoin::none};
    for (std::size_t i = 0; i < family.size(); ++i) {
      const StudyDot& dot = family[i];
      const auto is_same = [&](const StudyDot& mark) {
        return mark.configuration == dot.configuration;
      };
      if (!dot.error || std::any_of(shown.begin(), shown.end(), is_same)) continue;
      others.points.push_back(plotted(dot));
      others.subjects.push_back({Subject::Kind::study_dot, static_cast<int>(i)});
    }
    if (!others.points.empty()) plot.series.push_back(std::move(others));
    plot.series.push_back(front_line(front));
    for (std::size_t i = 0; i < front.size(); ++i)
      plot.notes.push_back({PlotStyle::limit, plotted(front[i]), std::to_string(i + 1)});
  }
  return plot;
}

}  // namespace gjkscope
