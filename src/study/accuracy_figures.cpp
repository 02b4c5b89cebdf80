#include "study/accuracy_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/decimal.hpp"
#include "study/report.hpp"
#include "subjects/study/plot.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope {
namespace {

using study::Row;
using study::Study;
using RowList = std::vector<const Row*>;

constexpr double kWidth = 1280.0;
constexpr double kHeight = 720.0;
constexpr double kMargin = 32.0;
constexpr double kTitleLine = 48.0;
constexpr double kAboutLine = 76.0;
constexpr double kPlotTop = 98.0;
constexpr double kListLeft = 888.0;  ///< The left edge of a list beside the plot.
constexpr double kListGap = 28.0;
constexpr double kRowHeight = 44.0;

/// A page with a title and a line about it; plots and lists are added.
class FigurePage {
 public:
  explicit FigurePage(const Fonts& fonts) : fonts_(fonts) {
    picture_.width = kWidth;
    picture_.height = kHeight;
  }
  void write(std::string role, const Point& at, std::string text, const TextStyle& style) {
    picture_.marks.push_back({std::move(role), Text{at, std::move(text), style}});
  }
  void add(const Plot& plot, const Rect& area) {
    for (Mark& mark : plot_marks(plot, fonts_, area)) picture_.marks.push_back(std::move(mark));
  }
  [[nodiscard]] Figure figure(std::string name, std::string title, std::string about) && {
    write("title", {kMargin, kTitleLine}, title, type::kTitle);
    write("prose", {kMargin, kAboutLine}, std::move(about), type::kProse);
    return {std::move(name), std::move(title), std::move(picture_)};
  }

 private:
  const Fonts& fonts_;
  Picture picture_;
};

Rect plot_area(double right) { return {{kMargin, kPlotTop}, {right, kHeight - kMargin}}; }

std::string file_name(std::string_view kind, std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return fmt::format("{}-{}", kind, name);
}

bool is_timed(const Row& row) { return row.repetitions > 0; }
bool has_error(const Row& row) { return std::isfinite(row.error); }

class Figures {
 public:
  Figures(const Study& study, const Fonts& fonts)
      : study_(study), summary_(study::summary(study)), fonts_(fonts) {
    for (const Row& row : study.rows) {
      if (!is_timed(row)) continue;
      ns_.hold(row.ns.median);
      if (has_error(row)) error_.hold(row.error);
    }
  }

  [[nodiscard]] std::vector<Figure> all() const {
    std::vector<Figure> out;
    for (const RowList& rows : by_family(study_.rows)) {
      if (rows.front()->vertices > 0 || !is_timed(*rows.front())) continue;
      out.push_back(front(rows));
      if (std::optional<Figure> made = iterations(rows)) out.push_back(*std::move(made));
    }
    for (auto make : {&Figures::tolerance_time, &Figures::tolerance_error, &Figures::vertices_short,
                      &Figures::vertices_long}) {
      if (std::optional<Figure> made = (this->*make)()) out.push_back(*std::move(made));
    }
    return out;
  }

