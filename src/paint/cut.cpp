#include "paint/cut.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gjkscope {
namespace {

// Circles are polygons whose sides stay this close to the circle, in pixels.
constexpr double kCircleError = 0.08;

// Lines at most this wide, in frame pixels, are moved onto pixels.
constexpr double kHairline = 1.25;

}  // namespace

std::vector<Point> intersect(std::vector<Point> polygon, const std::vector<Point>& inside) {
  for (std::size_t i = 0; i < inside.size() && !polygon.empty(); ++i) {
    const Point& a = inside[i];
    const Point side = inside[(i + 1) % inside.size()] - a;
    std::vector<Point> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point& from = polygon[k];
      const Point& to = polygon[(k + 1) % polygon.size()];
      const double from_depth = cross(side, from - a);
      const double to_depth = cross(side, to - a);
      if (from_depth >= 0.0) kept.push_back(from);
      if ((from_depth < 0.0) != (to_depth < 0.0)) {
        kept.push_back(from + (to - from) * (from_depth / (from_depth - to_depth)));
      }
    }
    polygon = std::move(kept);
  }
  return polygon;
}

std::optional<std::pair<Point, Point>> visible_part(const Point& a, const Point& b,
                                                    const Rect& bounds, double period) {
  const double length = (b - a).norm();
  if (length == 0.0) return std::nullopt;
  const double reach = 0.5 * bounds.size().norm() + period;
  const Point to_center = bounds.center() - a;
  const double along = to_center.dot(b - a) / length;
  const double begin = std::max(0.0, along - reach);
  const double end = std::min(length, along + reach);
  const bool passes_by = std::abs(cross(b - a, to_center)) > reach * length;
  if (passes_by || !(begin <= end)) return std::nullopt;
  const double first = period > 0.0 ? std::floor(begin / period) * period : begin;
  return std::pair(Point(a + (b - a) * (first / length)), Point(a + (b - a) * (end / length)));
}

std::vector<Point> arc(const Point& center, double radius, double from, double to,
                       double pixels_per_unit) {
  const double pixels = std::max(radius * pixels_per_unit, 0.5);
  const double step = 2.0 * std::acos(1.0 - std::min(kCircleError / pixels, 0.5));
  const int count = std::max(3, static_cast<int>(std::ceil((to - from) / step)));
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.emplace_back(center.x() + radius * std::cos(angle),
                        center.y() + radius * std::sin(angle));
  }
  return points;
}

std::vector<Point> circle(const Point& center, double radius, double pixels_per_unit) {
  std::vector<Point> points = arc(center, radius, 0.0, 2.0 * std::numbers::pi, pixels_per_unit);
  points.pop_back();
  return points;
}

void align_to_pixels(Point& a, Point& b, const Style& style, double pixels_per_unit) {
  if (style.width > kHairline || !style.dash.empty()) return;
  const double half = 0.5 * style.width * pixels_per_unit;
  for (int axis = 0; axis < 2; ++axis) {
    if (a[axis] != b[axis]) continue;
    a[axis] = b[axis] = (std::round(a[axis] * pixels_per_unit - half) + half) / pixels_per_unit;
  }
}

}  // namespace gjkscope
