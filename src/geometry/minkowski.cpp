#include "geometry/minkowski.hpp"

#include <algorithm>

#include "geometry/polygon.hpp"

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

std::vector<Eigen::Vector2d> minkowski_merge(std::span<const Eigen::Vector2d> x,
                                             std::span<const Eigen::Vector2d> y) {
  const auto lower = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
  };
  // The lowest corner of -X is the highest of X.
  const auto from_x =
      static_cast<std::size_t>(std::max_element(x.begin(), x.end(), lower) - x.begin());
  const auto from_y =
      static_cast<std::size_t>(std::min_element(y.begin(), y.end(), lower) - y.begin());
  std::vector<Eigen::Vector2d> corners;
  corners.reserve(x.size() + y.size());
  for (std::size_t i = 0, j = 0; i < x.size() || j < y.size();) {
    const Eigen::Vector2d& at_x = x[(from_x + i) % x.size()];
    const Eigen::Vector2d& at_y = y[(from_y + j) % y.size()];
    corners.emplace_back(at_y - at_x);
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

std::vector<int> minkowski_hull(std::span<const CloudPoint> cloud) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(cloud.size());
  for (const CloudPoint& point : cloud) points.push_back(point.z);
  return convex_hull(points);
}

}  // namespace gjkscope
