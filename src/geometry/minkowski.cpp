#include "geometry/minkowski.hpp"

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

std::vector<int> minkowski_hull(std::span<const CloudPoint> cloud) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(cloud.size());
  for (const CloudPoint& point : cloud) points.push_back(point.z);
  return convex_hull(points);
}

}  // namespace gjkscope
