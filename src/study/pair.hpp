#pragma once
// A pair of shapes with vertices of its own, and what can be done with it. Needs the core alone.

#include <algorithm>
#include <cmath>
#include <vector>

#include "gjk/gjk.hpp"

namespace families {

using gjk::Vec;

/// A query that owns its vertices, in the plane or in space.
template <class S, int D = 2>
struct Pair {
  std::vector<Vec<S, D>> x;
  std::vector<Vec<S, D>> y;
  gjk::Pose<S, D> x_pose = {};
  gjk::Pose<S, D> y_pose = {};
  [[nodiscard]] gjk::Query<S, D> query() const { return {{x, x_pose}, {y, y_pose}}; }
};

/// The pair with X and Y in the other order.
template <class S, int D>
[[nodiscard]] Pair<S, D> swapped(const Pair<S, D>& pair) {
  return {pair.y, pair.x, pair.y_pose, pair.x_pose};
}

/// The pair with its vertex lists rotated by `x` and `y` places.
template <class S, int D>
[[nodiscard]] Pair<S, D> rotated(Pair<S, D> pair, std::size_t x, std::size_t y) {
  std::rotate(pair.x.begin(), pair.x.begin() + static_cast<long>(x % pair.x.size()), pair.x.end());
  std::rotate(pair.y.begin(), pair.y.begin() + static_cast<long>(y % pair.y.size()), pair.y.end());
  return pair;
}

/// The pair in another scalar.
/// Not inlined: where two conversions there and back stand side by side, GCC 12 leaves the rounding
/// out.
template <class To, class From, int D>
[[nodiscard, gnu::noinline]] Pair<To, D> converted(const Pair<From, D>& pair) {
  Pair<To, D> out;
  const auto convert = [](const Vec<From, D>& v) {
    Vec<To, D> to;
    for (int i = 0; i < D; ++i) to[i] = static_cast<To>(v[i]);
    return to;
  };
  for (const Vec<From, D>& vertex : pair.x) out.x.push_back(convert(vertex));
  for (const Vec<From, D>& vertex : pair.y) out.y.push_back(convert(vertex));
  const auto convert_pose = [](const gjk::Pose<From, D>& pose) {
    return gjk::Pose<To, D>{pose.rotation.matrix().template cast<To>(),
                            pose.translation.template cast<To>()};
  };
  out.x_pose = convert_pose(pair.x_pose);
  out.y_pose = convert_pose(pair.y_pose);
  return out;
}

/// The pair with the floats that lie nearest to its numbers.
template <int D>
[[nodiscard]] Pair<double, D> rounded_to_floats(const Pair<double, D>& pair) {
  return converted<double>(converted<float>(pair));
}

/// Largest distance between a vertex of X and one of Y.
template <class S, int D>
[[nodiscard]] double scale_of(const Pair<S, D>& pair) {
  double scale = 0;
  for (const Vec<S, D>& x : pair.x) {
    for (const Vec<S, D>& y : pair.y) {
      const Vec<S, D> z = (pair.y_pose.rotated(y) - pair.x_pose.rotated(x)) +
                          (pair.y_pose.translation - pair.x_pose.translation);
      double length = 0;
      for (int i = 0; i < D; ++i) length = std::hypot(length, static_cast<double>(z[i]));
      scale = std::max(scale, length);
    }
  }
  return scale;
}

/// The pair's distance, computed in R.
template <class R, class S, int D>
[[nodiscard]] gjk::Result<R, D> run(const Pair<S, D>& pair) {
  return gjk::distance<R>(pair.query());
}

}  // namespace families
