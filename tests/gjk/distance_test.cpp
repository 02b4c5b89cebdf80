// The whole algorithm: known answers, optimality, invariance, every scalar, space.

#include <algorithm>

#include "check.hpp"
#include "gjk/gjk.hpp"
#include "study/families.hpp"

namespace distance_test {

using families::Family;
using gjk::Vec;
using gjk::Verdict;

template <class S, int D>
using Points = std::vector<Vec<S, D>>;

template <class S, int D>
gjk::Result<S, D> distance(const Points<S, D>& x, const Points<S, D>& y,
                           const gjk::Options& options = {}) {
  return gjk::distance<S>(gjk::Query<S, D>{{x}, {y}}, options);
}

const Points<double, 2> kSquare = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

TEST(known_answers, "point, segment, triangle and polygon: answers one can see") {
  struct Known {
    Points<double, 2> x;
    Points<double, 2> y;
    double distance;
  };
  const Known cases[] = {
      {{{0, 0}}, {{3, 4}}, 5.0},
      {{{0, 0}}, {{-1, 2}, {5, 2}}, 2.0},
      {{{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}}, 0.0},
      {{{0, 0}, {4, 0}}, {{0, 3}, {4, 3}}, 3.0},  // parallel
      {kSquare, {{2, -3}, {2, 3}, {4, 0}}, 1.0},
      {kSquare, {{2, 2}, {3, 2}, {2, 3}}, std::sqrt(2.0)},
      {kSquare, {{0.5, 0.5}, {3, 2}, {2, 3}}, 0.0},
  };
  for (const Known& known : cases) {
    const double found = distance(known.x, known.y).distance;
    CHECK_NEAR(known.distance, found, 1e-15);
  }
}

TEST(witness, "witness points lie in their shapes, at the distance, and no pair is nearer") {
  constexpr std::uint64_t kSeed = 12;
  families::Source random(kSeed);
  long separated = 0;
  for (int i = 0; i < check::cases(60000); ++i) {
    const int family = i % families::kFamilyCount;
    const check::Context context("seed", kSeed, "pair", i, families::kFamilyNames[family]);
    const auto pair = random.pair<double>(static_cast<Family>(family));
    const gjk::Query<double, 2> query = pair.query();
    const auto result = gjk::distance(query);
    const double scale = families::scale_of(pair);
    const double far = std::max(gjk::norm_max(result.x), gjk::norm_max(result.y));
    const double rounding =
        std::max(1e-15 * std::max(scale, far), 2 * std::numeric_limits<double>::denorm_min());

    Vec<double, 2> x = Vec<double, 2>::Zero();
    Vec<double, 2> y = Vec<double, 2>::Zero();
    double sum = 0;
    for (int k = 0; k < result.simplex.count; ++k) {
      const double weight = result.simplex.weights[k];
      const gjk::VertexPair index = result.simplex.vertices[k].pair;
      CHECK(weight >= 0);
      sum += weight;
      x += weight * (pair.x_pose.rotated(pair.x[index.x]) + pair.x_pose.translation);
      y += weight * (pair.y_pose.rotated(pair.y[index.y]) + pair.y_pose.translation);
    }
    CHECK_NEAR(1.0, sum, 1e-15);
    CHECK((x - result.x).stableNorm() <= rounding);
    CHECK((y - result.y).stableNorm() <= rounding);
    CHECK_NEAR(result.distance, (y - x).stableNorm(), 4 * rounding);
    if (result.distance <= 1e6 * rounding) continue;

    // By duality: P is the nearest point of Z exactly when every point of Z lies beyond the plane
    // through P, normal to P.
    ++separated;
    const Vec<double, 2> normal = (y - x) / (y - x).stableNorm();
    for (const Vec<double, 2>& vertex : pair.x) {
      const Vec<double, 2> world = pair.x_pose.rotated(vertex) + pair.x_pose.translation;
      CHECK(normal.dot(world - x) <= 1e-6 * scale);
    }
    for (const Vec<double, 2>& vertex : pair.y) {
      const Vec<double, 2> world = pair.y_pose.rotated(vertex) + pair.y_pose.translation;
      CHECK(normal.dot(world - y) >= -1e-6 * scale);
    }
  }
  CHECK(separated > check::cases(20000));
}

TEST(symmetric, "the distance does not change, up to rounding, when X and Y change places") {
  constexpr std::uint64_t kSeed = 13;
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(30000); ++i) {
    const int family = i % families::kFamilyCount;
    const check::Context context("seed", kSeed, "pair", i, families::kFamilyNames[family]);
    const auto pair = random.pair<double>(static_cast<Family>(family));
    const gjk::Query<double, 2> query = pair.query();
    const gjk::Query<double, 2> swapped{query.y, query.x};
    const double scale = families::scale_of(pair);
    CHECK_NEAR(gjk::distance(query).distance, gjk::distance(swapped).distance, 4e-15 * scale);
  }
}

