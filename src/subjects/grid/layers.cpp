#include <algorithm>
#include <cmath>

#include "subjects/grid/grid.hpp"
#include "subjects/grid/subject.hpp"
#include "subjects/lengths/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;

// Frame pixels.
constexpr double kLeastApart = 64.0;    // of lines
constexpr double kCharacter = 11.0;     // width of a figure, at most
constexpr double kTitleRoom = 44.0;     // height of the view's title, which no number covers
constexpr double kNumberRow = 30.0;     // of the numbers at the bottom
constexpr double kNumberRadius = 12.0;  // around a number, which labels keep off

double width_of(const PlotTick& tick) {
  return kCharacter * static_cast<double>(code_points(tick.label).size());
}

/// Round values from `low` to `high`, so far apart that their numbers have room.
std::vector<PlotTick> values_of(double low, double high, double units_per_pixel) {
  // Farther from the origin a number would have more digits than a reader compares.
  constexpr double kMostSteps = 1e9;
  double apart = kLeastApart;
  while (true) {
    const double step = round_step(apart * units_per_pixel);
    if (std::max(std::abs(low), std::abs(high)) > kMostSteps * step) return {};
    std::vector<PlotTick> ticks = round_ticks(low, high, step);
    double widest = 0.0;
    for (const PlotTick& tick : ticks) widest = std::max(widest, width_of(tick) + kCharacter);
    if (widest <= apart) return ticks;
    apart = widest + kCharacter;
  }
}

void number(SceneBuilder& scene, const PlotTick& tick, const Point& at) {
  const double width = width_of(tick);
  scene.add("grid.number.box", Box{{at - Point(2.0, 14.0), at + Point(width + 2.0, 4.0)}, 0.0});
  scene.add("grid.number", Text{at, tick.label, type::kTick});
  scene.out.obstacles.circles.push_back({at + Point(0.5 * width, -5.0), kNumberRadius});
}

void grid(SceneBuilder& scene) {
  const std::vector<Vector2d> corners = scene.map.visible();
  const Vector2d& low = corners[0];
  const Vector2d& high = corners[2];
  const Rect& area = scene.map.area();
  const Vector2d units = (high - low).cwiseQuotient(area.size());
  const std::vector<PlotTick> across = values_of(low.x(), high.x(), units.x());
  const std::vector<PlotTick> up = values_of(low.y(), high.y(), units.y());
  // No obstacles: labels stand on the grid.
  const auto line = [&](double value, const Point& a, const Point& b) {
    scene.add(value == 0.0 ? "grid.axis" : "grid.line", Polyline{{a, b}});
  };
  const auto x_of = [&](const PlotTick& tick) {
    return scene.at(Vector2d(tick.value, low.y())).x();
  };
  const auto y_of = [&](const PlotTick& tick) {
    return scene.at(Vector2d(low.x(), tick.value)).y();
  };
  for (const PlotTick& tick : across)
    line(tick.value, {x_of(tick), area.min.y()}, {x_of(tick), area.max.y()});
  for (const PlotTick& tick : up)
    line(tick.value, {area.min.x(), y_of(tick)}, {area.max.x(), y_of(tick)});
  for (const PlotTick& tick : across) {
    const double x = x_of(tick) + 4.0;
    if (x + width_of(tick) < area.max.x()) number(scene, tick, {x, area.max.y() - 8.0});
  }
  for (const PlotTick& tick : up) {
    const double y = y_of(tick) - 4.0;
    if (y > area.min.y() + kTitleRoom && y < area.max.y() - kNumberRow)
      number(scene, tick, {area.min.x() + 8.0, y});
  }
}

}  // namespace

const Layer kGrid{
    .effect = gjkscope::Grid::kName, .on = Layer::On::every_view, .order = 45, .draw = grid};

}  // namespace gjkscope::layers
