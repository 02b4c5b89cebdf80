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

/// Two faces back to back in the plane z = 0.
Convex flat(const std::vector<Point>& shape) {
  const int count = static_cast<int>(shape.size());
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Point& point : shape) vertices->emplace_back(point[0], point[1], 0.0);
  faces->push_back(count);
  for (int i = 0; i < count; ++i) faces->push_back(i);
  faces->push_back(count);
  for (int i = count; i > 0; --i) faces->push_back(i - 1);
  return {vertices, 2, faces};
}

fcl::Transform3d in_space(const gjk::Pose<double, 2>& pose) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear().topLeftCorner<2, 2>() = pose.rotation.matrix();
  out.translation().head<2>() = pose.translation;
  return out;
}

template <fcl::GJKSolverType solver>
Contestant prepare_all(std::span<const Pair> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair& pair : pairs) {
    prepared->push_back({flat(pair.x), flat(pair.y), in_space(pair.x_pose), in_space(pair.y_pose)});
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

Library fcl_own() {
  return {.name = "FCL " FCL_VERSION " (own)",
          .how = "fcl::distance on flat Convex, GST_INDEP, absolute tolerance 1e-14",
          .in_double = true,
          .prepare = prepare_all<fcl::GST_INDEP>};
}

Library fcl_libccd() {
  return {.name = "FCL " FCL_VERSION " (libccd)",
          .how = "fcl::distance on flat Convex, GST_LIBCCD, absolute tolerance 1e-14",
          .in_double = true,
          .prepare = prepare_all<fcl::GST_LIBCCD>};
}

}  // namespace bench