 private:
  /// Error against time of one family, its front numbered and listed.
  [[nodiscard]] Figure front(const RowList& rows) const {
    std::vector<StudyDot> dots;
    for (const Row* row : rows) dots.push_back(dot_of(*row));
    Plot plot = study_plot(dots);
    plot.x = ns_.axis(std::move(plot.x.title));
    plot.y = error_.axis(std::move(plot.y.title));
    const auto count = [&](auto property) {
      return std::count_if(dots.begin(), dots.end(), property);
    };
    const auto left_out = count([](const StudyDot& dot) { return !dot.error; });
    const auto without_error = count([](const StudyDot& dot) { return dot.error == 0.0; });
    const std::vector<StudyDot> best = front_of(dots);
    FigurePage page(fonts_);
    const double step =
        std::min(kRowHeight, (kHeight - kMargin - kPlotTop) / static_cast<double>(best.size()));
    for (std::size_t i = 0; i < best.size(); ++i) {
      const StudyDot& dot = best[i];
      const std::string number = std::to_string(i + 1);
      plot.notes.push_back({style_of(dot), plotted(dot), number});
      const double y = kPlotTop + 20.0 + static_cast<double>(i) * step;
      page.write("plot.limit.label", {kListLeft, y}, number, type::kHeading);
      page.write("body", {kListLeft + kListGap, y}, dot.configuration, type::kHeading);
      page.write("body.muted", {kListLeft + kListGap, y + 17.0},
                 fmt::format("{}, error {}", time_text(dot.ns), error_text(*dot.error)),
                 type::kTick);
    }
    page.add(plot, plot_area(kListLeft - kMargin));
    const Row& first = *rows.front();
    std::string about = fmt::format(
        "{} pairs, {} ways to answer them. Farther left is faster, lower is "
        "more accurate.",
        first.pairs, rows.size());
    if (without_error > 0) about += " At the foot: no error.";
    if (left_out > 0)
      about += fmt::format(" Not shown: {} that have no answer to some pair.", left_out);
    return std::move(page).figure(file_name("front", first.family),
                                  "What accuracy costs: " + first.family, std::move(about));
  }

  /// The dot of a row in the plot.
  [[nodiscard]] static StudyDot dot_of(const Row& row) {
    StudyDot dot;
    dot.family = row.family;
    dot.configuration = row.configuration;
    dot.axis = row.axis;
    dot.proof = row.proof;
    dot.on_front = row.on_front;
    dot.ns = row.ns.median;
    if (has_error(row)) dot.error = row.error;
    return dot;
  }

  /// Bounds and error against the cap on iterations.
  [[nodiscard]] std::optional<Figure> iterations(const RowList& rows) const {
    PlotSeries width{PlotStyle::third, "largest width of the bounds", {}};
    PlotSeries worst{PlotStyle::first, "largest error", {}};
    PlotSeries middle{PlotStyle::second, "median error", {}};
    Decades decades;
    double most = 0.0;
    for (const Row* row : rows) {
      if (row->axis != "cap" || !has_error(*row)) continue;
      const int cap = cap_of(*row);
      most = std::max<double>(most, cap);
      const auto add = [&](PlotSeries& series, double value) {
        if (std::isnan(value)) return;
        decades.hold(value);
        series.points.emplace_back(cap, std::max(value, kNoError));
      };
      add(width, row->width_scale);
      add(worst, row->error_scale);
      add(middle, row->middle_error_scale);
    }
    if (most < 2.0) return {};
    decades.hold(decades.low() / 10.0);  // room for names
    Plot plot;
    plot.x = {1.0, most, false, "iterations allowed"};
    plot.y = decades.axis("share of the scale");
    plot.series = {std::move(worst), std::move(middle), std::move(width)};
    FigurePage page(fonts_);
    page.add(plot, plot_area(kWidth - kMargin));
    const Row& first = *rows.front();
    return std::move(page).figure(
        file_name("iterations", first.family), "What each iteration buys: " + first.family,
        fmt::format("Runs in double that stop after so many iterations; {} pairs.", first.pairs));
  }

  [[nodiscard]] static int cap_of(const Row& row) {
    const std::string_view word = "cap ";
    return std::atoi(row.configuration.c_str() + row.configuration.rfind(word) + word.size());
  }
  [[nodiscard]] static double tolerance_of(const Row& row) {
    const std::string_view word = "tolerance ";
    return std::strtod(row.configuration.c_str() + row.configuration.rfind(word) + word.size(),
                       nullptr);
  }

  /// Over all families, with the tolerance from large to small.
  template <class Value>
  [[nodiscard]] PlotSeries by_tolerance(PlotStyle style, std::string_view arithmetic,
                                        std::string name, Value value) const {
    PlotSeries out{style, std::move(name), {}};
    for (const Row& row : summary_.rows) {
      if (row.family != study::kAllFamilies || row.axis != "tolerance" || !is_timed(row) ||
          !row.configuration.starts_with(std::string(arithmetic) + ",") || !has_error(row)) {
        continue;
      }
      out.points.emplace_back(tolerance_of(row), value(row));
    }
    return out;
  }

