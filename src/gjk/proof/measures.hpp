#pragma once
// Measures of all points of a shape: where they lie, how far they reach, and whether `climb` can
// find the support points of a large polygon.

#include <span>

#include "gjk/vector.hpp"

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
/// True when no entry of a vector or matrix is a NaN or an infinity.
template <class S, int rows, int columns>
[[nodiscard]] bool is_finite(const Eigen::Matrix<S, rows, columns>& a) {
  return a.unaryExpr([](const S& entry) { return ScalarTraits<S>::is_finite(entry); }).all();
}

/// a * 2^exponent.
template <class S, int D>
[[nodiscard]] Vec<S, D> scaled(const Vec<S, D>& a, int exponent) {
  Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = ScalarTraits<S>::scaled(a[i], exponent);
  return out;
}

/// Convex polygons of at least so many vertices are climbed, not scanned. core-compare in
/// tests/bench times both at 1,024 vertices.
inline constexpr std::size_t kRingFrom = 32;

namespace detail {

/// True when all turns go the same way beyond rounding, and the edges go round once. Needs two
/// points. A turn is left - right: edges round once each, products once, their difference once, by
/// 4 u (|left| + |right|) in all; twice as much is demanded.
template <class S>
[[nodiscard]] bool is_strictly_convex_ring(std::span<const Vec<S, 2>> points) {
  const auto goes_up = [](const Vec<S, 2>& edge) {
    return S(0) < edge[1] || (edge[1] == S(0) && S(0) < edge[0]);
  };
  const std::size_t count = points.size();
  std::size_t left_turns = 0;
  int crossings = 0;
  Vec<S, 2> before = points[count - 1] - points[count - 2];
  bool went_up = goes_up(before);
  Vec<S, 2> from = points[count - 1];
  for (const Vec<S, 2>& point : points) {
    const Vec<S, 2> edge = point - from;
    const S left = before[0] * edge[1];
    const S right = before[1] * edge[0];
    const S rounding =
        S(8) * ScalarTraits<S>::unit_roundoff() * (magnitude(left) + magnitude(right));
    if (!(rounding < magnitude(S(left - right))) || !(S(0) < rounding)) return false;
    const bool is_up = goes_up(edge);
    left_turns += right < left ? 1 : 0;
    crossings += is_up != went_up ? 1 : 0;
    before = edge;
    went_up = is_up;
    from = point;
  }
  return crossings == 2 && (left_turns == 0 || left_turns == count);
}

/// The farthest vertex so far; of equal ones the one of lowest index.
template <class R>
struct Farthest {
  int index = -1;
  R value = R(0);

  bool offer(int i, const R& offered) {
    const bool improves = index < 0 || value < offered || (value == offered && i < index);
    if (improves) *this = {i, offered};
    return improves;
  }
};

/// The vertex of a convex ring that lies farthest, of equal ones the first. Along a direction the
/// vertices rise to one summit and fall to one valley: from the best of some samples the search
/// goes both ways until the fall exceeds `rounding`, the error of a difference of two values: then
/// it has seen every vertex as high as that sample.
template <class R, class Along>
[[nodiscard, gnu::noinline]] int climb(int count, const Along& along, const R& rounding) {
  int stride = 1;
  while (stride * stride < count) stride *= 2;
  Farthest<R> farthest;
  for (int i = 0; i < count; i += stride) farthest.offer(i, along(i));
  const int summit = farthest.index;
  for (const int towards : {1, count - 1}) {
    for (int i = (summit + towards) % count; i != summit; i = (i + towards) % count) {
      const R value = along(i);
      farthest.offer(i, value);
      if (value < farthest.value - rounding) break;
    }
  }
  return farthest.index;
}

}  // namespace detail

