#pragma once
// What a run claims about a pair, judged by the truth.

#include <cmath>
#include <limits>
#include <string>

#include "exact.hpp"
#include "gjk/gjk.hpp"

namespace truth {

/// A result of any floating-point run, widened.
struct Claim {
  gjk::Error error = gjk::Error::none;
  gjk::StopReason stop = gjk::StopReason::running;
  gjk::Verdict verdict = gjk::Verdict::none;
  double distance = 0;
  double lower = 0;
  double upper = 0;
  Eigen::Vector2d x = Eigen::Vector2d::Zero();
  Eigen::Vector2d y = Eigen::Vector2d::Zero();
  double unit_roundoff = 0;
  double smallest = 0;  ///< Positive number of the run's scalar.
};

template <class R>
[[nodiscard]] Claim claim_of(const gjk::Result<R, 2>& result) {
  Claim out;
  out.error = result.error;
  out.stop = result.stop;
  out.verdict = result.verdict;
  out.distance = static_cast<double>(result.distance);
  out.lower = static_cast<double>(result.lower);
  out.upper = static_cast<double>(result.upper);
  out.x = result.x.template cast<double>();
  out.y = result.y.template cast<double>();
  out.unit_roundoff = static_cast<double>(gjk::ScalarTraits<R>::unit_roundoff());
  out.smallest = static_cast<double>(std::numeric_limits<R>::denorm_min());
  return out;
}

/// Errors are in units of u * scale (or of the smallest positive number, if that is larger).
struct Judgement {
  bool refused = false;  ///< The run named an error. Nothing else is judged then.
  bool not_a_number = false;
  bool capped = false;
  bool undecided = false;
  bool wrong_verdict = false;
  bool broken_certificate = false;  ///< Not lower <= exact <= upper, or the distance not between.
  double distance_error = 0;
  double relative_error = 0;  ///< Only where the shapes are apart.
  double outside = 0;         ///< Distance of a witness point from its shape.
  double apart = 0;           ///< | |y - x| - distance |
  double width = 0;           ///< upper - lower
};

/// `scale` is pair.scale().
///
/// Far from the origin witness points are rounded to a grid coarser than u * scale. What that
/// explains, where a point is farther from the origin than `scale`, is not held against them.
[[nodiscard]] Judgement judge(const ExactPair& pair, const Truth& truth, long double scale,
                              const Claim& claim);

}  // namespace truth