  [[nodiscard]] std::optional<Figure> tolerance(std::string name, std::string title,
                                                std::string about, PlotAxis y,
                                                std::vector<PlotSeries> series) const {
    Decades tolerances;
    for (const PlotSeries& each : series) {
      for (const Eigen::Vector2d& point : each.points) tolerances.hold(point.x());
    }
    if (series.front().points.size() < 2) return {};
    Plot plot;
    plot.x = tolerances.axis("tolerance: a run stops when its bounds differ by less, as a share");
    plot.y = std::move(y);
    plot.series = std::move(series);
    FigurePage page(fonts_);
    page.add(plot, plot_area(kWidth - kMargin));
    return std::move(page).figure(std::move(name), std::move(title), std::move(about));
  }

  [[nodiscard]] std::optional<Figure> tolerance_time() const {
    const auto time = [](const Row& row) { return row.ns.median; };
    std::vector<PlotSeries> series = {by_tolerance(PlotStyle::first, "double", "double", time),
                                      by_tolerance(PlotStyle::third, "float", "float", time)};
    double most = 0.0;
    for (const PlotSeries& each : series) {
      for (const Eigen::Vector2d& point : each.points) most = std::max(most, point.y());
    }
    return tolerance("tolerance-time", "Time against tolerance",
                     "Mean over all families. A run stops when its bounds are that close.",
                     {0.0, 1.2 * most, false, "time of a query, nanoseconds"}, std::move(series));
  }

  [[nodiscard]] std::optional<Figure> tolerance_error() const {
    const auto error = [](const Row& row) { return std::max(row.error_as_kept, kNoError); };
    std::vector<PlotSeries> series = {by_tolerance(PlotStyle::first, "double", "double", error),
                                      by_tolerance(PlotStyle::third, "float", "float", error)};
    Decades decades;
    for (const PlotSeries& each : series) {
      for (const Eigen::Vector2d& point : each.points) decades.hold(point.y());
    }
    return tolerance(
        "tolerance-error", "Error against tolerance",
        "The largest seen of the pairs of all families, as doubles and as floats keep them.",
        decades.axis("largest error seen"), std::move(series));
  }

  /// Time against the number of vertices, for at most four configurations.
  [[nodiscard]] std::optional<Figure> vertices(std::string name, std::string title,
                                               const std::vector<std::string>& names) const {
    constexpr PlotStyle kStyles[] = {PlotStyle::first, PlotStyle::second, PlotStyle::third,
                                     PlotStyle::fourth};
    Decades ns;
    Plot plot;
    int most = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      PlotSeries series{kStyles[i], names[i], {}};
      for (const Row& row : study_.rows) {
        if (row.vertices == 0 || !is_timed(row) || row.configuration != names[i]) continue;
        ns.hold(row.ns.median);
        most = std::max(most, row.vertices);
        series.points.emplace_back(row.vertices, row.ns.median);
      }
      plot.series.push_back(std::move(series));
    }
    if (plot.series.front().points.size() < 2) return {};
    plot.x = {2.0, 2.0 * most, true, "vertices of each polygon"};
    plot.y = ns.axis("time of a query, nanoseconds");
    FigurePage page(fonts_);
    page.add(plot, plot_area(kWidth - kMargin));
    return std::move(page).figure(std::move(name), std::move(title),
                                  "Two polygons with the same number of vertices; medians.");
  }
  [[nodiscard]] std::optional<Figure> vertices_short() const {
    return vertices("vertices", "Time against the number of vertices",
                    {"double", "double, loop only", "float"});
  }
  [[nodiscard]] std::optional<Figure> vertices_long() const {
    return vertices("vertices-more-digits", "Time against the number of vertices, with more digits",
                    {"double", "long double", "quad", "exact"});
  }

  const Study& study_;
  Study summary_;
  const Fonts& fonts_;
  Decades ns_;
  Decades error_;
};

}  // namespace

std::vector<Figure> accuracy_figures(const Study& study, const Fonts& fonts) {
  return Figures(study, fonts).all();
}

}  // namespace gjkscope
