#pragma once
// What a query needs to know of all points of a shape: where they lie, how large the shape is, and
// whether a large polygon can be climbed.

#include <algorithm>
#include <span>

#include "gjk/ring.hpp"

namespace gjk {

template <class S, int D>
struct Measures {
  /// The point that the points are measured from: their own origin, or the middle of their box when
  /// they lie around neither, so that rounding follows their size and not their place.
  Vec<S, D> centre = Vec<S, D>::Zero();
  bool is_centred = false;  ///< It is not their own origin.
  bool is_finite = true;    ///< No coordinate is a NaN or an infinity.
  /// The points are the corners of a convex polygon, in order, none on the line through its
  /// neighbours. Looked for in the plane, from kRingFrom points on.
  bool is_ring = false;
  S largest = S(0);  ///< Of the magnitudes of coordinates.
  S radius = S(0);   ///< Distance from `centre` to the farthest point, up to a rounding or two.
  /// Distance from `centre` to the mean of the points, which lies in their hull; as exact.
  S to_mean = S(0);
  /// Indices of two points that lie at least as far apart as the longest side of the box.
  std::array<int, 2> far_apart = {};
};

/// a * 2^exponent, not below it where that is denormal and rounds.
template <class R>
[[nodiscard]] R scaled_above(const R& a, int exponent) {
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool below = ScalarTraits<R>::scaled(out, -exponent) < a;
  return below ? R(out + std::numeric_limits<R>::denorm_min()) : out;
}
/// a * 2^exponent, not above it where that is denormal and rounds.
template <class R>
[[nodiscard]] R scaled_below(const R& a, int exponent) {
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool above = a < ScalarTraits<R>::scaled(out, -exponent);
  return above ? R(out - std::numeric_limits<R>::denorm_min()) : out;
}

namespace detail {

/// Radius and distance to the mean, in a unit of length in which no square overflows, and none that
/// matters underflows.
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

/// Exact scalars need none of it: nothing rounds.
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
