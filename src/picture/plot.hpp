#pragma once
// Measured numbers as points in a frame of axes.

#include <optional>
#include <string>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

/// From `low` to `high`, in equal steps of the value, or of its logarithm: then both are positive.
/// Values beyond an end are drawn at it.
struct PlotAxis {
  double low = 0.0;
  double high = 1.0;
  bool is_logarithmic = false;
  std::string title;
  bool is_shown = true;  ///< Else it has no numbers and no lines.
};

struct PlotTick {
  double value = 0.0;
  std::string label;  ///< Empty: a line without a number.
};

/// Round values of an axis, at most `most` of them with a number: 1, 2 or 5 times a power of ten
/// apart, or the powers of ten themselves (where they are few, 2 and 5 times each, too).
[[nodiscard]] std::vector<PlotTick> plot_ticks(const PlotAxis& axis, int most);

/// The smallest of 1, 2 and 5 times a power of ten that is larger than `than`, which is positive.
[[nodiscard]] double round_step(double than);
/// The multiples of a round step from `low` to `high`.
[[nodiscard]] std::vector<PlotTick> round_ticks(double low, double high, double step);

/// How the points of a series look: each has its role in themes ("plot.first", its symbols;
/// "plot.first.line", whose dash is its own; "plot.first.label") and its symbol: a disk, a hollow
/// square around it, a diamond, a hollow triangle. `limit` is for a line around the others, `other`
/// for small disks in the background.
enum class PlotStyle { first, second, third, fourth, limit, other };

/// The lines that join the points of a series, in the order given: none, straight ones, or stairs
/// that go along the x axis first (what can be had for so much and no more).
enum class PlotJoin { none, lines, stairs };

/// Points, and a name above the axes.
struct PlotSeries {
  PlotStyle style = PlotStyle::first;
  std::string name;
  std::vector<Eigen::Vector2d> points;
  PlotJoin join = PlotJoin::lines;
  bool has_symbols = true;             ///< Points are to be seen, and not their line alone.
  std::vector<Subject> subjects = {};  ///< Subjects of the points; empty, or one each.
};

/// A word beside a point, in the colour of a series' name.
struct PlotNote {
  PlotStyle style = PlotStyle::first;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  std::string text;
};

/// A stretch of the y axis that is set off from the rest.
struct PlotBand {
  double low = 0.0;
  double high = 0.0;
  std::string name;  ///< Inside.
};

struct Plot {
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotBand> bands;
  std::vector<PlotSeries> series;
  std::vector<PlotNote> notes;
  std::optional<double> current;  ///< The value on the x axis that the frame is about.
  std::optional<Eigen::Vector2d> current_point;  ///< Or the point.
};

/// The symbol of a style.
[[nodiscard]] Mark symbol_mark(PlotStyle style, const Point& at);

/// The plot with its axes, their numbers and titles inside of `area`. Notes and names of bands keep
/// off lines and symbols and off each other.
[[nodiscard]] std::vector<Mark> plot_marks(const Plot& plot, const Fonts& fonts, const Rect& area);

}  // namespace gjkscope
