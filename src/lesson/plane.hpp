#pragma once
// Vectors of the plane as those of space, where z = 0, and back.

#include <Eigen/Core>
#include <vector>

namespace gjkscope {

[[nodiscard]] inline Eigen::Vector2d in_plane(const Eigen::Vector3d& v) { return v.head<2>(); }
[[nodiscard]] inline std::vector<Eigen::Vector2d> in_plane(
    const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(vectors.size());
  for (const Eigen::Vector3d& v : vectors) out.push_back(in_plane(v));
  return out;
}
[[nodiscard]] inline Eigen::Vector3d in_space(const Eigen::Vector2d& v) {
  return {v.x(), v.y(), 0};
}
[[nodiscard]] inline Eigen::Vector3d in_space(const Eigen::Vector3d& v) { return v; }
template <class Vector>
[[nodiscard]] std::vector<Eigen::Vector3d> in_space(const std::vector<Vector>& vectors) {
  std::vector<Eigen::Vector3d> out;
  out.reserve(vectors.size());
  for (const Vector& v : vectors) out.push_back(in_space(v));
  return out;
}

/// Mean of the points.
[[nodiscard]] inline Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

}  // namespace gjkscope