/// In the shape's own frame and unit. For exact scalars all members keep their defaults.
template <class S, int D>
struct Measures {
  /// A run subtracts this point from every vertex, so that rounding depends on the shape's size and
  /// not on its place: the middle of its box if it lies far from its frame's origin, else that
  /// origin.
  Vec<S, D> center = Vec<S, D>::Zero();
  bool is_centered = false;  ///< `center` is the middle of the box.
  bool is_finite = true;     ///< No coordinate is a NaN or an infinity.
  /// kRingFrom points or more, the corners of a strictly convex polygon in order. Plane only.
  bool is_ring = false;
  S largest = S(0);  ///< The largest magnitude of a coordinate.
  S radius = S(0);   ///< Distance from `center` to the farthest point, up to a rounding or two.
  S to_mean = S(0);  ///< Distance from `center` to the mean of the points, equally exact.
  /// Indices of two points that lie at least as far apart as the longest side of the box.
  std::array<int, 2> far_apart = {};

  Measures() = default;
  explicit Measures(std::span<const Vec<S, D>> points);
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
  return ScalarTraits<S>::scaled(length(scaled(a, -exponent)), exponent);
}

/// a * 2^exponent, but rounded up, or down, where it is denormal and rounds.
template <class R>
[[nodiscard]] R scaled_above(const R& a, int exponent) {
  if (exponent == 0) [[likely]]
    return a;
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool below = ScalarTraits<R>::scaled(out, -exponent) < a;
  return below ? R(out + std::numeric_limits<R>::denorm_min()) : out;
}
template <class R>
[[nodiscard]] R scaled_below(const R& a, int exponent) {
  return -scaled_above(R(-a), exponent);
}

namespace detail {

/// Sets radius and to_mean. If squares would come near overflow or underflow it computes in
/// units of about `size`, the largest distance from the center along an axis.
template <class S, int D>
void measure_size(std::span<const Vec<S, D>> points, const S& size, Measures<S, D>& out) {
  using Traits = ScalarTraits<S>;
  const S sum_size = size * static_cast<S>(points.size());
  const bool fits = std::numeric_limits<S>::max_exponent > 100 && Traits::is_in_range(size) &&
                    Traits::is_in_range(sum_size);  // squares of half have no room
  const int exponent = fits ? 0 : Traits::exponent(size);
  const Vec<S, D> center = out.center;
  S radius_sq(0);
  Vec<S, D> sum = Vec<S, D>::Zero();
  for (const Vec<S, D>& point : points) {
    Vec<S, D> from_center = point - center;
    if (exponent != 0) [[unlikely]]
      from_center = scaled(from_center, -exponent);
    radius_sq = larger(radius_sq, dot(from_center, from_center));
    sum = sum + from_center;
  }
  out.radius = scaled_above(Traits::root(radius_sq), exponent);
  out.to_mean =
      scaled_above(S(Traits::root(dot(sum, sum)) / static_cast<S>(points.size())), exponent);
}

}  // namespace detail

template <class S, int D>
[[gnu::noinline]] Measures<S, D>::Measures(std::span<const Vec<S, D>> points) {
  if constexpr (!ScalarTraits<S>::kExact) {
    if (points.empty()) return;
    Vec<S, D> low = points[0];
    Vec<S, D> high = points[0];
    Vec<S, D> nothing = Vec<S, D>::Zero();  // a NaN once a coordinate is not finite
    for (const Vec<S, D>& point : points) {
      nothing = nothing + (point - point);  // NOLINT(misc-redundant-expression): 0, or NaN
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    is_finite = is_zero(nothing);
    const Vec<S, D> half_box = high / S(2) - low / S(2);
    int longest = 0;
    for (int i = 1; i < D; ++i) longest = half_box[longest] < half_box[i] ? i : longest;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const S at = points[i][longest];
      far_apart[0] = at == low[longest] ? i : far_apart[0];
      far_apart[1] = at == high[longest] ? i : far_apart[1];
    }
    largest = larger(norm_max(low), norm_max(high));
    const Vec<S, D> middle = low / S(2) + high / S(2);
    is_centered = norm_max(Vec<S, D>(high - middle)) < norm_max(middle);
    if (is_centered) center = middle;
    const S size = larger(norm_max(Vec<S, D>(high - center)), norm_max(Vec<S, D>(low - center)));
    if (is_finite && S(0) < size && ScalarTraits<S>::is_finite(size)) {
      detail::measure_size(points, size, *this);
    }
    if constexpr (D == 2) {
      is_ring = points.size() >= kRingFrom && detail::is_strictly_convex_ring(points);
    }
  }
}

}  // namespace gjk
