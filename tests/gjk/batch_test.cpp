// The batch answers as the scalar code does: same verdict, a distance less than one ulp from the
// exact one, bounds that hold; in lanes and in plain code, for any mix of pairs.

#include "gjk/batch.hpp"

#include <cstring>
#include <limits>

#include "check.hpp"
#include "geometry/families.hpp"

namespace {

using families::Family;
using families::Pair;
using gjk::Batch;
using gjk::BatchResult;
using gjk::Error;
using gjk::Instructions;
using gjk::Vec;
using gjk::Verdict;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr double kLeast = std::numeric_limits<float>::denorm_min();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<Vec<double, 2>> widened(const std::vector<Vec<float, 2>>& vertices) {
  std::vector<Vec<double, 2>> out;
  for (const Vec<float, 2>& vertex : vertices) out.push_back(vertex.cast<double>());
  return out;
}
gjk::Pose<double, 2> widened(const gjk::Pose<float, 2>& pose) {
  return {pose.rotation.matrix().cast<double>(), pose.translation.cast<double>()};
}
gjk::Result<double, 2> scalar(const Pair<float>& pair) {
  const auto x = widened(pair.x);
  const auto y = widened(pair.y);
  return gjk::distance(gjk::Query<double, 2>{{x, widened(pair.x_pose)}, {y, widened(pair.y_pose)}});
}

/// Distance of two floats, counted in floats.
long steps_between(float a, float b) {
  std::int32_t a_bits = 0;
  std::int32_t b_bits = 0;
  std::memcpy(&a_bits, &a, sizeof a);
  std::memcpy(&b_bits, &b, sizeof b);
  return std::labs(static_cast<long>(a_bits) - static_cast<long>(b_bits));
}

/// The largest distance of a vertex of X from one of Y; or twice what a witness point comes from,
/// whose coordinates are rounded too.
double scale_of(const Pair<float>& pair) {
  double largest = 0;
  const auto in_world = [&](const std::vector<Vec<float, 2>>& vertices,
                            const gjk::Pose<float, 2>& pose) {
    const gjk::Pose<double, 2> exact = widened(pose);
    std::vector<Vec<double, 2>> out;
    for (const Vec<double, 2>& vertex : widened(vertices)) {
      out.emplace_back(exact.rotation.matrix() * vertex + exact.translation);
      largest = std::max({largest, 2 * vertex.norm(), 2 * exact.translation.norm()});
    }
    return out;
  };
  const auto y = in_world(pair.y, pair.y_pose);
  for (const Vec<double, 2>& of_x : in_world(pair.x, pair.x_pose)) {
    for (const Vec<double, 2>& of_y : y) largest = std::max(largest, (of_y - of_x).norm());
  }
  return largest;
}

void check_answer(const Pair<float>& pair, const BatchResult& actual) {
  const gjk::Result<double, 2> expected = scalar(pair);
  CHECK_EQ(expected.error, actual.error);
  if (expected.error != Error::none) return;
  CHECK(static_cast<double>(actual.lower) <= expected.upper);
  CHECK(static_cast<double>(actual.upper) >= expected.lower);
  CHECK(actual.lower <= actual.distance && actual.distance <= actual.upper);
  if (expected.verdict == Verdict::undecided) return;  // the lanes' bounds may be closer
  CHECK_EQ(expected.verdict == Verdict::separated, actual.verdict == Verdict::separated);
  CHECK(steps_between(static_cast<float>(expected.distance), actual.distance) <= 1);
  if (actual.from_scalar) {
    const gjk::Result<double, 2> given = gjk::distance(pair.query());
    CHECK_EQ(given.iterations, static_cast<int>(actual.iterations));
    CHECK(static_cast<double>(std::nextafter(actual.lower, kInfinity)) > given.lower);
    CHECK(static_cast<double>(std::nextafter(actual.upper, -kInfinity)) < given.upper);
  } else {
    const bool apart = actual.verdict == Verdict::separated;
    CHECK_EQ(apart ? 1 : 0, steps_between(actual.lower, actual.distance));
    CHECK_EQ(apart ? 1 : 0, steps_between(actual.upper, actual.distance));
  }
  const double rounding = 4 * (0x1p-24 * scale_of(pair) + kLeast);
  const double between = (actual.y - actual.x).cast<double>().norm();
  CHECK_NEAR(static_cast<double>(actual.distance), between, rounding);
}

/// Vertices on an ellipse, convex up to rounding.
std::vector<Vec<float, 2>> polygon(families::Source& random, int count, double size, double x,
                                   double y) {
  std::vector<Vec<float, 2>> vertices;
  const double squash = random.between(0.3, 1.0);
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * (i + random.between(0, 0.9)) / count;
    vertices.emplace_back(static_cast<float>(x + size * std::cos(angle)),
                          static_cast<float>(y + size * squash * std::sin(angle)));
  }
  return vertices;
}

