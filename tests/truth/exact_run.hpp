#pragma once
// Runs in rationals, whose answers prove themselves: nothing else has to be believed.

#include <gtest/gtest.h>

#include "exact/rational.hpp"
#include "gjk/gjk.hpp"
#include "study/pair.hpp"

namespace gjkscope {

template <int D>
using RationalPoints = std::vector<gjk::Vec<Rational, D>>;

template <int D>
struct ExactPair {
  RationalPoints<D> x;
  RationalPoints<D> y;
  gjk::Pose<Rational, D> x_pose = {};
  gjk::Pose<Rational, D> y_pose = {};
  [[nodiscard]] gjk::Query<Rational, D> query() const { return {{x, x_pose}, {y, y_pose}}; }
};

template <class S, int D>
[[nodiscard]] gjk::Vec<Rational, D> exact(const gjk::Vec<S, D>& v) {
  gjk::Vec<Rational, D> out;
  for (int i = 0; i < D; ++i) out[i] = Rational(v[i]);
  return out;
}
template <class S, int D>
[[nodiscard]] RationalPoints<D> exact(const std::vector<gjk::Vec<S, D>>& points) {
  RationalPoints<D> out;
  for (const auto& p : points) out.push_back(exact<S, D>(p));
  return out;
}
template <class S, int D>
[[nodiscard]] gjk::Pose<Rational, D> exact(const gjk::Pose<S, D>& pose) {
  Eigen::Matrix<Rational, D, D> rotation;
  for (int i = 0; i < D; ++i) rotation.col(i) = exact<S, D>(gjk::Vec<S, D>(pose.rotation.col(i)));
  return {rotation, exact<S, D>(pose.translation)};
}

template <int D>
[[nodiscard]] ExactPair<D> exact(const families::Pair<double, D>& pair) {
  return {exact<double, D>(pair.x), exact<double, D>(pair.y), exact(pair.x_pose),
          exact(pair.y_pose)};
}

template <int D>
[[nodiscard]] RationalPoints<D> world(const RationalPoints<D>& points,
                                      const gjk::Pose<Rational, D>& pose) {
  RationalPoints<D> out;
  for (const auto& p : points) out.push_back(pose.rotated(p) + pose.translation);
  return out;
}

/// Witness points are means of vertices, so they lie in their shapes. And none are nearer to each
/// other: along the line from one to the other all of X lies before, all of Y beyond.
template <int D>
void expect_proved(const ExactPair<D>& pair, const gjk::Result<Rational, D>& result) {
  using Point = gjk::Vec<Rational, D>;
  const RationalPoints<D> x = world(pair.x, pair.x_pose);
  const RationalPoints<D> y = world(pair.y, pair.y_pose);
  Point mean_x = Point::Zero();
  Point mean_y = Point::Zero();
  Rational sum = 0;
  for (int i = 0; i < result.simplex.count; ++i) {
    const Rational& weight = result.simplex.weights[i];
    ASSERT_GE(weight, 0);
    sum += weight;
    mean_x += x[result.simplex.vertices[i].pair.x] * weight;
    mean_y += y[result.simplex.vertices[i].pair.y] * weight;
  }
  ASSERT_EQ(1, sum);
  ASSERT_TRUE(mean_x == result.x && mean_y == result.y);
  const Point normal = result.y - result.x;
  ASSERT_EQ(result.distance_sq, gjk::dot(normal, normal));
  for (const Point& p : x) ASSERT_LE(gjk::dot(normal, Point(p - result.x)), 0);
  for (const Point& p : y) ASSERT_GE(gjk::dot(normal, Point(p - result.y)), 0);
}

}  // namespace gjkscope
