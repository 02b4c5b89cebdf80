#include <fcl/narrowphase/distance.h>

#include <memory>

#include "fcl_shapes.hpp"
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