gjk::Rotation<float, 2> random_turn(families::Source& random) {
  const double angle = random.between(0, 6.283185307179586);
  const auto c = static_cast<float>(std::cos(angle));
  const auto s = static_cast<float>(std::sin(angle));
  return Eigen::Matrix2f{{c, -s}, {s, c}};
}

/// X has a side through its own origin, where floats lie dense, and a vertex of Y lies above it or
/// below by so little that it is rounding for float, for double, or not even that; or O lies inside
/// a triangle as thin. `turned` says how many shapes are.
Pair<float> hair(families::Source& random, int turned) {
  const auto small = [&](double least_exponent) {
    return std::pow(2.0, random.between(least_exponent, 0));
  };
  const auto sign = [&] { return random.with_chance(0.5) ? 1.0 : -1.0; };
  const Vec<double, 2> along =
      Vec<double, 2>{random.between(1, 1.125), sign() * random.between(1, 1.125)}
          .cast<float>()
          .cast<double>();
  const Vec<double, 2> across = sign() * Vec<double, 2>(-along[1], along[0]);
  const auto at = [&](double a, double b) { return Vec<double, 2>(a * along + b * across); };
  const auto near_origin = [&] {
    return at(random.between(-0.02, 0.02), random.between(-0.02, 0.02));
  };

  Pair<float> pair;
  if (turned > 0) pair.y_pose.rotation = random_turn(random);
  if (turned > 1) pair.x_pose = {random_turn(random), near_origin().cast<float>()};
  const gjk::Pose<double, 2> x_pose = widened(pair.x_pose);
  const Eigen::Matrix2d y_turn = widened(pair.y_pose).rotation.matrix();
  const auto seen_from_y = [&](double a, double b) {
    return Vec<double, 2>(y_turn.transpose() * (x_pose.rotation.matrix() * at(a, b)));
  };

  const bool inside = random.with_chance(0.3);
  const double width = small(-36);
  const double least = random.with_chance(0.5) ? -30 : -56;
  const double height =
      inside ? -width * random.between(0, 1) : sign() * std::pow(2.0, random.between(least, -22));
  const Vec<double, 2> contact = at(random.between(-1, 1) * small(-36), height);
  std::vector<Vec<double, 2>> x = {along, -along, at(random.between(-1, 1) * small(-36), -width)};
  std::vector<Vec<double, 2>> y = {turned > 0 ? near_origin() : contact};
  if (!inside) {
    for (int more = random.among(0, 3); more > 0; --more) {
      y.push_back(y[0] + seen_from_y(random.between(-1, 1) * small(-20), small(-20)));
    }
  } else if (random.with_chance(0.5)) {
    x.pop_back();
    y.push_back(y[0] + seen_from_y(random.between(-1, 1) * small(-20), width));
  }
  if (turned > 0) {
    const Vec<double, 2> in_world = x_pose.rotation.matrix() * contact + x_pose.translation;
    const Vec<double, 2> y_0 = y[0].cast<float>().cast<double>();
    pair.y_pose.translation = (in_world - y_turn * y_0).cast<float>();
  }
  for (const Vec<double, 2>& vertex : x) pair.x.emplace_back(vertex.cast<float>());
  for (const Vec<double, 2>& vertex : y) pair.y.emplace_back(vertex.cast<float>());
  return random.with_chance(0.5) ? swapped(pair) : pair;
}

void scale(Pair<float>& pair, int exponent) {
  const float factor = std::ldexp(1.0f, exponent);
  for (auto* shape : {&pair.x, &pair.y}) {
    for (Vec<float, 2>& vertex : *shape) vertex *= factor;
  }
  pair.x_pose.translation *= factor;
  pair.y_pose.translation *= factor;
}

