#pragma once
// Equal to the last bit: zeros of either sign differ, and a NaN equals itself.

#include <cstring>

#include "gjk/gjk.hpp"

namespace check {

template <class T>
[[nodiscard]] bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}
template <class S>
[[nodiscard]] bool same_bits(const gjk::SupportPoint<S, 2>& a, const gjk::SupportPoint<S, 2>& b) {
  return same_bits(a.w, b.w) && a.pair == b.pair;
}
template <class S>
[[nodiscard]] bool same_bits(const gjk::Simplex<S, 2>& a, const gjk::Simplex<S, 2>& b) {
  bool same = a.count == b.count && same_bits(a.weights, b.weights);
  for (int i = 0; i < 3 && same; ++i) same = same_bits(a.vertices[i], b.vertices[i]);
  return same;
}
template <class S>
[[nodiscard]] bool same_bits(const gjk::Result<S, 2>& a, const gjk::Result<S, 2>& b) {
  return a.error == b.error && a.stop == b.stop && a.verdict == b.verdict &&
         a.settled == b.settled && a.iterations == b.iterations &&
         same_bits(a.distance, b.distance) && same_bits(a.lower, b.lower) &&
         same_bits(a.upper, b.upper) && same_bits(a.distance_sq, b.distance_sq) &&
         same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.simplex, b.simplex);
}

}  // namespace check
