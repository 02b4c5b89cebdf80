#pragma once
// Shapes and poses as FCL has them.

#include <fcl/geometry/shape/convex.h>

#include <memory>
#include <vector>

#include "grid_pairs.hpp"

namespace bench {

inline fcl::Transform3d to_fcl(const gjk::Pose<double, 3>& pose) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear() = pose.rotation.matrix();
  out.translation() = pose.translation;
  return out;
}

/// `faces` as FCL lists them: a count, then as many indices. Without faces all vertices are
/// scanned, as up to 32 are anyway.
inline fcl::Convex<double> to_fcl(const std::vector<Point<3>>& shape,
                                  const std::vector<int>& faces = {}, int face_count = 0) {
  return {std::make_shared<std::vector<fcl::Vector3d>>(shape), face_count,
          std::make_shared<std::vector<int>>(faces)};
}

}  // namespace bench