/// Two polygons of about the same size, apart or not.
Pair<float> polygons(families::Source& random, int x_size, int y_size) {
  const double distance = random.between(0.2, 3);
  const double angle = random.between(0, 6.283185307179586);
  return {polygon(random, x_size, 1, 0, 0),
          polygon(random, y_size, 1, distance * std::cos(angle), distance * std::sin(angle))};
}

struct Share {
  Family family;
  double handed_over;  ///< At most.
  double separated;    ///< At least; and as many that are not.
  double rounds;       ///< At most, on average.
};

TEST(families, "every family gets the scalar code's answers, from lanes and from plain code") {
  constexpr int kPairs = 10000;
  constexpr std::uint64_t kSeed = 31;
  // Rounds are as measured, rounded up. What floats cannot prove: touching shapes on lines and
  // grids, gaps of 1e-10, ratios of 1e8.
  constexpr Share kShares[] = {
      {Family::random, 0.001, 0.2, 3.9},     {Family::points, 0.001, 0.05, 3.345},
      {Family::collinear, 0.17, 0.1, 3.155}, {Family::clouds, 0.001, 0.2, 4.585},
      {Family::grid, 0.11, 0.2, 3.73},       {Family::parallel, 0.055, 0.1, 4.2},
      {Family::needle, 0.001, 0.1, 3.65},    {Family::tiny, 0.001, 0.05, 4.7},
      {Family::offset, 0.01, 0.1, 3.76},     {Family::ratio, 0.41, 0.1, 4.56},
      {Family::posed, 0.001, 0.2, 3.75},     {Family::grazing, 0.612, 0.2, 5.15}};
  for (const Share& share : kShares) {
    families::Source random(kSeed);
    std::vector<Pair<float>> pairs;
    Batch batch;
    for (int i = 0; i < kPairs; ++i) {
      pairs.push_back(random.pair<float>(share.family));
      CHECK_EQ(i, batch.add(pairs.back().query()));
    }
    const auto name = families::kFamilyNames[static_cast<std::size_t>(share.family)];
    std::vector<BatchResult> results(kPairs);
    const int handed_over = batch.distance(results);
    std::vector<BatchResult> plain(kPairs);
    CHECK_EQ(kPairs, batch.distance(plain, Instructions::plain));
    int separated = 0;
    int from_scalar = 0;
    double rounds = 0;
    for (int i = 0; i < kPairs; ++i) {
      const check::Context context("family", name, "seed", kSeed, "pair", i);
      check_answer(pairs[i], results[i]);
      check_answer(pairs[i], plain[i]);
      CHECK(plain[i].from_scalar);
      separated += results[i].verdict == Verdict::separated ? 1 : 0;
      from_scalar += results[i].from_scalar ? 1 : 0;
      rounds += results[i].from_scalar ? 0 : results[i].iterations;
    }
    rounds /= std::max(1, kPairs - handed_over);
    std::printf("  %-9s handed over %5d of %d, separated %5d, %.3f rounds\n", name.data(),
                handed_over, kPairs, separated, rounds);
    const check::Context context("family", name);
    CHECK_EQ(from_scalar, handed_over);
    if (gjk::detail::has_lanes()) {
      CHECK(handed_over <= share.handed_over * kPairs && rounds <= share.rounds);
    }
    CHECK(separated >= share.separated * kPairs);
    CHECK(kPairs - separated >= share.separated * kPairs);
  }
}

TEST(machine, "lanes are used where the machine has AVX2 and FMA") {
#if GJKSCOPE_HAS_LANES
  const bool expected = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  const bool expected = false;
#endif
  CHECK_EQ(expected, gjk::detail::has_lanes());
}

