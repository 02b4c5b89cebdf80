// Poses, what is measured of points, and the options a query starts with.

#include "gjk/query.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "check.hpp"
#include "gjk/gjk.hpp"
#include "gjk/proof/error_free.hpp"

namespace query_test {

using gjk::Vec;

gjk::Pose<double, 2> quarter_turn() {
  gjk::Pose<double, 2> pose;
  pose.rotation = Eigen::Matrix2d{{0, -1}, {1, 0}};
  pose.translation = Vec<double, 2>(10, 20);
  return pose;
}

TEST(turning, "a quarter turn carries x to y; direction_to_local is its inverse") {
  const gjk::Pose<double, 2> pose = quarter_turn();
  const Vec<double, 2> turned = pose.rotated(Vec<double, 2>(1, 0));
  CHECK_EQ(0.0, turned[0]);
  CHECK_EQ(1.0, turned[1]);
  const Vec<double, 2> back = pose.direction_to_local(turned);
  CHECK_EQ(1.0, back[0]);
  CHECK_EQ(0.0, back[1]);
}

TEST(directions, "translation moves points, not directions") {
  const Vec<double, 2> local = quarter_turn().direction_to_local(Vec<double, 2>(0, 3));
  CHECK_EQ(3.0, local[0]);
  CHECK_EQ(0.0, local[1]);
}

TEST(turned, "a rotation turns when any entry is not that of the identity") {
  const auto check = [](auto zero) {
    using S = decltype(zero);
    using Matrix = Eigen::Matrix<S, 2, 2>;
    CHECK(!gjk::Rotation<S, 2>().turns());
    Matrix matrix = Matrix::Identity();
    CHECK(!gjk::Rotation<S, 2>(matrix).turns());
    for (int i = 0; i < 4; ++i) {
      Matrix turned = matrix;
      turned(i / 2, i % 2) += S(0x1p-10);
      CHECK(gjk::Rotation<S, 2>(turned).turns());
      CHECK((gjk::Rotation<S, 2>(turned).matrix() == turned));
    }
    matrix(0, 1) = -zero;
    CHECK(!gjk::Rotation<S, 2>(matrix).turns());
    matrix(1, 1) = std::numeric_limits<S>::quiet_NaN();
    CHECK(gjk::Rotation<S, 2>(matrix).turns());
  };
  check(0.0);
  check(0.0F);
}

/// A turn about each axis, by random angles.
template <int D>
Eigen::Matrix<double, D, D> random_turn(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(0, 6);
  Eigen::Matrix<double, D, D> out = Eigen::Matrix<double, D, D>::Identity();
  for (int i = 0; i < D; ++i) {
    for (int k = 0; k < i; ++k) {
      const double a = angle(random);
      Eigen::Matrix<double, D, D> turn = Eigen::Matrix<double, D, D>::Identity();
      turn(i, i) = turn(k, k) = std::cos(a);
      turn(i, k) = std::sin(a);
      turn(k, i) = -turn(i, k);
      out = turn * out;
    }
  }
  return out;
}

/// Turns, turns that lengthen one axis after another, and what is neither.
template <int D>
void measure_stretches() {
  constexpr std::uint64_t kSeed = 20100318;
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> entry(-1, 1);
  const auto stretch = [](const Eigen::Matrix<double, D, D>& rotation) {
    return gjk::Rotation<double, D>(rotation).stretch();
  };
  for (int i = 0; i < 1000; ++i) {
    const check::Context context("seed", kSeed, "dimension", D, "pose", i);
    const Eigen::Matrix<double, D, D> turn = random_turn<D>(random);
    CHECK(1 <= stretch(turn) && stretch(turn) <= 1 + 0x1p-49);
    Vec<double, D> lengths = Vec<double, D>::Ones();
    lengths[i % D] = 1.5;
    const Eigen::Matrix<double, D, D> longer = turn * lengths.asDiagonal();
    CHECK(1.5 <= stretch(longer) && stretch(longer) <= 1.625 + 0x1p-49);
    const Eigen::Matrix<double, D, D> any =
        Eigen::Matrix<double, D, D>::NullaryExpr([&] { return entry(random); });
    CHECK(any.operatorNorm() * (1 - 0x1p-40) <= stretch(any));
  }
  // All columns alike: skewed as far as can be.
  Eigen::Matrix<double, D, D> flat = Eigen::Matrix<double, D, D>::Zero();
  flat.row(0).setOnes();
  CHECK(std::sqrt(double{D}) <= stretch(flat));
}

TEST(stretch, "no vector is longer under a pose than it says, and it says 1 of a rotation") {
  measure_stretches<2>();
  measure_stretches<3>();
}

TEST(space, "poses turn in space, too") {
  gjk::Pose<float, 3> pose;
  pose.rotation = Eigen::Matrix3f{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const Vec<float, 3> turned = pose.rotated(Vec<float, 3>(1, 2, 3));
  CHECK_EQ(-2.0f, turned[0]);
  CHECK_EQ(1.0f, turned[1]);
  CHECK_EQ(3.0f, turned[2]);
}

template <class S>
using List = std::vector<Vec<S, 2>>;
template <class S>
gjk::Measures<S, 2> points(const List<S>& list) {
  return gjk::Measures<S, 2>(list);
}

/// `count` points on a circle around (x, y), counter-clockwise.
template <class S>
List<S> circle(int count, double x = 0, double y = 0) {
  List<S> out;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * (i + 0.25) / count;
    out.emplace_back(static_cast<S>(x + std::cos(angle)), static_cast<S>(y + std::sin(angle)));
  }
  return out;
}

TEST(measured, "points know their box, their center and their radius") {
  const List<double> far = {{10, 4}, {14, 4}, {12, 7}};
  CHECK_EQ(14.0, points(far).largest);
  CHECK((points(far).center == Vec<double, 2>(12, 5.5)));
  CHECK_EQ(2.5, points(far).radius);
  const List<double> around = {{-1, -2}, {3, 1}, {0, 4}};  // their origin is as good as the middle
  CHECK((points(around).center == Vec<double, 2>(0, 0)));
  CHECK_EQ(4.0, points(around).radius);
  const List<double> edge = {{0, -1}, {4, 1}};  // the middle is as far as they reach
  CHECK((points(edge).center == Vec<double, 2>(0, 0)));
  const List<double> low = {{-14, -7}, {-10, -4}};
  CHECK((points(low).center == Vec<double, 2>(-12, -5.5)));
  CHECK(points(low).is_centered && points(far).is_centered);
  CHECK(!points(around).is_centered && !points(edge).is_centered);
}

TEST(far_apart, "two points stand for the longest side of the box, wherever it lies") {
  for (const int axis : {0, 1}) {
    for (const double at : {-1000.0, 0.0, 1000.0}) {
      const check::Context context("axis", axis, "at", at);
      List<double> list = {{0, 1}, {0, 5}, {1, 3}, {0.5, 0}};
      for (Vec<double, 2>& p : list)
        p = axis == 1 ? Vec<double, 2>(p[0] + at, p[1]) : Vec<double, 2>(p[1], p[0] + at);
      CHECK((points(list).far_apart == std::array{3, 1}));
    }
  }
  CHECK((points<double>({{7, 7}}).far_apart == std::array{0, 0}));
}

TEST(means, "points know how far their mean lies from their center") {
  CHECK_EQ(0.0, points<double>({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}).to_mean);
  CHECK_EQ(5.0, points<double>({{-1, -1}, {7, -1}, {-1, 1}, {7, 17}}).to_mean);
  CHECK_EQ(0.5, points<double>({{10, 4}, {14, 4}, {12, 7}}).to_mean);  // center (12, 5.5)
  CHECK_EQ(0x1p-1040, points<double>({{0, 0}, {0x1p-1039, 0}}).to_mean);
  CHECK_EQ(0x1p1021,
           points<double>({{-0x1p1022, 0}, {0x1p1023, 0}, {0x1p1022, 0}, {0, 0}}).to_mean);
}

TEST(measured_extremes, "radii neither overflow nor underflow where points do not") {
  for (const int k : {-1070, -600, 600, 1019}) {
    const check::Context context("k", k);
    const double unit = std::ldexp(1.0, k);
    const List<double> shape = {{-3 * unit, 4 * unit}, {3 * unit, -4 * unit}, {0, 0}};
    CHECK_EQ(std::ldexp(5.0, k), points(shape).radius);
    CHECK(points(shape).is_finite);
  }
  // Denormal radii are rounded up: sqrt(2), sqrt(8) and 5 of the smallest numbers.
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const auto radius_of = [](double x, double y) {
    return points<double>({{x, y}, {-x, -y}}).radius;
  };
  CHECK_EQ(2 * kLeast, radius_of(kLeast, kLeast));
  CHECK_EQ(3 * kLeast, radius_of(2 * kLeast, 2 * kLeast));
  CHECK_EQ(5 * kLeast, radius_of(3 * kLeast, 4 * kLeast));
  CHECK_EQ(0.0, points<double>({{0, 0}, {0, 0}}).radius);
  CHECK_EQ(0.0, points<double>({{7, 7}}).radius);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK(!points<double>({{0, 0}, {0, bad}, {1, 1}}).is_finite);
  }
}

