#include "picture/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "picture/labels.hpp"
#include "picture/text_box.hpp"
#include "picture/words.hpp"

namespace gjkscope {
namespace {

constexpr double kNumberGap = 7.0;  // axis to its numbers
constexpr double kTickRow = 22.0;   // numbers of the x axis
constexpr double kTitleRow = 24.0;  // title of an axis
constexpr double kTickRoom = 30.0;  // between numbers of the y axis
constexpr double kSymbol = 5.0;     // half of a symbol's size
constexpr double kHollow = 6.5;     // of one that goes around another
constexpr double kSmall = 4.0;      // of one in the background
constexpr double kCurrentWidth = 16.0;
constexpr double kCurrentRadius = 11.0;
constexpr double kNameIndent = 14.0;  // middle of a symbol to the name of its series
constexpr double kNameGap = 20.0;     // from there to the next symbol

constexpr std::array<std::string_view, 6> kRoles = {"plot.first",  "plot.second", "plot.third",
                                                    "plot.fourth", "plot.limit",  "plot.other"};

std::string role_of(PlotStyle style, std::string_view part = "") {
  return std::string(kRoles[static_cast<std::size_t>(style)]) + std::string(part);
}

decltype(Mark::shape) symbol(PlotStyle style, const Point& at) {
  const auto around = [&](std::initializer_list<Point> corners) {
    Polygon polygon;
    for (const Point& corner : corners) polygon.points.push_back(at + corner);
    return polygon;
  };
  switch (style) {
    case PlotStyle::limit:
    case PlotStyle::first:
      return Disk{at, kSymbol};
    case PlotStyle::second:
      return around(
          {{-kHollow, -kHollow}, {kHollow, -kHollow}, {kHollow, kHollow}, {-kHollow, kHollow}});
    case PlotStyle::third:
      return around({{0.0, -1.4 * kSymbol},
                     {1.4 * kSymbol, 0.0},
                     {0.0, 1.4 * kSymbol},
                     {-1.4 * kSymbol, 0.0}});
    case PlotStyle::fourth:
      return around({{0.0, -kHollow}, {kHollow, 0.7 * kHollow}, {-kHollow, 0.7 * kHollow}});
    case PlotStyle::other:
      return Disk{at, kSmall};
  }
  return Disk{at, kSymbol};
}

/// How far along an axis a value is, from 0 to 1.
double part(const PlotAxis& axis, double value) {
  const double along = axis.is_logarithmic
                           ? std::log(value / axis.low) / std::log(axis.high / axis.low)
                           : (value - axis.low) / (axis.high - axis.low);
  return std::clamp(along, 0.0, 1.0);
}

/// factor * 10^exponent: written out, or as a power.
std::string number(int factor, int exponent, bool written_out) {
  if (written_out) {
    const double value = factor * std::pow(10.0, exponent);
    return exponent < 0 ? fixed(value, -exponent) : grouped(value);
  }
  if (factor == 1 && exponent == 0) return "1";
  return factor == 1 ? "10" + raised(exponent) : fmt::format("{}·10{}", factor, raised(exponent));
}

std::vector<PlotTick> powers_of_ten(const PlotAxis& axis, int most) {
  constexpr double kSlack = 1e-9;  // an end that is a power of ten belongs to the axis
  const double low = std::log10(axis.low) - kSlack;
  const double high = std::log10(axis.high) + kSlack;
  const int first = static_cast<int>(std::ceil(low));
  const int last = static_cast<int>(std::floor(high));
  constexpr int kLeastWritten = -3;
  constexpr int kMostWritten = 5;
  const bool written_out = kLeastWritten <= first - 1 && last <= kMostWritten;
  std::vector<PlotTick> ticks;
  if (last - first < 2) {
    for (int exponent = first - 1; exponent <= last; ++exponent) {
      for (const int factor : {1, 2, 5}) {
        const double value = factor * std::pow(10.0, exponent);
        if (low <= std::log10(value) && std::log10(value) <= high)
          ticks.push_back({value, number(factor, exponent, written_out)});
      }
    }
    if (static_cast<int>(ticks.size()) <= most) return ticks;
    ticks.clear();
  }
  const int each = (last - first) / most + 1;
  constexpr int kMostBetween = 1;  // lines without a number; more look like a pattern
  for (int exponent = first; exponent <= last; ++exponent) {
    const bool labelled = exponent % each == 0;
    if (!labelled && each - 1 > kMostBetween) continue;
    ticks.push_back(
        {std::pow(10.0, exponent), labelled ? number(1, exponent, written_out) : std::string()});
  }
  return ticks;
}

constexpr int kMostTicks = 12;

/// The most numbers of an x axis: where points have whole values, none stands between those.
int most_ticks(const Plot& plot) {
  const double length = plot.x.high - plot.x.low;
  const bool counts = std::all_of(plot.series.begin(), plot.series.end(), [](const auto& series) {
    return std::all_of(series.points.begin(), series.points.end(),
                       [](const auto& point) { return point.x() == std::round(point.x()); });
  });
  return counts && length < kMostTicks ? static_cast<int>(length) + 1 : kMostTicks;
}

/// With as many numbers as stand `gap` apart along `length` pixels, and no more than `most`. The
/// last one may reach `beyond` the end.
template <class SizeOf>
std::vector<PlotTick> ticks_along(const PlotAxis& axis, int most, double length, double beyond,
                                  double gap, const SizeOf& size_of) {
  for (; most > 1; --most) {
    std::vector<PlotTick> ticks = plot_ticks(axis, most);
    bool fits = true;
    double end = -1e9;
    for (const PlotTick& tick : ticks) {
      if (tick.label.empty()) continue;
      const double half = 0.5 * size_of(tick.label);
      const double at = std::min(length * part(axis, tick.value), length + beyond - half);
      fits = fits && end + gap <= at - half;
      end = at + half;
    }
    if (fits) return ticks;
  }
  return plot_ticks(axis, 1);
}

}  // namespace

Mark symbol_mark(PlotStyle style, const Point& at) { return {role_of(style), symbol(style, at)}; }

double round_step(double than) {
  double step = std::pow(10.0, std::floor(std::log10(than)));
  for (const double factor : {2.0, 2.5, 2.0}) {  // 1, 2, 5, 10
    if (than < step) break;
    step *= factor;
  }
  return step;
}

std::vector<PlotTick> round_ticks(double low, double high, double step) {
  const int exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  std::vector<PlotTick> ticks;
  const auto first = static_cast<long>(std::ceil(low / step - 1e-9));
  const auto last = static_cast<long>(std::floor(high / step + 1e-9));
  for (long i = first; i <= last; ++i) {
    const double value = static_cast<double>(i) * step;
    ticks.push_back({value, exponent < 0 ? fixed(value, -exponent) : grouped(value)});
  }
  return ticks;
}

std::vector<PlotTick> plot_ticks(const PlotAxis& axis, int most) {
  if (!axis.is_shown) return {};
  if (axis.is_logarithmic) return powers_of_ten(axis, most);
  return round_ticks(axis.low, axis.high, round_step((axis.high - axis.low) / most));
}

std::vector<Mark> plot_marks(const Plot& plot, const Fonts& fonts, const Rect& area) {
  std::vector<Mark> marks;
  const auto add = [&](std::string role, decltype(Mark::shape) shape) {
    marks.push_back({std::move(role), std::move(shape)});
  };
  const auto write = [&](std::string role, const Point& at, std::string text,
                         const TextStyle& style, Align align) {
    if (!text.empty()) add(std::move(role), Text{at, std::move(text), style, align});
  };

  const std::vector<std::string> y_title =
      wrapped(fonts, type::kText, plot.y.title, area.size().x());
  // The names of the series stand in rows above the axes: inside they would look like data.
  struct Name {
    const PlotSeries* series;
    Point symbol;
  };
  std::vector<Name> names;
  Point next(area.min.x() + kHollow,
             area.min.y() + kTitleRow * static_cast<double>(y_title.size()) + 0.5 * kTitleRow);
  for (const PlotSeries& series : plot.series) {
    if (series.name.empty()) continue;
    const double width = kNameIndent + fonts.width(type::kName, series.name);
    if (!names.empty() && next.x() + width > area.max.x()) {
      next = {area.min.x() + kHollow, next.y() + kTitleRow};
    }
    names.push_back({&series, next});
    next.x() += width + kNameGap;
  }
  const double top = names.empty() ? next.y() : next.y() + 0.75 * kTitleRow;
  const double bottom = area.max.y() - kTickRow - (plot.x.title.empty() ? 0.0 : kTitleRow);
  const std::vector<PlotTick> y_ticks = ticks_along(
      plot.y, kMostTicks, bottom - top, 0.0, kTickRoom, [](const std::string&) { return 0.0; });
  double widest = 0.0;
  for (const PlotTick& tick : y_ticks)
    widest = std::max(widest, fonts.width(type::kText, tick.label));
  const Rect inner{{area.min.x() + widest + kNumberGap, top},
                   {area.max.x() - kHollow - kNumberGap, bottom}};
  const std::vector<PlotTick> x_ticks = ticks_along(
      plot.x, most_ticks(plot), inner.size().x(), area.max.x() - inner.max.x(), kNumberGap,
      [&](const std::string& label) { return fonts.width(type::kText, label); });
  const auto at = [&](double x, double y) {
    return Point(inner.min.x() + part(plot.x, x) * inner.size().x(),
                 inner.max.y() - part(plot.y, y) * inner.size().y());
  };
  const auto strip = [&](const Point& a, const Point& b) {
    return Polygon{{a, {b.x(), a.y()}, b, {a.x(), b.y()}}};
  };

  LabelPlacer placer(fonts, {inner.min - Point(0.0, kNumberGap), inner.max + Point(kHollow, 0.0)});
  Obstacles obstacles;
  for (const PlotBand& band : plot.bands)
    add("plot.band", strip(at(plot.x.low, band.low), at(plot.x.high, band.high)));
  if (plot.current) {
    const Point half(0.5 * kCurrentWidth, 0.0);
    add("plot.current",
        strip(at(*plot.current, plot.y.low) - half, at(*plot.current, plot.y.high) + half));
  }
  if (plot.current_point) {
    const Point point = at(plot.current_point->x(), plot.current_point->y());
    obstacles.circles.push_back({point, kCurrentRadius});
  }
  for (const PlotTick& tick : y_ticks) {
    const Point left = at(plot.x.low, tick.value);
    add("chart.grid", Polyline{{left, at(plot.x.high, tick.value)}});
    obstacles.passing.push_back({left, at(plot.x.high, tick.value)});
    write("body.muted", {left.x() - kNumberGap, left.y() + 6.0}, tick.label, type::kText,
          Align::right);
  }
  for (const PlotTick& tick : x_ticks) {
    const Point foot = at(tick.value, plot.y.low);
    add("chart.grid", Polyline{{foot, at(tick.value, plot.y.high)}});
    obstacles.passing.push_back({foot, at(tick.value, plot.y.high)});
    const double half = 0.5 * fonts.width(type::kText, tick.label);
    write("body.muted", {std::min(foot.x(), area.max.x() - half), foot.y() + kTickRow}, tick.label,
          type::kText, Align::center);
  }
  Polyline axes{{inner.min, {inner.min.x(), inner.max.y()}}};
  if (plot.x.is_shown) axes.points.push_back(inner.max);
  add("plot.axis", std::move(axes));
  Point row = area.min + Point(0.0, fonts.cap_height(type::kText));
  for (const std::string& line : y_title) {
    write("body.muted", row, line, type::kText, Align::left);
    row.y() += kTitleRow;
  }
  write("body.muted", {inner.center().x(), area.max.y() - 4.0}, plot.x.title, type::kText,
        Align::center);

  // The first series last, so that it lies on the others.
  std::vector<Mark> symbols;
  for (auto series = plot.series.rbegin(); series != plot.series.rend(); ++series) {
    Polyline line;
    for (std::size_t i = 0; i < series->points.size(); ++i) {
      const Point point = at(series->points[i].x(), series->points[i].y());
      if (series->join != PlotJoin::none) {
        const bool has_corner = series->join == PlotJoin::stairs && !line.points.empty();
        if (has_corner) line.points.emplace_back(point.x(), line.points.back().y());
        line.points.push_back(point);
      }
      if (!series->has_symbols) continue;
      if (series->style != PlotStyle::other) obstacles.circles.push_back({point, kHollow});
      const Subject subject = series->subjects.empty() ? Subject{} : series->subjects[i];
      symbols.push_back({role_of(series->style), symbol(series->style, point), -1, subject});
    }
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      obstacles.segments.push_back({line.points[i - 1], line.points[i]});
    }
    // A line through one point has no length.
    constexpr double kHalf = 5.0;
    if (line.points.size() == 1)
      line.points = {line.points[0] - Point(kHalf, 0.0), line.points[0] + Point(kHalf, 0.0)};
    if (!line.points.empty()) add(role_of(series->style, ".line"), std::move(line));
  }
  for (Mark& mark : symbols) marks.push_back(std::move(mark));
  if (plot.current_point) {
    add("plot.ring", Disk{at(plot.current_point->x(), plot.current_point->y()), kCurrentRadius});
  }