TEST(rounds, "what the float run ends with is nearly always the answer, which double only proves") {
  constexpr std::uint64_t kSeed = 32;
  constexpr int kPairs = 4000;
  struct Sizes {
    int x;
    int y;
    int rounds;
  };
  constexpr Sizes kSizes[] = {{1, 1, 3}, {2, 2, 3}, {3, 3, 3},   {4, 4, 3},   {5, 5, 4},
                              {8, 8, 4}, {9, 9, 5}, {12, 12, 5}, {13, 13, 5}, {16, 16, 5},
                              {3, 4, 3}, {4, 8, 4}, {16, 2, 5},  {3, 12, 5}};
  for (const auto [x_size, y_size, rounds] : kSizes) {
    for (const bool turned : {false, true}) {
      families::Source random(kSeed);
      Batch batch;
      for (int i = 0; i < kPairs; ++i) {
        Pair<float> pair = polygons(random, x_size, y_size);
        if (turned) pair.x_pose.rotation = random_turn(random);
        batch.add(pair.query());
      }
      std::vector<BatchResult> results(kPairs);
      batch.distance(results);
      int in_double = 0;
      for (const BatchResult& result : results) {
        if (result.from_scalar) continue;
        CHECK(rounds <= result.iterations);
        in_double += rounds < result.iterations ? 1 : 0;
      }
      const check::Context context("vertices", x_size, y_size, "turned", turned);
      CHECK(in_double <= 0.0125 * kPairs);
    }
  }
}

TEST(in_double, "where float cannot square, double goes all the way") {
  constexpr std::uint64_t kSeed = 32;
  constexpr int kPairs = 4000;
  for (const int vertices : {3, 4, 8, 16}) {
    families::Source random(kSeed);
    std::vector<Pair<float>> pairs;
    Batch batch;
    for (int i = 0; i < kPairs; ++i) {
      pairs.push_back(polygons(random, vertices, vertices));
      scale(pairs.back(), -80);
      batch.add(pairs.back().query());
    }
    std::vector<BatchResult> results(kPairs);
    CHECK_EQ(gjk::detail::has_lanes() ? 0 : kPairs, batch.distance(results));
    for (int i = 0; i < kPairs; ++i) {
      const check::Context context("vertices", vertices, "pair", i);
      check_answer(pairs[i], results[i]);
    }
  }
}

TEST(counts, "any number of pairs, groups left unfilled included") {
  constexpr std::uint64_t kSeed = 32;
  for (const int count : {0, 1, 7, 8, 9, 15, 16, 17, 33}) {
    families::Source random(kSeed);
    std::vector<Pair<float>> pairs;
    Batch batch;
    for (int i = 0; i < count; ++i) {
      pairs.push_back(random.pair<float>(Family::posed));
      batch.add(pairs.back().query());
    }
    CHECK_EQ(count, batch.size());
    std::vector<BatchResult> results(count + 1);
    CHECK_EQ(gjk::detail::has_lanes() ? 0 : count, batch.distance(results));
    for (int i = 0; i < count; ++i) {
      const check::Context context("pairs", count, "pair", i);
      check_answer(pairs[i], results[i]);
    }
    CHECK_EQ(Verdict::none, results[count].verdict);
  }
}

TEST(mixed, "points, polygons of any size and refused queries share a batch") {
  constexpr std::uint64_t kSeed = 33;
  families::Source random(kSeed);
  std::vector<Pair<float>> pairs;
  for (int i = 0; i < 2000; ++i) {
    Pair<float> pair;
    pair.x = polygon(random, random.among(1, 40), 1.0, random.between(-2, 2), 0);
    pair.y = polygon(random, random.among(1, 40), 1.0, random.between(-2, 2), 0);
    switch (i % 10) {
      case 3:
        pair.x.clear();
        break;
      case 4:
        pair.y.clear();
        break;
      case 5:
        pair.x.back()[1] = kNaN;
        break;
      case 6:
        pair.y_pose.rotation = Eigen::Matrix2f{{1, 0}, {kInfinity, 1}};
        break;
      case 7:
        pair.x_pose.translation[0] = kNaN;
        break;
      case 8:
        pair.y.front()[0] = kInfinity;
        break;
      default:
        break;
    }
    pairs.push_back(pair);
  }
  for (const Instructions instructions : {Instructions::best, Instructions::plain}) {
    Batch batch;
    for (const Pair<float>& pair : pairs) batch.add(pair.query());
    std::vector<BatchResult> results(pairs.size());
    batch.distance(results, instructions);
    std::array<int, 16> errors = {};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const check::Context context("seed", kSeed, "pair", i);
      check_answer(pairs[i], results[i]);
      ++errors[static_cast<std::size_t>(results[i].error)];
    }
    CHECK_EQ(200, errors[static_cast<std::size_t>(Error::x_has_no_vertices)]);
    CHECK_EQ(200, errors[static_cast<std::size_t>(Error::y_has_no_vertices)]);
    CHECK_EQ(400, errors[static_cast<std::size_t>(Error::x_not_finite)]);
    CHECK_EQ(400, errors[static_cast<std::size_t>(Error::y_not_finite)]);
  }
}