TEST(rings, "convex polygons of 32 and more corners are rings, in either sense, from any corner") {
  CHECK(!points(circle<double>(31)).is_ring);
  for (const int count : {32, 33, 100, 1024, 4096}) {
    for (const int first : {0, 1, count / 3, count - 1}) {
      const check::Context context("corners", count, "first", first);
      List<double> list = circle<double>(count, 3, -5);
      std::rotate(list.begin(), list.begin() + first, list.end());
      CHECK(points(list).is_ring);
      std::reverse(list.begin(), list.end());
      CHECK(points(list).is_ring);
    }
  }
  CHECK(points(circle<float>(32)).is_ring);
  CHECK(points(circle<float>(256)).is_ring);
}

TEST(axis_edges, "edges along the axes do not hide that a polygon goes round once") {
  for (const bool across : {false, true}) {
    List<double> list;  // the upper and the lower half of a circle, with flat top and bottom
    for (const int side : {1, -1}) {
      for (int i = 0; i < 32; ++i) {
        const double angle = 3.141592653589793 * (i + 0.5) / 32;
        list.emplace_back(side * std::cos(angle), side * std::sin(angle));
      }
    }
    if (across) {
      for (Vec<double, 2>& p : list) p = {-p[1], p[0]};
    }
    CHECK(points(list).is_ring);
    std::reverse(list.begin(), list.end());
    CHECK(points(list).is_ring);
  }
}

