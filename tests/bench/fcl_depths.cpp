#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "depths.hpp"
#include "fcl_shapes.hpp"
#include "outlines/polyhedron.hpp"

namespace bench {
namespace {

struct Prepared {
  fcl::Convex<double> x;
  fcl::Convex<double> y;
  fcl::Transform3d x_pose;
  fcl::Transform3d y_pose;
};

/// With its faces where FCL walks along edges to support points.
fcl::Convex<double> with_faces(const std::vector<Point<3>>& shape) {
  if (shape.size() <= 32) return to_fcl(shape);
  const gjkscope::Polyhedron hull = gjkscope::hull_in_space(shape);
  std::vector<int> faces;
  for (const gjkscope::Polyhedron::Face& face : hull.faces) {
    faces.push_back(static_cast<int>(face.vertices.size()));
    faces.insert(faces.end(), face.vertices.begin(), face.vertices.end());
  }
  return to_fcl(shape, faces, static_cast<int>(hull.faces.size()));
}

/// FCL's own solver names depths as negative numbers; their size is judged.
template <fcl::GJKSolverType solver>
Depth collide(const Prepared& pair) {
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = solver;
  request.gjk_tolerance = 1e-10;
  fcl::CollisionResultd result;
  fcl::collide(&pair.x, pair.x_pose, &pair.y, pair.y_pose, request, result);
  if (result.numContacts() == 0) return {};
  const fcl::Contactd& contact = result.getContact(0);
  const double depth = std::abs(contact.penetration_depth);
  return {true, depth, contact.normal * -depth};
}

Depth signed_distance(const Prepared& pair) {
  fcl::DistanceRequestd request(true, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = 1e-10;
  fcl::DistanceResultd result;
  fcl::distance(&pair.x, pair.x_pose, &pair.y, pair.y_pose, request, result);
  if (!(result.min_distance <= 0.0)) return {};
  return {true, -result.min_distance, result.nearest_points[1] - result.nearest_points[0]};
}

template <auto ask>
std::function<Depth(std::size_t)> prepare(std::span<const Pair<3>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair<3>& pair : pairs) {
    prepared->push_back(
        {with_faces(pair.x), with_faces(pair.y), to_fcl(pair.x_pose), to_fcl(pair.y_pose)});
  }
  return [=](std::size_t i) {
    try {
      return ask((*prepared)[i]);
    } catch (const std::exception&) {
      return Depth{};
    }
  };
}

}  // namespace

std::vector<DepthLibrary> fcl_depths() {
  const std::string name = "FCL " PEER_VERSION " ";
  return {
      {name + "collide, libccd", "fcl::collide, GST_LIBCCD: MPR of libccd, tolerance 1e-10", true,
       prepare<collide<fcl::GST_LIBCCD>>},
      {name + "collide, own",
       "fcl::collide, GST_INDEP: EPA of at most 64 vertices, tolerance 1e-10", true,
       prepare<collide<fcl::GST_INDEP>>},
      {name + "distance", "fcl::distance, signed, GST_LIBCCD: an EPA of its own, tolerance 1e-10",
       true, prepare<signed_distance>}};
}

}  // namespace bench
