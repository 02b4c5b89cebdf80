#pragma once
// The face that holds P when rounding makes the region tests unbelievable.

#include <algorithm>

#include "gjk/simplex.hpp"

namespace gjk {

/// The face with the point nearest to O, among the vertices and all faces that O projects into.
template <class R, int D>
[[nodiscard, gnu::noinline]] Face nearest_face(const Simplex<R, D>& simplex) {
  Face best = 0;
  R best_sq(0);
  for (Face face = 1; face <= simplex.all(); ++face) {
    const FaceVertices& in_face = vertices_of(face);
    const Barycentric<R, D> coordinates = barycentric(simplex, face);
    const bool projects_into = std::all_of(in_face.begin(), in_face.end(),
                                           [&](int i) { return R(0) < coordinates.numerator[i]; });
    if (!projects_into) continue;
    std::array<R, D + 1> weights{};
    set_weights(weights, face, coordinates);
    const Vec<R, D> point = weighted_point(simplex, face, weights);
    const R point_sq = dot(point, point);
    if (best == 0 || point_sq < best_sq) {
      best = face;
      best_sq = point_sq;
    }
  }
  return best;
}

/// The largest magnitude of a coordinate of the simplex.
template <class R, int D>
[[nodiscard]] R largest_coordinate(const Simplex<R, D>& simplex) {
  R size(0);
  for (int i = 0; i < simplex.count; ++i) size = larger(size, norm_max(simplex.vertices[i].w));
  return size;
}

/// True when the simplex's weights put P at O, up to so many roundings of its largest coordinate.
template <class R, int D>
[[nodiscard]] bool is_at_origin(const Simplex<R, D>& simplex, const std::array<R, D + 1>& weights,
                                int roundings) {
  const R rounding = R(roundings) * ScalarTraits<R>::unit_roundoff() * largest_coordinate(simplex);
  return !(rounding < norm_max(weighted_point(simplex, simplex.all(), weights)));
}

/// True when the weights of a full simplex put P at O up to rounding. When false, the simplex is so
/// thin that its volumes, and their signs, may be rounding errors. A weight errs by the D roundings
/// of the sum of all volumes and its own quotient, a coordinate of P by a product and D sums: 2 D +
/// 2 in all. Twice as many are let pass, for those of the volumes of a simplex that is not thin.
template <class R, int D>
[[nodiscard]] bool weights_reach_origin(const Simplex<R, D>& simplex,
                                        const Barycentric<R, D>& coordinates) {
  if constexpr (ScalarTraits<R>::kExact) {
    return true;
  } else {
    std::array<R, D + 1> weights{};
    set_weights(weights, simplex.all(), coordinates);
    return is_at_origin(simplex, weights, 4 * D + 4);
  }
}

}  // namespace gjk
