#include "outlines/minkowski.hpp"

#include <algorithm>

#include "outlines/polygon.hpp"

namespace gjkscope {

std::vector<CloudPoint> minkowski_cloud(std::span<const Eigen::Vector2d> x,
                                        std::span<const Eigen::Vector2d> y) {
  std::vector<CloudPoint> cloud;
  cloud.reserve(x.size() * y.size());
  for (int i = 0; i < static_cast<int>(x.size()); ++i) {
    for (int j = 0; j < static_cast<int>(y.size()); ++j) cloud.push_back({y[j] - x[i], {i, j}});
  }
  return cloud;
}

std::vector<CloudPoint> minkowski_merge(std::span<const Eigen::Vector2d> x,
                                        std::span<const Eigen::Vector2d> y) {
  const auto lower = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
  };
  // The lowest corner of -X is the highest of X.
  const auto from_x =
      static_cast<std::size_t>(std::max_element(x.begin(), x.end(), lower) - x.begin());
  const auto from_y =
      static_cast<std::size_t>(std::min_element(y.begin(), y.end(), lower) - y.begin());
  std::vector<CloudPoint> corners;
  corners.reserve(x.size() + y.size());
  for (std::size_t i = 0, j = 0; i < x.size() || j < y.size();) {
    const std::size_t of_x = (from_x + i) % x.size();
    const std::size_t of_y = (from_y + j) % y.size();
    const Eigen::Vector2d& at_x = x[of_x];
    const Eigen::Vector2d& at_y = y[of_y];
    corners.push_back({at_y - at_x, {static_cast<int>(of_x), static_cast<int>(of_y)}});
    const Eigen::Vector2d along_x = at_x - x[(from_x + i + 1) % x.size()];
    const Eigen::Vector2d along_y = y[(from_y + j + 1) % y.size()] - at_y;
    const double turn = along_y.x() * along_x.y() - along_y.y() * along_x.x();
    const bool take_y = i == x.size() || (j < y.size() && turn >= 0.0);
    const bool take_x = j == y.size() || (i < x.size() && turn <= 0.0);
    j += take_y ? 1 : 0;
    i += take_x ? 1 : 0;
  }
  return corners;
}

std::vector<CloudPoint> minkowski_hull(std::span<const Eigen::Vector2d> x,
                                       std::span<const Eigen::Vector2d> y) {
  const std::vector<int> hull_x = convex_hull(x);
  const std::vector<int> hull_y = convex_hull(y);
  const auto corners_of = [](std::span<const Eigen::Vector2d> points,
                             const std::vector<int>& hull) {
    std::vector<Eigen::Vector2d> corners;
    for (const int index : hull) corners.push_back(points[index]);
    return corners;
  };
  const std::vector<CloudPoint> merged =
      minkowski_merge(corners_of(x, hull_x), corners_of(y, hull_y));
  // Edges that are parallel but for rounding leave corners that are none.
  std::vector<Eigen::Vector2d> points;
  for (const CloudPoint& corner : merged) points.push_back(corner.z);
  std::vector<CloudPoint> hull;
  for (const int index : convex_hull(points)) {
    const auto& [z, pair] = merged[index];
    hull.push_back({z, {hull_x[pair.x], hull_y[pair.y]}});
  }
  return hull;
}

}  // namespace gjkscope
