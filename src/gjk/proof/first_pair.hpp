#pragma once
// The beginning of a run: at the same pair in every scalar.

#include "gjk/support.hpp"

namespace gjk {

/// The pair that a run starts from when it is given none: the support point of Z along the line
/// between the centers of the shapes. It is chosen in double, whatever the run computes in, so that
/// runs of one query start alike in every scalar. Only queries that double cannot hold choose for
/// themselves.
template <class R, class S, int D>
[[nodiscard]] VertexPair first_pair(const Query<S, D>& query, const Prepared<R, D>& prepared) {
  const auto chosen = [](const auto& asked, const auto& in) {
    return farthest_pair(asked, in, (-in.offset).eval());
  };
  if constexpr (ScalarTraits<S>::kExact) {
    std::array<std::vector<Vec<double, D>>, 2> points;
    const auto shape = [](const Shape<S, D>& exact, std::vector<Vec<double, D>>& rounded) {
      for (const Vec<S, D>& point : exact.vertices()) rounded.push_back(converted<double>(point));
      return Shape<double, D>(rounded, {exact.pose.rotation.matrix().template cast<double>(),
                                        converted<double>(exact.pose.translation)});
    };
    const Query<double, D> in_double{shape(query.x, points[0]), shape(query.y, points[1])};
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
