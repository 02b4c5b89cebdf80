#pragma once
// The shapes of a lesson as a query, in the lesson's scalar: what GJK is asked, and any algorithm
// that follows it.

#include <cmath>
#include <numbers>

#include "run/run.hpp"
#include "run/scalar.hpp"
#include "run/widen.hpp"

namespace gjkscope {

template <class S>
[[nodiscard]] gjk::Pose<S, 2> pose_of(const Placement& placement) {
  gjk::Pose<S, 2> pose;
  pose.translation = narrowed<S, 2>(placement.translate);
  if (placement.rotate_degrees != 0.0) {
    // Rounded from more digits: a double's sine differs in the last bit from library to library.
    const long double angle = placement.rotate_degrees * std::numbers::pi / 180.0;
    const S c(static_cast<double>(std::cos(angle)));
    const S s(static_cast<double>(std::sin(angle)));
    pose.rotation = Eigen::Matrix<S, 2, 2>{{c, S(-s)}, {s, c}};
  }
  return pose;
}

/// Calls `ask` with the gjk::Query<S, 2> of X and Y where the placements, one for each body, put
/// them; what it borrows lives as long as the call. Returns what `ask` returns.
template <class S, class Ask>
decltype(auto) with_query_in(const Lesson& lesson, const std::vector<Placement>& at,
                             const Ask& ask) {
  const std::vector<gjk::Vec<S, 2>> of_x = narrowed_all<S, 2>(lesson.x().vertices);
  const std::vector<gjk::Vec<S, 2>> of_y = narrowed_all<S, 2>(lesson.y().vertices);
  return ask(gjk::Query<S, 2>{{of_x, pose_of<S>(at[0])}, {of_y, pose_of<S>(at[1])}});
}

/// `with_query_in` the lesson's scalar.
template <class Ask>
decltype(auto) with_query(const Lesson& lesson, const std::vector<Placement>& at, const Ask& ask) {
  return with_scalar(lesson.scalar, [&]<class S>(std::type_identity<S>) {
    return with_query_in<S>(lesson, at, ask);
  });
}

}  // namespace gjkscope
