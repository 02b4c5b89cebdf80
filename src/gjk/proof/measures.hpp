#pragma once
// Measures of all points of a shape: where they lie, how far they reach, and whether `climb` can
// find the support points of a large polygon.

#include <algorithm>
#include <span>

#include "gjk/proof/ring.hpp"

namespace gjk {

/// The vector in scalar R; a reference to it where R is its own scalar.
template <class R, class S, int D>
[[nodiscard]] decltype(auto) converted(const Vec<S, D>& a) {
  if constexpr (std::is_same_v<R, S>) {
    return (a);
  } else {
    Vec<R, D> out;
    for (int i = 0; i < D; ++i) out[i] = ScalarTraits<R>::from(a[i]);
    return out;
  }
}

/// Largest magnitude of a coordinate.
template <class S, int D>
[[nodiscard]] S norm_max(const Vec<S, D>& a) {
  S largest(0);
  for (int i = 0; i < D; ++i) largest = larger(largest, magnitude(S(a[i])));
  return largest;
}
template <class S, int D>
[[nodiscard]] bool is_finite(const Vec<S, D>& a) {
  for (int i = 0; i < D; ++i) {
    if (!ScalarTraits<S>::is_finite(a[i])) return false;
  }
  return true;
}

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
  if (exponent == 0) [[likely]]
    return a;
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

/// Sets radius and to_mean. If squares would come near overflow or underflow it computes in
/// units of about `size`, the largest distance from the centre along an axis.
template <class S, int D>
void measure_size(std::span<const Vec<S, D>> points, const S& size, Measures<S, D>& out) {
  using Traits = ScalarTraits<S>;
  const S sum_size = size * static_cast<S>(points.size());
  const bool fits = std::numeric_limits<S>::max_exponent > 100 && Traits::is_in_range(size) &&
                    Traits::is_in_range(sum_size);  // squares of half have no room
  const int exponent = fits ? 0 : Traits::exponent(size);
  const Vec<S, D> centre = out.centre;
  S radius_sq(0);
  Vec<S, D> sum = Vec<S, D>::Zero();
  for (const Vec<S, D>& point : points) {
    Vec<S, D> from_centre = point - centre;
    if (exponent != 0) [[unlikely]] {
      for (int i = 0; i < D; ++i) from_centre[i] = Traits::scaled(from_centre[i], -exponent);
    }
    radius_sq = larger(radius_sq, dot(from_centre, from_centre));
    sum = sum + from_centre;
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
    Vec<S, D> nothing = Vec<S, D>::Zero();  // a NaN once a coordinate is not finite
    for (const Vec<S, D>& point : points) {
      nothing = nothing + (point - point);  // NOLINT(misc-redundant-expression): 0, or NaN
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    out.is_finite = is_zero(nothing);
    const Vec<S, D> half_box = high / S(2) - low / S(2);
    int longest = 0;
    for (int i = 1; i < D; ++i) longest = half_box[longest] < half_box[i] ? i : longest;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const S at = points[i][longest];
      out.far_apart[0] = at == low[longest] ? i : out.far_apart[0];
      out.far_apart[1] = at == high[longest] ? i : out.far_apart[1];
    }
    out.largest = larger(norm_max(low), norm_max(high));
    const Vec<S, D> middle = low / S(2) + high / S(2);
    out.is_centred = norm_max(Vec<S, D>(high - middle)) < norm_max(middle);
    if (out.is_centred) out.centre = middle;
    const S size =
        larger(norm_max(Vec<S, D>(high - out.centre)), norm_max(Vec<S, D>(low - out.centre)));
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
