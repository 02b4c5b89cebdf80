#include "outlines/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gjkscope {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

std::vector<int> convex_hull(std::span<const Vector2d> points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto before = [&](int a, int b) {
    return points[a].x() < points[b].x() ||
           (points[a].x() == points[b].x() && points[a].y() < points[b].y());
  };
  std::stable_sort(order.begin(), order.end(), before);
  order.erase(
      std::unique(order.begin(), order.end(), [&](int a, int b) { return points[a] == points[b]; }),
      order.end());
  if (order.size() < 3) return order;

  std::vector<int> hull;
  const auto extend = [&](int next, std::size_t floor) {
    while (hull.size() >= floor + 2) {
      const Vector2d& a = points[hull[hull.size() - 2]];
      const Vector2d& b = points[hull.back()];
      if (cross(b - a, points[next] - b) > 0.0) break;
      hull.pop_back();
    }
    hull.push_back(next);
  };
  for (const int index : order) extend(index, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto it = order.rbegin() + 1; it != order.rend(); ++it) extend(*it, lower);
  hull.pop_back();
  return hull;
}

double signed_area(std::span<const Vector2d> polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return 0.5 * twice;
}

bool is_inside(std::span<const Vector2d> outline, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d a = outline[i] - point;
    const Vector2d b = outline[(i + 1) % outline.size()] - point;
    if ((a.y() > 0.0) == (b.y() > 0.0)) continue;
    const double turn = a.x() * b.y() - a.y() * b.x();
    inside ^= (turn > 0.0) == (b.y() > a.y());
  }
  return inside;
}

std::vector<std::array<int, 3>> triangles(std::span<const Vector2d> polygon) {
  std::vector<int> left(polygon.size());
  std::iota(left.begin(), left.end(), 0);
  const double side = signed_area(polygon) < 0.0 ? -1.0 : 1.0;
  const auto turn = [&](int a, int b, int c) {
    return side * cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
  };
  std::vector<std::array<int, 3>> out;
  const auto cut_ear = [&] {
    const std::size_t n = left.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::array<int, 3> ear = {left[i], left[(i + 1) % n], left[(i + 2) % n]};
      const double area = turn(ear[0], ear[1], ear[2]);
      const auto reaches_in = [&](int other) {
        return std::find(ear.begin(), ear.end(), other) == ear.end() &&
               turn(ear[0], ear[1], other) >= 0.0 && turn(ear[1], ear[2], other) >= 0.0 &&
               turn(ear[2], ear[0], other) >= 0.0;
      };
      if (area < 0.0 || std::any_of(left.begin(), left.end(), reaches_in)) continue;
      if (area > 0.0) out.push_back(ear);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
      return true;
    }
    return false;
  };
  while (left.size() > 2) {
    if (!cut_ear()) return {};
  }
  return out;
}

bool is_convex(std::span<const Vector2d> polygon) {
  const std::size_t n = polygon.size();
  if (n < 4) return true;
  double turn = 0.0;
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d in = polygon[(i + 1) % n] - polygon[i];
    const Vector2d out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    const double c = cross(in, out);
    left = left || c > 0.0;
    right = right || c < 0.0;
    turn += std::atan2(c, in.dot(out));
  }
  return !(left && right) && std::abs(turn) < 7.0;  // once around is 2 pi, twice 4 pi
}

bool differs_from_hull(std::span<const Vector2d> outline) {
  constexpr double kSeen = 1e-3;  // of the hull's area
  if (is_convex(outline)) return false;
  std::vector<Vector2d> hull;
  for (const int corner : convex_hull(outline)) hull.push_back(outline[corner]);
  const double area = signed_area(hull);
  return std::abs(area - std::abs(signed_area(outline))) > kSeen * area;
}

std::vector<Vector2d> clip(std::span<const Vector2d> polygon, const HalfPlane& half_plane) {
  std::vector<Vector2d> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& a = polygon[i];
    const Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double side_a = half_plane.normal.dot(a - half_plane.point);
    const double side_b = half_plane.normal.dot(b - half_plane.point);
    if (side_a <= 0.0) out.push_back(a);
    if ((side_a < 0.0 && side_b > 0.0) || (side_a > 0.0 && side_b < 0.0)) {
      out.push_back(a + (b - a) * (side_a / (side_a - side_b)));
    }
  }
  if (out.size() < 3) out.clear();
  return out;
}

std::vector<Vector2d> clip_to_box(std::vector<Vector2d> polygon, const Eigen::AlignedBox2d& box) {
  const std::array<HalfPlane, 4> sides = {{{box.min(), {-1.0, 0.0}},
                                           {box.min(), {0.0, -1.0}},
                                           {box.max(), {1.0, 0.0}},
                                           {box.max(), {0.0, 1.0}}}};
  for (const HalfPlane& side : sides) polygon = clip(polygon, side);
  return polygon;
}

std::optional<std::array<Vector2d, 2>> clip(const Vector2d& a, const Vector2d& b,
                                            const Eigen::AlignedBox2d& box) {
  double enter = 0.0;
  double leave = 1.0;
  const Vector2d d = b - a;
  for (int k = 0; k < 2; ++k) {
    const double low = box.min()[k] - a[k];
    const double high = box.max()[k] - a[k];
    if (d[k] == 0.0) {
      if (low > 0.0 || high < 0.0) return std::nullopt;
      continue;
    }
    enter = std::max(enter, std::min(low / d[k], high / d[k]));
    leave = std::min(leave, std::max(low / d[k], high / d[k]));
  }
  if (enter >= leave) return std::nullopt;
  return std::array<Vector2d, 2>{a + enter * d, a + leave * d};
}

Vector2d centroid(std::span<const Vector2d> points) {
  Vector2d sum = Vector2d::Zero();
  for (const Vector2d& point : points) sum += point;
  return points.empty() ? sum : Vector2d(sum / static_cast<double>(points.size()));
}

Vector2d closest_on_segment(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  const Vector2d edge = b - a;
  const double length_sq = edge.squaredNorm();
  const double t = length_sq > 0.0 ? std::clamp((point - a).dot(edge) / length_sq, 0.0, 1.0) : 0.0;
  return t == 1.0 ? b : Vector2d(a + t * edge);
}

double segment_distance(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  return (point - closest_on_segment(point, a, b)).norm();
}

}  // namespace gjkscope
