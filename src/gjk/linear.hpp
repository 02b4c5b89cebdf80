#pragma once
// Vectors, and the few products that GJK is made of. Sums run in index order, without fused
// multiply-add (the target gjkscope::gjk switches contraction off), so that every compiler and
// build type takes the same decisions.

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>

#include "gjk/scalar.hpp"

namespace gjk {

/// Two numbers side by side, for processors that compute with both at once: a vector of the plane,
/// or a number of each of two vertices.
using Two [[gnu::vector_size(16)]] = double;
using TwoMasks [[gnu::vector_size(16)]] = long long;

/// Two numbers that stand in memory at a multiple of 16 bytes.
[[nodiscard]] inline Two two_at(const double* from) {
#ifdef __SSE2__
  return _mm_load_pd(from);
#else
  return Two{from[0], from[1]};
#endif
}

/// A point or direction in dimension D.
template <class S, int D>
using Vec = Eigen::Matrix<S, D, 1>;

/// A vector of the plane as two numbers: for types that Eigen does not know, and for values that
/// stay in registers where Eigen's go through memory.
template <class N>
struct Flat {
  N x;
  N y;

  friend Flat operator-(const Flat& a, const Flat& b) { return {N(a.x - b.x), N(a.y - b.y)}; }
  friend Flat operator-(const Flat& a) { return {N(-a.x), N(-a.y)}; }
};
template <class N>
[[nodiscard]] N dot(const Flat<N>& a, const Flat<N>& b) {
  return N(a.x * b.x) + N(a.y * b.y);
}
template <class N>
[[nodiscard]] N cross(const Flat<N>& a, const Flat<N>& b) {
  return N(a.x * b.y) - N(a.y * b.x);
}
template <class S>
[[nodiscard]] Flat<S> flat(const Vec<S, 2>& a) {
  return {a[0], a[1]};
}

/// The same coordinates in another scalar; in the same one, the vector itself.
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

/// Both coordinates at once.
template <class S>
[[nodiscard]] Two two(const Vec<S, 2>& a) {
  if constexpr (std::is_same_v<S, double> && alignof(Vec<S, 2>) >= alignof(Two)) {
    return two_at(a.data());
  } else {
    return Two{static_cast<double>(a[0]), static_cast<double>(a[1])};
  }
}

template <class S, int D>
[[nodiscard]] S dot(const Vec<S, D>& a, const Vec<S, D>& b) {
  S sum = a[0] * b[0];
  for (int i = 1; i < D; ++i) sum = sum + S(a[i] * b[i]);
  return sum;
}

template <class S>
[[nodiscard]] S magnitude(const S& a) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::abs(a);
  } else {
    return a < S(0) ? S(-a) : a;
  }
}

/// 1 with the sign of a.
template <class S>
[[nodiscard]] S sign_of(const S& a) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::copysign(S(1), a);
  } else {
    return a < S(0) ? S(-1) : S(1);
  }
}

/// Sum of the coordinates' magnitudes.
template <class S, int D>
[[nodiscard]] S norm_1(const Vec<S, D>& a) {
  S sum(0);
  for (int i = 0; i < D; ++i) sum = sum + magnitude(S(a[i]));
  return sum;
}

/// As std::max and std::min, which compilers make a branch of.
template <class S>
[[nodiscard]] S larger(S a, S b) {
#ifdef __SSE2__
  if constexpr (std::is_same_v<S, double>) {
    return _mm_cvtsd_f64(_mm_max_sd(_mm_set_sd(b), _mm_set_sd(a)));
  }
#endif
  return a < b ? b : a;
}
template <class S>
[[nodiscard]] S smaller(S a, S b) {
#ifdef __SSE2__
  if constexpr (std::is_same_v<S, double>) {
    return _mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(b), _mm_set_sd(a)));
  }
#endif
  return b < a ? b : a;
}

/// Largest of the coordinates' magnitudes.
template <class S, int D>
[[nodiscard]] S norm_max(const Vec<S, D>& a) {
  S largest(0);
  for (int i = 0; i < D; ++i) largest = larger(largest, magnitude(S(a[i])));
  return largest;
}

template <class S, int D>
[[nodiscard]] auto length(const Vec<S, D>& a) {
  return ScalarTraits<S>::root(dot(a, a));
}
template <class S>
[[nodiscard]] S length(const Flat<S>& a) {
  return ScalarTraits<S>::root(dot(a, a));
}

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

/// Square roots of two numbers, at once where the processor can.
template <class S>
[[nodiscard]] Flat<S> roots(const S& a, const S& b) {
#ifdef __SSE2__
  if constexpr (std::is_same_v<S, double>) {
    const __m128d both = _mm_sqrt_pd(_mm_setr_pd(a, b));
    return {_mm_cvtsd_f64(both), _mm_cvtsd_f64(_mm_unpackhi_pd(both, both))};
  }
#endif
  return {ScalarTraits<S>::root(a), ScalarTraits<S>::root(b)};
}

template <class S, int D>
[[nodiscard]] bool is_zero(const Vec<S, D>& a) {
#ifdef __SSE2__
  if constexpr (D == 2 && std::is_same_v<S, double>) {
    return _mm_movemask_pd(_mm_cmpneq_pd(two<S>(a), _mm_setzero_pd())) == 0;
  }
#endif
  for (int i = 0; i < D; ++i) {
    if (a[i] != S(0)) return false;
  }
  return true;
}

template <class S, int D>
[[nodiscard]] bool is_finite(const Vec<S, D>& a) {
  for (int i = 0; i < D; ++i) {
    if (!ScalarTraits<S>::is_finite(a[i])) return false;
  }
  return true;
}

/// D! times the signed volume of the simplex (O, columns[0], ..., columns[D-1]). In the plane:
/// cross(a, b).
template <class S, int D>
[[nodiscard]] S determinant(const std::array<Vec<S, D>, D>& columns) {
  Eigen::Matrix<S, D, D> matrix;
  for (int i = 0; i < D; ++i) matrix.col(i) = columns[i];
  return matrix.determinant();
}

/// A vector perpendicular to all `edges`, computed without a division. In the plane it is the cross
/// product of the edge with z, the plane's normal (Catto 2010, slide "An accurate search
/// direction"). Its length is that of the edge (in 3D, twice the area that the edges span); its
/// sign is arbitrary.
template <class S, int D>
[[nodiscard]] Vec<S, D> perpendicular(const std::array<Vec<S, D>, D - 1>& edges) {
  static_assert(D == 2 || D == 3,
                "the cross product of D-1 vectors is written out for the plane and for space");
  if constexpr (D == 2) {
    return Vec<S, 2>(edges[0][1], -edges[0][0]);
  } else {
    const Vec<S, 3>& a = edges[0];
    const Vec<S, 3>& b = edges[1];
    return Vec<S, 3>(S(a[1] * b[2]) - S(a[2] * b[1]), S(a[2] * b[0]) - S(a[0] * b[2]),
                     S(a[0] * b[1]) - S(a[1] * b[0]));
  }
}

}  // namespace gjk