TEST(no_rings, "a dent, a straight or repeated corner, or more turns than one make no ring") {
  const List<double> good = circle<double>(64);
  CHECK(points(good).is_ring);
  const auto without_ring = [&](const char* what, const List<double>& list) {
    for (std::size_t first = 0; first < list.size(); ++first) {
      const check::Context context(what, "first", first);
      List<double> turned = list;
      std::rotate(turned.begin(), turned.begin() + static_cast<long>(first), turned.end());
      CHECK(!points(turned).is_ring);
    }
  };
  List<double> bad = good;
  bad[20] *= 0.99;
  without_ring("dent", bad);
  bad = good;
  bad.insert(bad.begin() + 7, (bad[6] + bad[7]) / 2);
  without_ring("straight corner", bad);
  bad = good;
  bad.insert(bad.begin() + 7, bad[7]);
  without_ring("repeated corner", bad);
  bad = good;
  std::swap(bad[3], bad[40]);
  without_ring("two corners exchanged", bad);
  bad = good;
  bad.insert(bad.end(), good.begin(), good.end());
  without_ring("twice round", bad);
  const List<double> odd = circle<double>(65);
  bad.clear();
  for (std::size_t i = 0; i < odd.size(); ++i) bad.push_back(odd[2 * i % odd.size()]);
  without_ring("star", bad);
  without_ring("one point", List<double>(40, {1, 2}));
  bad.clear();
  for (int i = 0; i < 40; ++i) bad.emplace_back(i, 2 * i);
  without_ring("line", bad);
}

TEST(flat_rings, "a corner that rounding could have bent is none") {
  // A chord of the circle with its middle pushed out by `bend`.
  const auto bent = [](double bend) {
    List<double> list = circle<double>(64, 2, 3);
    const Vec<double, 2> middle = (list[6] + list[7]) / 2;
    const Vec<double, 2> outwards = middle - Vec<double, 2>(2, 3);
    list.insert(list.begin() + 7, Vec<double, 2>(middle + outwards * bend));
    return list;
  };
  CHECK(points(bent(1e-4)).is_ring);
  CHECK(points(bent(1e-13)).is_ring);
  CHECK(!points(bent(1e-17)).is_ring);
  CHECK(!points(bent(-1e-13)).is_ring);
}

