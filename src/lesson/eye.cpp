#include "lesson/eye.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gjkscope {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

Eigen::Matrix3d axes_of(const Eye& eye) {
  // Rounded from more digits, as turns of shapes.
  const long double azimuth = eye.azimuth * std::numbers::pi / 180.0;
  const long double elevation = eye.elevation * std::numbers::pi / 180.0;
  const auto cos_a = static_cast<double>(std::cos(azimuth));
  const auto sin_a = static_cast<double>(std::sin(azimuth));
  const auto cos_e = static_cast<double>(std::cos(elevation));
  const auto sin_e = static_cast<double>(std::sin(elevation));
  return Eigen::Matrix3d{{cos_a, sin_a, 0.0},
                         {-sin_a * sin_e, cos_a * sin_e, cos_e},
                         {sin_a * cos_e, -cos_a * cos_e, sin_e}};
}

Eye eye_across(const Eigen::Vector3d& d) {
  constexpr double kElevation = 20.0;
  // With t the direction towards the eye, dot(t, d) = cos(e) |d.xy| sin(a − φ) + sin(e) d.z, where
  // φ is the azimuth of d.
  const double along = d.head<2>().norm();
  if (!(along > 0.0)) return {-30.0, 0.0};
  const double steepest = std::atan2(along, std::abs(d.z())) / kDegree;
  const double raised = std::min(kElevation, steepest);
  const double share = std::clamp(-std::tan(raised * kDegree) * d.z() / along, -1.0, 1.0);
  const double azimuth = (std::atan2(d.y(), d.x()) + std::asin(share)) / kDegree;
  return {std::round(std::remainder(azimuth, 360.0)), raised};
}

Eye eye_along(const Eigen::Vector3d& d) {
  const double flat = d.head<2>().norm();
  const double azimuth = flat > 0.0 ? std::atan2(-d.x(), d.y()) / kDegree : 0.0;
  return {azimuth, std::atan2(-d.z(), flat) / kDegree};
}

}  // namespace gjkscope