TEST(huge, "shapes too large for the lanes are answered by the scalar code") {
  families::Source random(34);
  Pair<float> pair;
  pair.x = polygon(random, gjk::kMaxLaneVertices + 1, 1.0, 0, 0);
  pair.y = polygon(random, 3, 1.0, 3, 0);
  Batch batch;
  batch.add(pair.query());
  pair.x.pop_back();
  batch.add(pair.query());
  std::array<BatchResult, 2> results;
  batch.distance(results);
  CHECK(results[0].from_scalar);
  CHECK_EQ(!gjk::detail::has_lanes(), results[1].from_scalar);
}

TEST(moving, "moved pairs answer as pairs made there") {
  constexpr std::uint64_t kSeed = 35;
  constexpr int kPairs = 3000;
  families::Source random(kSeed);
  std::vector<Pair<float>> pairs;
  Batch moved;
  for (int i = 0; i < kPairs; ++i) {
    pairs.push_back(random.pair<float>(i % 2 == 0 ? Family::random : Family::clouds));
    if (i % 100 == 0) pairs.back().x = polygon(random, 30, 1.0, 0, 0);
    moved.add(pairs.back().query());
  }
  std::vector<BatchResult> results(kPairs);
  std::vector<BatchResult> fresh_results(kPairs);
  for (int frame = 0; frame < 4; ++frame) {
    Batch fresh;
    for (int i = 0; i < kPairs; ++i) {
      const Pair<float> posed = random.pair<float>(Family::posed);
      pairs[i].x_pose = frame == 0 ? gjk::Pose<float, 2>{} : posed.x_pose;
      pairs[i].y_pose = posed.y_pose;
      if (frame == 2 && i % 50 == 0) pairs[i].x_pose.translation[1] = kNaN;
      moved.move(i, pairs[i].x_pose, pairs[i].y_pose);
      fresh.add(pairs[i].query());
    }
    moved.distance(results);
    fresh.distance(fresh_results);
    for (int i = 0; i < kPairs; ++i) {
      const check::Context context("seed", kSeed, "frame", frame, "pair", i);
      check_answer(pairs[i], results[i]);
      CHECK_EQ(fresh_results[i].error, results[i].error);
      if (results[i].error == Error::none) CHECK_EQ(fresh_results[i].distance, results[i].distance);
    }
  }
}

TEST(far, "shapes far from the origin keep their digits, whatever their poses") {
  constexpr std::uint64_t kSeed = 36;
  families::Source random(kSeed);
  Batch batch;
  std::vector<Pair<float>> pairs;
  for (int i = 0; i < 5000; ++i) {
    Pair<float> pair = random.pair<float>(Family::posed);
    // Vertices far from their own origin, and a pose that brings them back near the other shape.
    const double far = std::pow(10.0, random.between(2, 6));
    for (Vec<float, 2>& vertex : pair.y) vertex[0] += static_cast<float>(far);
    pair.y_pose.translation -= pair.y_pose.rotation.col(0) * static_cast<float>(far);
    if (i % 2 == 0) {
      const Vec<float, 2> both = Vec<float, 2>(static_cast<float>(random.between(-1e6, 1e6)), 1e5f);
      pair.x_pose.translation += both;
      pair.y_pose.translation += both;
    }
    pairs.push_back(pair);
    batch.add(pairs.back().query());
  }
  std::vector<BatchResult> results(pairs.size());
  const int handed_over = batch.distance(results);
  int separated = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    check_answer(pairs[i], results[i]);
    separated += results[i].verdict == Verdict::separated ? 1 : 0;
  }
  std::printf("  handed over %d, separated %d\n", handed_over, separated);
  if (gjk::detail::has_lanes()) CHECK(handed_over < 50);
  CHECK(separated > 1000 && separated < 4900);
}

