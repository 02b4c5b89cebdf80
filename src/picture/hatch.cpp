#include "picture/hatch.hpp"

#include <algorithm>
#include <cmath>

namespace gjkscope {

std::vector<Polyline> hatch(const std::vector<Point>& polygon, double spacing, const Rect& area) {
  // x + y tells the lines apart.
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Point& corner : polygon) {
    low = std::min(low, corner.sum());
    high = std::max(high, corner.sum());
  }
  low = std::max(low, area.min.sum());
  high = std::min(high, area.max.sum());
  const double step = spacing * std::sqrt(2.0);
  std::vector<Polyline> lines;
  // Multiples of the step, so that neighbours meet; half a step off, so that no corner is on one.
  for (double sum = (std::floor(low / step) + 0.5) * step; sum < high; sum += step) {
    std::vector<Point> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      if ((a.sum() > sum) == (b.sum() > sum)) continue;
      crossings.push_back(a + (sum - a.sum()) / (b.sum() - a.sum()) * (b - a));
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Point& a, const Point& b) { return a.x() < b.x(); });
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      lines.push_back({{crossings[i], crossings[i + 1]}});
  }
  return lines;
}

}  // namespace gjkscope
