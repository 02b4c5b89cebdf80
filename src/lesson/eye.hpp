#pragma once
// From which side space is seen: orthographic views, turned by hand like a turntable.

#include <Eigen/Core>

namespace gjkscope {

/// Degrees: the eye walks around z by `azimuth`, counter-clockwise seen from above, and stands
/// `elevation` above the plane of x and y. At 0 and 0 x points right, z up, and y away.
struct Eye {
  double azimuth = 0.0;
  double elevation = 0.0;
  friend bool operator==(const Eye&, const Eye&) = default;
};

/// Unit vectors of the world that point right, up, and towards the eye, as rows.
[[nodiscard]] Eigen::Matrix3d axes_of(const Eye& eye);

/// The eye that sees the true length of `d`: it looks across d, from a little above the ground, or
/// as close to that as can be. Whole degrees around z.
[[nodiscard]] Eye eye_across(const Eigen::Vector3d& d);

/// The eye that looks along `d`: what is normal to it is seen as it is.
[[nodiscard]] Eye eye_along(const Eigen::Vector3d& d);

}  // namespace gjkscope
