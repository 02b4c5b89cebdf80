#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

#include "libraries.hpp"

namespace bench {
namespace {

using Convex = fcl::Convex<double>;

struct Prepared {
  Convex x;
  Convex y;
  fcl::Transform3d x_pose;
  fcl::Transform3d y_pose;
};

/// Vertices alone: distances do not look at faces, and up to 32 vertices are scanned anyway.
Convex to_fcl(const std::vector<Point<3>>& shape) {
  return {std::make_shared<std::vector<fcl::Vector3d>>(shape), 0,
          std::make_shared<std::vector<int>>()};
}

fcl::Transform3d to_fcl(const gjk::Pose<double, 3>& pose) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear() = pose.rotation.matrix();
  out.translation() = pose.translation;
  return out;
}

template <fcl::GJKSolverType solver>
Contestant prepare_all(std::span<const Pair<3>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair<3>& pair : pairs) {
    prepared->push_back({to_fcl(pair.x), to_fcl(pair.y), to_fcl(pair.x_pose), to_fcl(pair.y_pose)});
  }
  fcl::DistanceRequestd request(true);
  request.gjk_solver_type = solver;
  request.distance_tolerance = 1e-14;
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        const Prepared& pair = (*prepared)[i];
        fcl::DistanceResultd result;
        try {
          fcl::distance(&pair.x, pair.x_pose, &pair.y, pair.y_pose, request, result);
        } catch (const std::exception&) {
          result.min_distance = kGaveUp;
        }
        return result.min_distance;
      },
      [](double distance) { return std::max(distance, 0.0); });
}

}  // namespace

Library<3> fcl_own() {
  return {.name = "FCL " FCL_VERSION " (own)",
          .how = "fcl::distance on vertices (Convex), GST_INDEP, absolute tolerance 1e-14",
          .in_double = true,
          .prepare = prepare_all<fcl::GST_INDEP>};
}

Library<3> fcl_libccd() {
  return {.name = "FCL " FCL_VERSION " (libccd)",
          .how = "fcl::distance on vertices (Convex), GST_LIBCCD, absolute tolerance 1e-14",
          .in_double = true,
          .prepare = prepare_all<fcl::GST_LIBCCD>};
}

}  // namespace bench
