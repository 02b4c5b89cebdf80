// Bad input gives a named error and NaN where a length would stand: never a plausible number.

#include <limits>

#include "check.hpp"
#include "gjk/gjk.hpp"

namespace bad_input_test {

using gjk::Error;
using gjk::Vec;

template <class S>
struct Case {
  std::vector<Vec<S, 2>> x = {{S(0), S(0)}};
  std::vector<Vec<S, 2>> y = {{S(2), S(1)}, {S(2), S(-1)}, {S(4), S(0)}};
  gjk::Pose<S, 2> x_pose;
  gjk::Pose<S, 2> y_pose;
  gjk::Options options;
  [[nodiscard]] gjk::Query<S, 2> query() const { return {{x, x_pose}, {y, y_pose}}; }
};

template <class S>
void check_refused(Error expected, const Case<S>& bad) {
  const gjk::Result<S, 2> result = gjk::distance<S>(bad.query(), bad.options);
  CHECK_EQ(expected, result.error);
  CHECK_EQ(gjk::StopReason::failed, result.stop);
  CHECK_EQ(gjk::Verdict::none, result.verdict);
  CHECK(result.distance != result.distance);
  CHECK(result.lower != result.lower);
  CHECK(result.upper != result.upper);
  CHECK_EQ(0, result.iterations);
  const gjk::Trace<S, 2> trace = gjk::trace<S>(bad.query(), bad.options);
  CHECK_EQ(expected, trace.result.error);
  CHECK_EQ(gjk::StopReason::failed, trace.result.stop);
  CHECK(trace.result.distance != trace.result.distance);
}

template <class S>
void check_accepted(const Case<S>& good) {
  const gjk::Result<S, 2> result = gjk::distance<S>(good.query(), good.options);
  CHECK_EQ(Error::none, result.error);
  CHECK(result.distance == result.distance);
}

TEST(empty, "a shape without vertices") {
  Case<double> bad;
  bad.x.clear();
  check_refused(Error::x_has_no_vertices, bad);
  Case<double> other;
  other.y.clear();
  check_refused(Error::y_has_no_vertices, other);
}

template <class S>
void check_not_finite() {
  for (const S poison : {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity(),
                         S(-std::numeric_limits<S>::infinity())}) {
    for (int coordinate = 0; coordinate < 2; ++coordinate) {
      Case<S> bad;
      bad.x[0][coordinate] = poison;
      check_refused(Error::x_not_finite, bad);
      Case<S> last;
      last.y[2][coordinate] = poison;
      check_refused(Error::y_not_finite, last);
      Case<S> moved;
      moved.x_pose.translation[coordinate] = poison;
      check_refused(Error::x_not_finite, moved);
      Case<S> turned;
      Eigen::Matrix<S, 2, 2> poisoned = Eigen::Matrix<S, 2, 2>::Identity();
      poisoned(1, coordinate) = poison;
      turned.y_pose.rotation = poisoned;
      check_refused(Error::y_not_finite, turned);
    }
  }
}

TEST(not_finite, "NaN or infinity in a vertex or a pose, in every scalar") {
  check_not_finite<Eigen::half>();
  check_not_finite<float>();
  check_not_finite<double>();
  check_not_finite<long double>();
}

/// Y moved `factor` times as far from X as in `Case`.
template <class S>
void check_moved(S factor, Error expected) {
  for (const S sign : {S(1), S(-1)}) {
    const check::Context context("factor", static_cast<double>(factor), "sign",
                                 static_cast<double>(sign), "bytes", sizeof(S));
    Case<S> moved;
    for (Vec<S, 2>& vertex : moved.y) vertex *= S(sign * factor);
    if (expected == Error::none) {
      check_accepted(moved);
    } else {
      check_refused(expected, moved);
    }
  }
}

TEST(large, "coordinates up to the largest number are answered, whatever their products are") {
  check_moved(1e19f, Error::none);
  check_moved(8e37f, Error::none);
  check_moved(1e200, Error::none);
  check_moved(4e307, Error::none);
  check_moved(2.9e4931L, Error::none);
  check_moved(Eigen::half(16000.0f), Error::none);
}

TEST(small, "coordinates down to the smallest number are answered; in half they have no room") {
  check_moved(1e-30f, Error::none);
  check_moved(1e-45f, Error::none);
  check_moved(1e-200, Error::none);
  check_moved(5e-324, Error::none);
  check_moved(3.7e-4951L, Error::none);
  check_moved(Eigen::half(1.0f), Error::none);
  check_moved(Eigen::half(6e-8f), Error::underflow);
}

template <class S>
void check_too_far_apart() {
  const S most = std::numeric_limits<S>::max();
  Case<S> bad;
  bad.x = {{S(-most), S(0)}};
  bad.y = {{most, S(0)}};
  check_refused(Error::overflow, bad);
  Case<S> moved;
  moved.x_pose.translation[1] = -most;
  moved.y_pose.translation[1] = most;
  check_refused(Error::overflow, moved);
  bad.x[0][0] = S(most / S(-4));
  bad.y[0][0] = S(most / S(2));
  check_accepted(bad);
}

TEST(overflow, "a distance that overflows is an error; half the largest number is none") {
  check_too_far_apart<Eigen::half>();
  check_too_far_apart<float>();
  check_too_far_apart<double>();
  check_too_far_apart<long double>();
}

TEST(overflow_pose, "a pose that overflows is refused; a huge common translation is not") {
  Case<float> common;
  common.x_pose.translation = common.y_pose.translation = Vec<float, 2>(1e9f, 1e9f);
  check_accepted(common);
  Case<float> rotation;
  rotation.x[0] = Vec<float, 2>(1e9f, 1e9f);
  rotation.x_pose.rotation = Eigen::Matrix2f::Identity() * 1e30f;
  check_refused(Error::overflow, rotation);
}

TEST(infinite_pose, "an infinite translation is refused, even one that both shapes share") {
  for (const double far : {0.0, 1e6}) {  // far from their origins, points are centered
    Case<double> bad;
    for (auto* points : {&bad.x, &bad.y}) {
      for (auto& point : *points) point += Vec<double, 2>(far, far);
    }
    bad.x_pose.translation[0] = std::numeric_limits<double>::infinity();
    check_refused(Error::x_not_finite, bad);
    bad.y_pose.translation[0] = std::numeric_limits<double>::infinity();
    check_refused(Error::x_not_finite, bad);
    bad.x_pose.translation[0] = 0;
    check_refused(Error::y_not_finite, bad);
  }
}

TEST(all_zero, "shapes that are all one point at the origin are answered") {
  Case<float> same;
  same.y = {{0, 0}, {0, 0}};
  check_accepted(same);
  CHECK_EQ(0.0f, gjk::distance<float>(same.query()).distance);
  CHECK_EQ(gjk::StopReason::zero_direction, gjk::distance<float>(same.query()).stop);
}

TEST(all_zero_verdict, "a point on itself touches it, at the origin as elsewhere") {
  for (const float at : {3.0f, 0.0f}) {
    Case<float> same;
    same.x = {{at, at}};
    same.y = {{at, at}};
    CHECK_EQ(gjk::Verdict::touching, gjk::distance(same.query()).verdict);
  }
}

TEST(start, "start pairs that name no vertex, or too few or too many of them") {
  for (const int count : {-1, 4, 5, 1000000}) {
    const check::Context context("count", count);
    Case<double> bad;
    bad.options.start.count = count;
    check_refused(Error::bad_start, bad);
  }
  for (const gjk::VertexPair pair : {gjk::VertexPair{1, 0}, gjk::VertexPair{0, 3},
                                     gjk::VertexPair{-1, 0}, gjk::VertexPair{0, -1}}) {
    const check::Context context("pair", pair.x, pair.y);
    Case<double> bad;
    bad.options.start.count = 2;
    bad.options.start.pairs[1] = pair;
    check_refused(Error::bad_start, bad);
    bad.options.start.count = 0;  // does not read them
    check_accepted(bad);
  }
}

TEST(options, "a cap below 1, or a tolerance outside [0, 1)") {
  for (const int cap : {0, -1}) {
    Case<double> bad;
    bad.options.iteration_cap = cap;
    check_refused(Error::bad_options, bad);
  }
  for (const double tolerance : {-0.1, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    const check::Context context("tolerance", tolerance);
    Case<double> bad;
    bad.options.tolerance = tolerance;
    check_refused(Error::bad_options, bad);
  }
}

TEST(first, "of several faults the first is named: vertices before numbers before options") {
  Case<double> bad;
  bad.y.clear();
  bad.x[0][0] = std::numeric_limits<double>::quiet_NaN();
  bad.options.iteration_cap = 0;
  check_refused(Error::y_has_no_vertices, bad);
  bad.y = {{1, 1}};
  check_refused(Error::x_not_finite, bad);
}

}  // namespace bad_input_test