TEST(cancelling,
     "shapes far from their own origins, whose poses cancel, are as far apart as they are") {
  constexpr std::uint64_t kSeed = 40;
  families::Source random(kSeed);
  Batch batch;
  std::vector<Pair<float>> pairs;
  for (int i = 0; i < 5000; ++i) {
    // Both shapes are one point, and only Y is moved: by little, where sums of products are large.
    const auto tiny = [&](double least) { return std::pow(2.0, random.between(least, -20)); };
    const auto entry = static_cast<float>(tiny(-100));
    const Vec<float, 2> point =
        Vec<double, 2>{random.between(0.5, 1), random.between(0.5, 1)}.cast<float>();
    const double size = tiny(-120);
    Pair<float> pair = {{point}, {point}};
    pair.x_pose.rotation = Eigen::Matrix2f{{1, entry}, {-entry, 1}};
    pair.y_pose.rotation = pair.x_pose.rotation;
    pair.y_pose.translation =
        (size * Vec<double, 2>{random.between(-1, 1), random.between(-1, 1)}).cast<float>();
    pairs.push_back(pair);
    batch.add(pairs.back().query());
  }
  std::vector<BatchResult> results(pairs.size());
  batch.distance(results);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    check_answer(pairs[i], results[i]);
    CHECK_NEAR(pairs[i].y_pose.translation.cast<double>().norm(),
               static_cast<double>(results[i].distance),
               0x1p-22 * static_cast<double>(results[i].distance));
  }
}

TEST(overflow, "coordinates that would overflow on their way are left to the scalar code") {
  constexpr std::uint64_t kSeed = 41;
  families::Source random(kSeed);
  Batch batch;
  std::vector<Pair<float>> pairs;
  while (pairs.size() < 20000) {
    const auto point = [&](double size) {
      return Vec<double, 2>{size * random.between(-1, 1), size * random.between(-1, 1)};
    };
    const bool far_poses = random.with_chance(0.5);  // or else far vertices
    const double size = far_poses ? 0x1.fp124 : 0x1.8p127;
    Vec<double, 2> contact = point(0x1.8p127);
    if (far_poses) contact = contact.array().sign() * random.between(0x1.cp127, 0x1.fep127);
    Pair<float> pair = {{point(size).cast<float>()}, {point(size).cast<float>()}};
    if (!far_poses) pair.x[0] = contact.cast<float>();
    pair.x_pose.translation = (contact - pair.x[0].cast<double>()).cast<float>();
    pair.y_pose.rotation = random_turn(random);
    const Vec<double, 2> turned = widened(pair.y_pose).rotation.matrix() * pair.y[0].cast<double>();
    pair.y_pose.translation = (contact + point(0x1p120) - turned).cast<float>();
    if (pairs.size() % 4 == 0) {  // a segment longer than the largest float, made small
      const auto end = static_cast<float>(random.between(0x1.1p127, 0x1.fp127));
      pair.y = {{end, 0.0f}, {-end, 0.0f}};
      pair.y_pose.rotation = Eigen::Matrix2f(pair.y_pose.rotation.matrix() * 0x1p-10f);
      pair.x = {point(0x1p120).cast<float>()};
      pair.x_pose = {};
      pair.y_pose.translation = point(0x1p120).cast<float>();
    }
    if (!pair.y_pose.translation.allFinite()) continue;
    pairs.push_back(pair);
    batch.add(pairs.back().query());
  }
  std::vector<BatchResult> results(pairs.size());
  batch.distance(results);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    check_answer(pairs[i], results[i]);
  }
}

TEST(shifted, "shapes that are moved and not turned") {
  constexpr std::uint64_t kSeed = 43;
  families::Source random(kSeed);
  Batch batch;
  std::vector<Pair<float>> pairs;
  for (int i = 0; i < 1000; ++i) {
    Pair<float> pair = random.pair<float>(Family::random);
    for (gjk::Pose<float, 2>* pose : {&pair.x_pose, &pair.y_pose}) {
      pose->translation =
          Vec<double, 2>{random.between(-1, 1), random.between(-1, 1)}.cast<float>();
    }
    pairs.push_back(pair);
    batch.add(pairs.back().query());
  }
  std::vector<BatchResult> results(pairs.size());
  CHECK_EQ(gjk::detail::has_lanes() ? 0 : 1000, batch.distance(results));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    check_answer(pairs[i], results[i]);
  }
}