TEST(vertex_order, "neither the order of the vertices nor their repetition matters") {
  constexpr std::uint64_t kSeed = 14;
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(20000); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    auto pair = random.pair<double>(i % 2 == 0 ? Family::random : Family::grid);
    const auto expected = gjk::distance(pair.query());
    std::reverse(pair.x.begin(), pair.x.end());
    std::rotate(pair.y.begin(), pair.y.begin() + 1, pair.y.end());
    pair.x.push_back(pair.x.front());
    pair.y.insert(pair.y.begin(), pair.y.back());
    CHECK_NEAR(expected.distance, gjk::distance(pair.query()).distance, 1e-14);
  }
}

TEST(common_translation, "a huge translation common to both poses does not change one bit") {
  constexpr std::uint64_t kSeed = 15;
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(20000); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    auto pair = random.pair<float>(Family::random);
    pair.x_pose.translation = pair.y_pose.translation = Vec<float, 2>(1, 0);
    const auto expected = gjk::distance(pair.query());
    pair.x_pose.translation = pair.y_pose.translation = Vec<float, 2>(3e8f, -7e9f);
    const auto moved = gjk::distance(pair.query());
    CHECK_EQ(expected.distance, moved.distance);
    CHECK_EQ(expected.lower, moved.lower);
    CHECK_EQ(expected.upper, moved.upper);
    CHECK_EQ(expected.iterations, moved.iterations);
    CHECK_EQ(expected.stop, moved.stop);
  }
}

TEST(poses, "poses equal vertices transformed beforehand, up to rounding") {
  constexpr std::uint64_t kSeed = 16;
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(20000); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    auto pair = random.pair<double>(Family::posed);
    const double expected = gjk::distance(pair.query()).distance;
    const double far = std::max(gjk::norm_max(pair.x_pose.translation), 1.0);
    for (Vec<double, 2>& vertex : pair.x)
      vertex = pair.x_pose.rotated(vertex) + pair.x_pose.translation;
    for (Vec<double, 2>& vertex : pair.y)
      vertex = pair.y_pose.rotated(vertex) + pair.y_pose.translation;
    pair.x_pose = pair.y_pose = {};
    CHECK_NEAR(expected, gjk::distance(pair.query()).distance, 2e-15 * far);
  }
}

template <class S>
void check_iterations(gjk::DirectionRule rule, int pairs_per_family, double mean_below,
                      int most_allowed) {
  constexpr std::uint64_t kSeed = 18;
  for (int family = 0; family < families::kFamilyCount; ++family) {
    families::Source random(kSeed);
    gjk::Options options;
    options.direction_rule = rule;
    long sum = 0;
    int most = 0;
    for (int i = 0; i < pairs_per_family; ++i) {
      const auto result =
          gjk::distance(random.pair<S>(static_cast<Family>(family)).query(), options);
      CHECK(result.stop != gjk::StopReason::iteration_cap);
      sum += result.iterations;
      most = std::max(most, result.iterations);
    }
    const check::Context context("seed", kSeed, families::kFamilyNames[family]);
    CHECK(static_cast<double>(sum) / pairs_per_family < mean_below);
    CHECK(most <= most_allowed);
  }
}

TEST(iterations, "runs take few iterations, far fewer than the cap, whatever the family") {
  check_iterations<float>(gjk::DirectionRule::perpendicular, check::cases(20000), 4.5, 12);
  check_iterations<double>(gjk::DirectionRule::perpendicular, check::cases(20000), 4.5, 12);
  check_iterations<float>(gjk::DirectionRule::towards_origin, check::cases(5000), 4.5, 12);
  check_iterations<double>(gjk::DirectionRule::towards_origin, check::cases(5000), 4.5, 12);
}

TEST(many_vertices, "the number of iterations grows slowly with the number of vertices") {
  for (const int count : {10, 100, 1000, 10000}) {
    Points<double, 2> x;
    Points<double, 2> y;
    for (int i = 0; i < count; ++i) {
      const double angle = 6.283185307179586 * i / count;
      x.emplace_back(std::cos(angle), std::sin(angle));
      y.emplace_back(2.7 + 1.3 * std::cos(angle), 1.9 + 0.8 * std::sin(angle));
    }
    const check::Context context("vertices", count);
    CHECK(distance(x, y).iterations <= 12);
  }
}

