#pragma once
// Evidence that a walk leaves behind: a point of Z bounds the distance from above, a plane from
// below. The walk itself asks it one question, whether P came nearer.

#include "gjk/proof/prepare.hpp"
#include "gjk/simplex.hpp"

namespace gjk {

template <class R, int D>
struct Evidence {
  Simplex<R, D> best;  ///< The simplex, after drop, whose P came nearest to O so far.
  R best_sq = R(0);    ///< The p_sq of `best`; meaningful once `best.count` > 0.

  /// Squared distance from O of the farthest support plane so far that separates O from Z, rounding
  /// not subtracted; 0 when no plane has separated them yet.
  R plane_distance_sq = R(0);
  R plane_reach_sq = R(0);     ///< |w|^2 of that plane's support point, to bound its rounding.
  bool touches_plane = false;  ///< Some support plane has passed through O: dot(d, w) was 0.

  /// True when p_sq is less than ever before. In exact arithmetic it always is, until P = O.
  [[nodiscard]] bool is_nearer(const R& p_sq) const {
    if (best.count == 0) return true;
    if constexpr (ScalarTraits<R>::kExact) return R(0) < best_sq;
    return p_sq < best_sq;
  }
  /// Takes the plane through the support point w with normal d; `value` is dot(d, w). All of Z lies
  /// beyond it, so -dot(d, w) / |d| is a lower bound of the distance (Larsen 1998, "Proof of Local
  /// Verification").
  void add_plane(const Vec<R, D>& d, const Vec<R, D>& w, const R& value) {
    if (value == R(0)) touches_plane = true;
    const R d_sq = dot(d, d);
    if (!(value < R(0)) || !(R(0) < d_sq)) return;
    const R distance_sq = value * R(value / d_sq);
    if (!(plane_distance_sq < distance_sq)) return;
    plane_distance_sq = distance_sq;
    plane_reach_sq = dot(w, w);
  }
};

/// The lower bound of the distance that the best support plane proves.
template <class R, int D>
[[nodiscard]] R plane_bound(const Evidence<R, D>& evidence, const Rounding<R, D>& rounding) {
  const R distance = ScalarTraits<R>::root(evidence.plane_distance_sq);
  const R reach = ScalarTraits<R>::root(evidence.plane_reach_sq);
  return larger(R(distance - rounding.plane_error(distance, reach)), R(0));
}

/// The least plane_distance_sq that certifies a tolerance, rounding subtracted.
template <class R, int D>
[[nodiscard]] R wanted_plane_distance_sq(const Evidence<R, D>& evidence, double tolerance,
                                         const Rounding<R, D>& rounding) {
  using Traits = ScalarTraits<R>;
  const R keep = Traits::from(1.0 - tolerance);
  if constexpr (Traits::kExact) {
    return keep * keep * evidence.best_sq;
  } else {
    const R upper = Traits::root_above(evidence.best_sq) + rounding.simplex_error();
    const R wanted = keep * upper + rounding.plane_error(Traits::root(evidence.plane_distance_sq),
                                                         Traits::root(evidence.plane_reach_sq));
    return wanted * wanted;
  }
}

}  // namespace gjk
