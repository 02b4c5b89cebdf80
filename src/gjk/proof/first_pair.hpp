#pragma once
// The beginning of a run: at the same pair in every scalar.

#include "gjk/support.hpp"

namespace gjk {

/// A shape's numbers in double.
template <int D>
struct InDouble {
  std::vector<Vec<double, D>> points;
  Pose<double, D> pose;

  template <class S>
  explicit InDouble(const Shape<S, D>& shape)
      : pose{Rotation<double, D>(shape.pose.rotation.matrix().template cast<double>()),
             converted<double, S, D>(shape.pose.translation)} {
    for (const Vec<S, D>& point : shape.vertices())
      points.push_back(converted<double, S, D>(point));
  }
};

/// The pair that a run starts from when it is given none: the support point of Z along the line
/// between the centres of the shapes. It is chosen in double, whatever the run computes in, so that
/// runs of one query start alike in every scalar. Only queries that double cannot hold choose for
/// themselves.
template <class R, class S, int D>
[[nodiscard]] VertexPair first_pair(const Query<S, D>& query, const Prepared<R, D>& prepared) {
  const auto chosen = [](const auto& asked, const auto& in) {
    return farthest_pair(asked, in, (-in.offset).eval());
  };
  if constexpr (ScalarTraits<S>::kExact) {
    const InDouble<D> x(query.x);
    const InDouble<D> y(query.y);
    const Query<double, D> in_double{{x.points, x.pose}, {y.points, y.pose}};
    const Prepared<double, D> doubles = prepare<double>(in_double, {});
    if (doubles.error == Error::none) return chosen(in_double, doubles);
  } else if constexpr (!std::is_same_v<R, double> &&
                       std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits) {
    const Prepared<double, D> doubles = prepare<double>(query, {});
    if (doubles.error == Error::none) return chosen(query, doubles);
  }
  return chosen(query, prepared);
}

}  // namespace gjk