TEST(proven_rings,
     "what is called a ring is convex in exact arithmetic, wherever rounding bends it") {
  using Exact = gjk::Expansion;
  constexpr std::uint64_t kSeed = 20100319;
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> share(-1, 1);
  int rings = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const check::Context context("seed", kSeed, "trial", trial);
    // The half of a circle, and a corner on its diameter, near the origin: both edges there round.
    const double turn = share(random);
    List<double> list;
    for (int i = 0; i <= 40; ++i) {
      const double angle = turn + 3.141592653589793 * i / 40;
      list.emplace_back(std::cos(angle), std::sin(angle));
    }
    const double along = 0x1p-6 * share(random);
    const double out = 0x1p-51 * share(random);
    list.emplace_back(along * std::cos(turn) + out * std::sin(turn),
                      along * std::sin(turn) - out * std::cos(turn));
    if (!points(list).is_ring) continue;
    ++rings;
    const auto corner = [&](std::size_t i) {
      const Vec<double, 2>& p = list[i % list.size()];
      return Vec<Exact, 2>(Exact(p[0]), Exact(p[1]));
    };
    for (std::size_t i = 0; i < list.size(); ++i) {
      CHECK(Exact() < gjk::cross(Vec<Exact, 2>(corner(i + 1) - corner(i)),
                                 Vec<Exact, 2>(corner(i + 2) - corner(i + 1))));
    }
  }
  CHECK(1000 < rings && rings < 39000);
}

TEST(tiny_rings, "where products of edges underflow nothing is known of their turns") {
  List<double> list = circle<double>(64);
  for (Vec<double, 2>& p : list) p *= 0x1p-480;
  CHECK(points(list).is_ring);
  for (Vec<double, 2>& p : list) p *= 0x1p-48;
  CHECK(!points(list).is_ring);
}

TEST(shapes,
     "a shape is a view of points, with or without what is known of them; an edit is seen") {
  List<double> list = {{0, 0}, {1, 0}, {0, 1}};
  const List<double> other = {{3, 3}, {4, 3}};
  const gjk::Shape shape(list);
  CHECK(shape.measures() == nullptr);
  const double before = gjk::distance(shape, other).distance;
  CHECK_EQ(before, gjk::distance(list, other).distance);
  CHECK_EQ(before, gjk::distance(gjk::Query<double, 2>{{list}, {other}}).distance);
  const gjk::MeasuredShape measured(list);
  CHECK(gjk::Shape(measured).measures() == &measured.measures());
  list[1] = {3, 3};
  CHECK_EQ(0.0, gjk::distance(shape, other).distance);
  CHECK_EQ(before, gjk::distance(measured, other).distance);
  gjk::Pose<double, 2> pose;
  pose.translation = {100, 0};
  CHECK_EQ(gjk::distance(measured, gjk::Shape(other, pose)).distance,
           gjk::distance(measured, gjk::Shape(gjk::MeasuredShape(other).points(), pose)).distance);
}

TEST(warm_starts, "a warm start goes in and comes out, and finds the answer at once") {
  const List<double> x = circle<double>(20);
  const List<double> y = circle<double>(20, 5, 1);
  const auto cold = gjk::distance(x, y);
  const auto warm = gjk::distance(x, y, {.start = cold.warm()});
  CHECK_EQ(cold.distance, warm.distance);
  CHECK_EQ(1, warm.iterations);
  CHECK(cold.warm() == warm.warm());
}

TEST(defaults,
     "the default options are the slides': vertices first; the start is between the centers") {
  const gjk::Options options;
  CHECK_EQ(gjk::DirectionRule::perpendicular, options.direction_rule);
  CHECK_EQ(gjk::RegionOrder::vertices_first, options.region_order);
  CHECK_EQ(0, options.start.count);
  CHECK(options.stop_on_repeated_support);
  CHECK(options.stop_on_no_progress);
  CHECK_EQ(0.0, options.tolerance);
}

}  // namespace query_test