TEST(scales, "a power of two times all coordinates is the same power of two times the answer") {
  constexpr std::uint64_t kSeed = 37;
  for (const int exponent : {-60, -30, -20, -1, 1, 20, 50, 59, 62}) {
    families::Source random(kSeed);
    Batch batch;
    Batch scaled;
    for (int i = 0; i < 200; ++i) {
      Pair<float> pair = random.pair<float>(Family::posed);
      batch.add(pair.query());
      scale(pair, exponent);
      scaled.add(pair.query());
    }
    std::array<BatchResult, 200> results;
    std::array<BatchResult, 200> scaled_results;
    batch.distance(results);
    scaled.distance(scaled_results);
    for (int i = 0; i < 200; ++i) {
      const check::Context context("seed", kSeed, "exponent", exponent, "pair", i);
      CHECK_EQ(results[i].verdict, scaled_results[i].verdict);
      // Where the scale sends one of them to the scalar code, they may differ by an ulp.
      CHECK(steps_between(std::ldexp(results[i].distance, exponent), scaled_results[i].distance) <=
            (results[i].from_scalar == scaled_results[i].from_scalar ? 0 : 1));
    }
  }
}

/// Answers `count` pairs of hairs in a world that is `flattened` along an axis, and returns how
/// many the lanes answered: of separated shapes, and of others.
std::array<int, 2> check_hairs(std::uint64_t seed, int turned, int exponent, int count,
                               float flattened = 1.0f) {
  families::Source random(seed);
  Batch batch;
  std::vector<Pair<float>> pairs;
  for (int i = 0; i < count; ++i) {
    pairs.push_back(hair(random, turned));
    scale(pairs.back(), exponent);
    for (gjk::Pose<float, 2>* pose : {&pairs.back().x_pose, &pairs.back().y_pose}) {
      Eigen::Matrix2f matrix = pose->rotation.matrix();
      matrix.row(i % 2) *= flattened;
      pose->rotation = matrix;
      pose->translation[i % 2] *= flattened;
    }
    batch.add(pairs.back().query());
  }
  std::vector<BatchResult> results(pairs.size());
  batch.distance(results);
  std::array<int, 2> answered = {};
  for (int i = 0; i < count; ++i) {
    const check::Context context("seed", seed, "turned", turned, "exponent", exponent, "pair", i);
    check_answer(pairs[i], results[i]);
    const bool separated = results[i].verdict == Verdict::separated;
    if (!results[i].from_scalar) ++answered[separated ? 0 : 1];
  }
  return answered;
}

TEST(hairs, "a vertex a hair above a side, or below, is where the scalar code says") {
  for (int turned = 0; turned <= 2; ++turned) {
    constexpr int kPairs = 60000;
    const auto [separated, others] = check_hairs(38, turned, 0, kPairs);
    std::printf("  %d shapes turned: %d separated and %d others answered in lanes\n", turned,
                separated, others);
    const check::Context context("turned", turned);
    if (gjk::detail::has_lanes()) CHECK(separated >= 0.01 * kPairs && others >= 0.1 * kPairs);
  }
}

TEST(flattened, "and so it is where rotations are none") {
  for (const int turned : {1, 2}) check_hairs(44, turned, 0, 20000, 0x1p-8f);
}

TEST(extremes, "and so it is at any scale that float has") {
  for (const int exponent : {-148, -140, -127, -100, -70, -66, -64, -62, -60, 58,
                             60,   62,   64,   66,   100, 122, 123, 124, 125, 126}) {
    for (const int turned : {0, 2}) {
      constexpr int kPairs = 2000;
      const auto [separated, others] = check_hairs(39, turned, exponent, kPairs);
      std::printf("  scale 2^%d, %d shapes turned: %d separated and %d others answered in lanes\n",
                  exponent, turned, separated, others);
      const bool expected = gjk::detail::has_lanes() && -127 <= exponent && exponent < 124;
      const check::Context context("exponent", exponent, "turned", turned);
      if (expected) CHECK(separated >= 0.01 * kPairs && others >= 0.1 * kPairs);
    }
  }
}

}  // namespace