  placer.begin_frame(obstacles);
  for (std::size_t i = 0; i < plot.notes.size(); ++i) {
    const PlotNote& note = plot.notes[i];
    const LabelRequest request{fmt::format("note {}", i),
                               note.text,
                               role_of(note.style, ".label"),
                               type::kName,
                               at(note.at.x(), note.at.y()),
                               kHollow,
                               Point(-1.0, 1.0),
                               true};
    Mark name = placer.place(request, true);
    if (const auto line = leader_line(request, box_of(fonts, std::get<Text>(name.shape))))
      add("leader", Polyline{{line->a, line->b}});
    marks.push_back(std::move(name));
  }
  for (const auto& [series, middle] : names) {
    const Point start = middle + Point(kNameIndent, 0.5 * fonts.cap_height(type::kName));
    write(role_of(series->style, ".label"), start, series->name, type::kName, Align::left);
    if (series->has_symbols) {
      add(role_of(series->style), symbol(series->style, middle));
    } else {
      const Point half(kHollow, 0.0);
      add(role_of(series->style, ".line"), Polyline{{middle - half, middle + half}});
    }
  }
  for (const PlotBand& band : plot.bands) {
    const Polygon box = strip(at(plot.x.low, band.low), at(plot.x.high, band.high));
    for (Mark& mark : placer.place_inside(
             {"band " + band.name, band.name, "plot.band.label", type::kName, box.points, {}}))
      marks.push_back(std::move(mark));
  }
  return marks;
}

}  // namespace gjkscope