template <class S>
void check_scalar(double tolerance) {
  const Points<S, 2> square = {{S(-1), S(-1)}, {S(1), S(-1)}, {S(1), S(1)}, {S(-1), S(1)}};
  const auto far = distance<S, 2>({{S(4), S(5)}}, square);
  CHECK_NEAR(5.0, static_cast<double>(far.distance), tolerance);
  CHECK(static_cast<double>(far.lower) <= 5.0);
  CHECK(static_cast<double>(far.upper) >= 5.0);
  CHECK_EQ(Verdict::separated, far.verdict);
  const auto inside = distance<S, 2>({{S(0.25), S(0.5)}}, square);
  CHECK_EQ(0.0, static_cast<double>(inside.distance));
  CHECK_EQ(Verdict::overlapping, inside.verdict);
  CHECK_EQ(gjk::StopReason::origin_inside, inside.stop);
}

TEST(scalars, "half, float, double and long double run the same code") {
  check_scalar<Eigen::half>(0.02);
  check_scalar<float>(1e-6);
  check_scalar<double>(1e-15);
  check_scalar<long double>(1e-15);
}

TEST(precision, "half, float and double agree with long double as their digits allow") {
  constexpr std::uint64_t kSeed = 19;
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(20000); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    const auto pair = random.pair<Eigen::half>(Family::random);
    const auto convert = [](const Points<Eigen::half, 2>& points, auto zero) {
      using S = decltype(zero);
      Points<S, 2> out;
      for (const Vec<Eigen::half, 2>& p : points) {
        out.emplace_back(static_cast<S>(static_cast<float>(p[0])),
                         static_cast<S>(static_cast<float>(p[1])));
      }
      return out;
    };
    const auto in = [&](auto zero) {
      using S = decltype(zero);
      return static_cast<long double>(
          distance<S, 2>(convert(pair.x, zero), convert(pair.y, zero)).distance);
    };
    const long double truth = in(0.0L);
    CHECK_NEAR(truth, static_cast<long double>(gjk::distance(pair.query()).distance), 0.02L);
    CHECK_NEAR(truth, in(0.0f), 2e-6L);
    CHECK_NEAR(truth, in(0.0), 4e-15L);
  }
}

Points<double, 3> box(const Vec<double, 3>& center, double half) {
  Points<double, 3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(center +
                      half * Vec<double, 3>(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  return corners;
}

TEST(boxes_in_space, "boxes in space: face, edge, corner and overlap") {
  const Points<double, 3> unit = box({0, 0, 0}, 1);
  CHECK_NEAR(2.0, distance(unit, box({4, 0.3, -0.2}, 1)).distance, 1e-14);
  CHECK_NEAR(std::sqrt(8.0), distance(unit, box({4, 4, 0.1}, 1)).distance, 1e-14);
  CHECK_NEAR(std::sqrt(12.0), distance(unit, box({4, 4, 4}, 1)).distance, 1e-14);
  const auto inside = distance(unit, box({0.5, 0.31, 0.72}, 1));
  CHECK_EQ(0.0, inside.distance);
  CHECK_EQ(Verdict::overlapping, inside.verdict);
}

TEST(tetrahedra, "random tetrahedra in space: the nearest pair, proved by duality") {
  constexpr std::uint64_t kSeed = 20;
  families::Source random(kSeed);
  long separated = 0;
  long overlapping = 0;
  for (int i = 0; i < check::cases(20000); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    Points<double, 3> x;
    Points<double, 3> y;
    const Vec<double, 3> shift(random.between(-1.5, 1.5), random.between(-1.5, 1.5), 0);
    for (int k = 0; k < 4; ++k) {
      x.emplace_back(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      y.push_back(shift + Vec<double, 3>(random.between(-1, 1), random.between(-1, 1),
                                         random.between(-1, 1)));
    }
    const auto result = distance(x, y);
    CHECK(result.stop != gjk::StopReason::iteration_cap);
    CHECK(result.lower <= result.upper);
    if (result.verdict == Verdict::separated && result.distance > 1e-6) {
      ++separated;
      const Vec<double, 3> normal = (result.y - result.x) / result.distance;
      for (const Vec<double, 3>& vertex : x) CHECK(normal.dot(vertex - result.x) <= 1e-9);
      for (const Vec<double, 3>& vertex : y) CHECK(normal.dot(vertex - result.y) >= -1e-9);
      CHECK_NEAR(result.lower, result.upper, 1e-9);
    } else if (result.verdict == Verdict::overlapping) {
      ++overlapping;
      Vec<double, 3> sum = Vec<double, 3>::Zero();
      for (int k = 0; k < result.simplex.count; ++k) {
        CHECK(result.simplex.weights[k] >= 0);
        sum += result.simplex.weights[k] * result.simplex.vertices[k].w;
      }
      CHECK(sum.norm() < 1e-9);
    }
  }
  CHECK(separated > check::cases(5000));
  CHECK(overlapping > check::cases(2000));
}

}  // namespace distance_test
