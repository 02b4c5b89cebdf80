#pragma once
// The shapes of a lesson as a query, in the lesson's scalar: what GJK is asked, and any algorithm
// that follows it.

#include "run/run.hpp"
#include "run/scalar.hpp"
#include "run/widen.hpp"

namespace gjkscope {

template <class S, int D>
[[nodiscard]] gjk::Pose<S, D> pose_of(const Placement& placement) {
  gjk::Pose<S, D> pose;
  pose.translation = narrowed<S, D>(placement.translate);
  if (placement.rotate_degrees != 0.0) {
    const Eigen::Matrix3d turn = turn_of(placement);
    Eigen::Matrix<S, D, D> rotation;
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) rotation(i, j) = S(turn(i, j));
    }
    pose.rotation = rotation;
  }
  return pose;
}

/// Calls `ask` with the gjk::Query<S, D> of X and Y at their placements, of which there is one for
/// each body, and returns its result. The query borrows points that live as long as the call.
template <class S, int D, class Ask>
decltype(auto) with_query_in(const Lesson& lesson, const std::vector<Placement>& at,
                             const Ask& ask) {
  const std::vector<gjk::Vec<S, D>> of_x = narrowed_all<S, D>(lesson.x().vertices);
  const std::vector<gjk::Vec<S, D>> of_y = narrowed_all<S, D>(lesson.y().vertices);
  return ask(gjk::Query<S, D>{{of_x, pose_of<S, D>(at[0])}, {of_y, pose_of<S, D>(at[1])}});
}

/// `with_query_in` the lesson's scalar and dimension.
template <class Ask>
decltype(auto) with_query(const Lesson& lesson, const std::vector<Placement>& at, const Ask& ask) {
  return with_scalar(lesson.scalar, [&]<class S>(std::type_identity<S>) {
    return lesson.dimension == 3 ? with_query_in<S, 3>(lesson, at, ask)
                                 : with_query_in<S, 2>(lesson, at, ask);
  });
}

}  // namespace gjkscope
