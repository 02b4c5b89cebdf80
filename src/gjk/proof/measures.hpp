#pragma once
// Measures of all points of a shape: where they lie, how far they reach, and whether `climb` can
// find the support points of a large polygon.

#include <algorithm>
#include <span>

#include "gjk/proof/ring.hpp"

namespace gjk {

/// In the shape's own frame and unit. For exact scalars all members keep their defaults.
template <class S, int D>
struct Measures {
  /// Runs see the points from here, so that rounding follows their size and not their place: the
  /// middle of their box if they lie far from their frame's origin, else that origin.
  Vec<S, D> centre = Vec<S, D>::Zero();
  bool is_centred = false;  ///< `centre` is the middle of the box.
  bool is_finite = true;    ///< No coordinate is a NaN or an infinity.
  /// kRingFrom points or more, the corners of a strictly convex polygon in order. Plane only.
  bool is_ring = false;
  S largest = S(0);  ///< The largest magnitude of a coordinate.
  S radius = S(0);   ///< Distance from `centre` to the farthest point, up to a rounding or two.
  S to_mean = S(0);  ///< Distance from `centre` to the mean of the points, equally exact.
  /// Indices of two points that lie at least as far apart as the longest side of the box.
  std::array<int, 2> far_apart = {};
};

/// The length of a vector whose squares may overflow or underflow.
template <class S, int D>
[[nodiscard]] S careful_length(const Vec<S, D>& a) {
  const S square = dot(a, a);
  if (ScalarTraits<S>::is_in_range(square)) [[likely]]
    return ScalarTraits<S>::root(square);
  const S size = norm_max(a);
  if (size == S(0)) return size;
  const int exponent = ScalarTraits<S>::exponent(size);
  Vec<S, D> in_unit;
  for (int i = 0; i < D; ++i) in_unit[i] = ScalarTraits<S>::scaled(a[i], -exponent);
  return ScalarTraits<S>::scaled(length(in_unit), exponent);
}

/// a * 2^exponent, but rounded up where it is denormal and rounds.
template <class R>
[[nodiscard]] R scaled_above(const R& a, int exponent) {
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool below = ScalarTraits<R>::scaled(out, -exponent) < a;
  return below ? R(out + std::numeric_limits<R>::denorm_min()) : out;
}
/// a * 2^exponent, but rounded down where it is denormal and rounds.
template <class R>
[[nodiscard]] R scaled_below(const R& a, int exponent) {
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool above = a < ScalarTraits<R>::scaled(out, -exponent);
  return above ? R(out - std::numeric_limits<R>::denorm_min()) : out;
}

namespace detail {

/// Sets radius and to_mean. Computes in units of about `size`, the largest distance from the centre
/// along an axis, so that no square overflows and none that matters underflows.
template <class S, int D>
void measure_size(std::span<const Vec<S, D>> points, const S& size, Measures<S, D>& out) {
  using Traits = ScalarTraits<S>;
  const int exponent = Traits::exponent(size);
  S radius_sq(0);
  Vec<S, D> sum = Vec<S, D>::Zero();
  for (const Vec<S, D>& point : points) {
    Vec<S, D> scaled;
    for (int i = 0; i < D; ++i) scaled[i] = Traits::scaled(S(point[i] - out.centre[i]), -exponent);
    radius_sq = std::max(radius_sq, dot(scaled, scaled));
    sum = sum + scaled;
  }
  out.radius = scaled_above(Traits::root(radius_sq), exponent);
  out.to_mean =
      scaled_above(S(Traits::root(dot(sum, sum)) / static_cast<S>(points.size())), exponent);
}

}  // namespace detail

/// The measures of some points.
template <class S, int D>
[[nodiscard, gnu::noinline]] Measures<S, D> measured(std::span<const Vec<S, D>> points) {
  Measures<S, D> out;
  if constexpr (!ScalarTraits<S>::kExact) {
    if (points.empty()) return out;
    Vec<S, D> low = points[0];
    Vec<S, D> high = points[0];
    for (const Vec<S, D>& point : points) {
      out.is_finite = out.is_finite && is_finite(point);
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    int longest = 0;
    (high / S(2) - low / S(2)).maxCoeff(&longest);
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      if (points[i][longest] == low[longest]) out.far_apart[0] = i;
      if (points[i][longest] == high[longest]) out.far_apart[1] = i;
    }
    out.largest = std::max(norm_max(low), norm_max(high));
    const Vec<S, D> middle = low / S(2) + high / S(2);
    out.is_centred = norm_max(Vec<S, D>(high - middle)) < norm_max(middle);
    if (out.is_centred) out.centre = middle;
    const S size =
        std::max(norm_max(Vec<S, D>(high - out.centre)), norm_max(Vec<S, D>(low - out.centre)));
    if (out.is_finite && S(0) < size && ScalarTraits<S>::is_finite(size)) {
      detail::measure_size(points, size, out);
    }
    if constexpr (D == 2) {
      out.is_ring = points.size() >= kRingFrom && detail::is_strictly_convex_ring(points);
    }
  }
  return out;
}

}  // namespace gjk
