#pragma once
// Vectors, and the few products that GJK needs. Sums run in index order and without fused
// multiply-add, so that every compiler and build type decides the same.

#include <Eigen/Core>
#include <array>

#include "gjk/proof/scalar.hpp"

namespace gjk {

/// A point or direction in dimension D.
template <class S, int D>
using Vec = Eigen::Matrix<S, D, 1>;

template <class S, int D>
[[nodiscard]] S dot(const Vec<S, D>& a, const Vec<S, D>& b) {
  S sum = a[0] * b[0];
  for (int i = 1; i < D; ++i) sum = sum + S(a[i] * b[i]);
  return sum;
}

/// The third coordinate of a x b: twice the signed area of the triangle (O, a, b).
template <class S>
[[nodiscard]] S cross(const Vec<S, 2>& a, const Vec<S, 2>& b) {
  return S(a[0] * b[1]) - S(a[1] * b[0]);
}
template <class S>
[[nodiscard]] Vec<S, 3> cross(const Vec<S, 3>& a, const Vec<S, 3>& b) {
  return Vec<S, 3>(S(a[1] * b[2]) - S(a[2] * b[1]), S(a[2] * b[0]) - S(a[0] * b[2]),
                   S(a[0] * b[1]) - S(a[1] * b[0]));
}

/// D! times the signed volume of the simplex (O, columns[0], ..., columns[D-1]).
template <class S, int D>
[[nodiscard]] S determinant(const std::array<Vec<S, D>, D>& columns) {
  if constexpr (D == 2) {
    return cross(columns[0], columns[1]);
  } else {
    return dot(columns[0], cross(columns[1], columns[2]));
  }
}

/// A vector perpendicular to all `edges`, computed without a division. In the plane it is edge x z,
/// with z the plane's normal, and as long as the edge (Catto 2010, slide "An accurate search
/// direction"); in space its length is the area of the edges' parallelogram. Its sign is arbitrary.
template <class S, int D>
[[nodiscard]] Vec<S, D> perpendicular(const std::array<Vec<S, D>, D - 1>& edges) {
  if constexpr (D == 2) {
    return Vec<S, 2>(edges[0][1], -edges[0][0]);
  } else {
    return cross(edges[0], edges[1]);
  }
}

template <class S>
[[nodiscard]] S magnitude(const S& a) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::abs(a);
  } else {
    return a < S(0) ? S(-a) : a;
  }
}

/// std::max and std::min by value, which compilers turn into one instruction.
template <class S>
[[nodiscard]] S larger(S a, S b) {
  return a < b ? b : a;
}
template <class S>
[[nodiscard]] S smaller(S a, S b) {
  return b < a ? b : a;
}

/// Sum of the magnitudes of the coordinates.
template <class S, int D>
[[nodiscard]] S norm_1(const Vec<S, D>& a) {
  S sum(0);
  for (int i = 0; i < D; ++i) sum = sum + magnitude(S(a[i]));
  return sum;
}
template <class S, int D>
[[nodiscard]] auto length(const Vec<S, D>& a) {
  return ScalarTraits<S>::root(dot(a, a));
}

template <class S, int D>
[[nodiscard]] bool is_zero(const Vec<S, D>& a) {
  return (a.array() == S(0)).all();
}

}  // namespace gjk
