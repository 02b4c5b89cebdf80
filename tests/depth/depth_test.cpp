#include <gtest/gtest.h>

#include "exact/rational.hpp"
#include "pairs.hpp"

namespace test {
namespace depth_test {

using gjk::Verdict;
using gjkscope::Rational;
using Point = Eigen::Vector2d;
using Points = std::vector<Point>;
using depth::Phase;
using depth::StopReason;

const Points kBox = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

template <class S>
families::Pair<S> as(const Pair& pair) {
  return families::converted<S>(pair);
}
template <>
families::Pair<Rational> as<Rational>(const Pair& pair) {
  families::Pair<Rational> out;
  for (const Point& p : pair.x) out.x.emplace_back(Rational(p[0]), Rational(p[1]));
  for (const Point& p : pair.y) out.y.emplace_back(Rational(p[0]), Rational(p[1]));
  return out;
}

/// Every claim about the pair in every scalar and in both orders.
void expect_right(const Pair& given) {
  for (const Pair& pair : {given, families::swapped(given)}) {
    const Truth truth = truth_of(pair);
    const auto check = [&](const auto& result) {
      EXPECT_EQ("", broken_bar(result, judge(result, truth), kBars));
    };
    check(depth::penetration<double>(pair.query()));
    check(depth::penetration<Eigen::half>(as<Eigen::half>(pair).query()));
    check(depth::penetration<float>(as<float>(pair).query()));
    const auto exact = depth::penetration<Rational>(as<Rational>(pair).query());
    EXPECT_EQ(truth.verdict, exact.verdict);
    if (truth.verdict == Verdict::separated) continue;
    const Rational depth_sq = gjk::dot(exact.translation, exact.translation);
    const mpq_class area(truth.per_unit * truth.per_unit);  // of a unit of length, squared
    EXPECT_EQ(mpq_class(truth.depth_sq / area).get_str(), to_string(depth_sq));
    EXPECT_TRUE(exact.x + exact.translation == exact.y);
    EXPECT_EQ(exact.depth, gjk::ScalarTraits<Rational>::root(depth_sq));
  }
}

TEST(Depth, OfShapesThatOverlap) {
  expect_right({kBox, {{0, 0.5}, {3, 2}, {2, 3}}});
  expect_right({kBox, {{-0.5, 0.25}, {0.25, 0.25}, {0, 0.5}}});  // one inside the other
  expect_right({{{0, 0}, {4, 0}, {0, 3}}, {{1, -1}, {2, 5}}});
  const auto result = depth::penetration<double>(Pair{kBox, {{0, 0.5}, {3, 2}, {2, 3}}}.query());
  EXPECT_EQ(0.5, result.depth);
  EXPECT_EQ(Point(0, -1), result.direction);
  EXPECT_EQ(Point(0, -0.5), result.translation);
  EXPECT_EQ(Point(0, 1), result.x);
  EXPECT_EQ(Point(0, 0.5), result.y);
}

TEST(Depth, OfIdenticalShapes) {
  expect_right({kBox, kBox});
  expect_right({{{0, 0}, {4, 0}, {0, 3}}, {{0, 0}, {4, 0}, {0, 3}}});
  EXPECT_EQ(2, depth::penetration<double>(Pair{kBox, kBox}.query()).depth);
}

TEST(Depth, IsZeroWhereShapesTouch) {
  const Points triangle = {{1, 0}, {3, 2}, {3, -3}};
  const std::vector<Pair> pairs = {
      {kBox, triangle},                       // a vertex on an edge
      {kBox, {{1, 1}, {3, 2}, {2, 3}}},       // two vertices
      {kBox, {{1, -0.5}, {3, 0}, {1, 0.5}}},  // two edges
      {kBox, {{1, 0.5}}},                     // a point on an edge
      {kBox, {{-1, 1}}},                      // a point on a vertex
      {{{2, 3}}, {{2, 3}}},                   // two points
      {{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}},   // segments of one line
      {{{0, 0}, {2, 2}}, {{2, 2}, {3, 3}}},   // end to end
      {{{0, 0}, {2, 2}}, {{1, 1}}},           // a point on a segment
      {{{0, 0}, {2, 2}}, {{0, 0}, {2, 2}}},   // the same segment twice
      {{{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 0}, {5, 0}}},
      {{{0, 0}, {2, 0}}, {{1, 0}, {1, 3}}},  // a segment that ends on another
  };
  for (const Pair& pair : pairs) {
    expect_right(pair);
    const auto result = depth::penetration<double>(pair.query());
    EXPECT_EQ(Verdict::touching, result.verdict);
    EXPECT_EQ(0, result.depth);
    EXPECT_EQ(0, result.upper);
    EXPECT_NEAR(1, result.direction.norm(), 1e-15);
    EXPECT_EQ(result.x, result.y);
  }
}

TEST(Depth, WhereGjkEndsBesideAFullSimplex) {
  // O lies on an edge or a vertex of the simplex, and is an inner point of Z.
  const std::vector<Pair> pairs = {
      {{{0, 0}, {2, 0}}, {{1, -1}, {1, 3}}},                   // crossing segments
      {kBox, {{0, 0}}},                                        // a point in the middle
      {{{-2, 0}, {2, 0}, {0, 2}, {0, -2}}, {{0, 0}, {1, 0}}},  // a diamond and its middle
      {{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {2, 2}, {1, 1}}},    // along a line of symmetry
      {{{0, 0}, {2, 0}, {1, 0}, {1, 2}, {1, -2}}, {{1, 0}}},   // vertices inside the hull
  };
  for (const Pair& pair : pairs) {
    expect_right(pair);
    EXPECT_EQ(Verdict::overlapping, depth::penetration<double>(pair.query()).verdict);
  }
  // Whatever simplex it starts from: the difference of any two vertices, also inside of Z.
  const Pair pair{{{-2, 0}, {2, 0}, {0, 0}, {0, 2}, {0, -2}}, {{0, 0}, {1, 0}, {0, 1}}};
  const Truth truth = truth_of(pair);
  int degenerate = 0;
  for (int i = 0; i < 15 * 15; ++i) {
    gjk::Options options;
    options.start.count = 2;
    options.start.pairs[0] = {i % 5, i / 5 % 3};
    options.start.pairs[1] = {i / 15 % 5, i / 75};
    const auto trace = depth::trace(pair.query(), options);
    degenerate += trace.gjk.result.simplex.count < 3;
    EXPECT_EQ("", broken_bar(trace.result, judge(trace.result, truth), kBars)) << i;
  }
  EXPECT_LT(50, degenerate);
}

TEST(Depth, OfShapesApartIsANamedVerdict) {
  const auto trace = depth::trace(Pair{kBox, {{5, 0}}}.query());
  EXPECT_EQ(Verdict::separated, trace.result.verdict);
  EXPECT_EQ(StopReason::separated, trace.result.stop);
  EXPECT_TRUE(std::isnan(trace.result.depth));
  EXPECT_TRUE(std::isnan(trace.result.lower));
  EXPECT_TRUE(std::isnan(trace.result.upper));
  EXPECT_TRUE(trace.steps.empty());
  EXPECT_FALSE(trace.gjk.steps.empty());
}

TEST(Depth, RefusesWhatGjkRefuses) {
  EXPECT_EQ(gjk::Error::x_has_no_vertices,
            depth::penetration<double>(Pair{{}, kBox}.query()).error);
  const auto result = depth::penetration<double>(Pair{kBox, {{0, std::nan("")}}}.query());
  EXPECT_EQ(gjk::Error::y_not_finite, result.error);
  EXPECT_EQ(StopReason::failed, result.stop);
  EXPECT_EQ(Verdict::none, result.verdict);
}

TEST(Depth, IsProvedAsFarAsOptionsAsk) {
  const Pair pair{kBox, {{0, 0.5}, {3, 2}, {2, 3}}};
  gjk::Options options;
  options.proof = gjk::Proof::none;
  const auto guessed = depth::penetration<double>(pair.query(), options);
  EXPECT_EQ(0.5, guessed.depth);
  EXPECT_TRUE(std::isnan(guessed.lower));
  EXPECT_TRUE(std::isnan(guessed.upper));
  // Touching takes exact arithmetic.
  options.proof = gjk::Proof::bounds;
  const Pair touching{kBox, {{1, 0}, {3, 2}, {3, -3}}};
  const auto bounded = depth::penetration<double>(touching.query(), options);
  EXPECT_EQ(Verdict::undecided, bounded.verdict);
  EXPECT_EQ(StopReason::undecided, bounded.stop);
  EXPECT_FALSE(bounded.settled);
  EXPECT_TRUE(depth::penetration<double>(touching.query()).settled);
}

TEST(Depth, TraceTakesTheSameDecisionsAndKeepsEveryPhase) {
  families::Source source(7);
  std::array<int, depth::kPhaseCount> phases = {};
  int outgrown = 0;
  for (int i = 0; i < 2200; ++i) {
    const auto family = static_cast<DepthFamily>(i % kDepthFamilyCount);
    const Pair pair = meeting_pair(source, family, families::Representation::full_doubles);
    const auto trace = depth::trace(pair.query());
    const auto result = depth::penetration<double>(pair.query());
    ASSERT_EQ(result.stop, trace.result.stop);
    ASSERT_EQ(result.verdict, trace.result.verdict);
    ASSERT_EQ(result.iterations, trace.result.iterations);
    ASSERT_TRUE(result.depth == trace.result.depth || std::isnan(result.depth));
    ASSERT_EQ(result.direction, trace.result.direction);
    if (trace.steps.empty()) continue;
    const int exponent = trace.gjk.prepared.exponent;
    const double upper = std::ldexp(result.upper, -exponent);
    const double lower = std::ldexp(result.lower, -exponent);
    for (std::size_t k = 0; k < trace.steps.size(); ++k) {
      const depth::Step<double>& step = trace.steps[k];
      ASSERT_EQ(static_cast<Phase>(k % depth::kPhaseCount), step.phase);
      ASSERT_EQ(static_cast<int>(k) / depth::kPhaseCount + 1, step.iteration);
      ++phases[static_cast<std::size_t>(step.phase)];
      ASSERT_LE(step.bounds.lower, upper);
      ASSERT_TRUE(k == 0 || lower <= step.bounds.upper);
      const depth::Polygon<double>& polygon = step.after.polygon;
      ASSERT_EQ(polygon.count, static_cast<int>(edges_in_order(polygon).size()));
      ASSERT_LE(static_cast<int>(polygon.edges.size()), 2 * step.after.iteration + 1);
      outgrown += static_cast<int>(step.record.outgrown.size());
      ASSERT_EQ(step.phase == Phase::nearest, !step.record.edges.empty());
      ASSERT_EQ(step.phase == Phase::support, !step.record.scan_x.empty());
      ASSERT_EQ(step.phase == Phase::stop, !step.record.stop_tests.empty());
    }
    ASSERT_EQ(Phase::stop, trace.steps.back().phase);
    ASSERT_NE(StopReason::running, trace.steps.back().after.stop);
  }
  for (const int count : phases) EXPECT_LT(2000, count);
  EXPECT_LT(10, outgrown);
}

TEST(Depth, OfManySidedPolygonsTakesAStepForEachCorner) {
  const auto circle = [](int count, double radius) {
    Points points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * i / count;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return points;
  };
  // All edges of Z are equally far, or nearly.
  const int count = 400;
  const Pair pair{circle(count, 1), circle(count, 1)};
  const auto result = depth::penetration<double>(pair.query());
  EXPECT_NEAR(2 * std::cos(M_PI / count), result.depth, 1e-15);
  EXPECT_LE(result.upper - result.lower, 16 * 2 * 0x1p-53);
  EXPECT_LE(count - 3, result.iterations);
  EXPECT_GE(2 * count, result.iterations);
  // Most are far, here.
  Pair beside = pair;
  for (Point& p : beside.y) p += Point(1.5, 0.01);
  EXPECT_GE(40, depth::penetration<double>(beside.query()).iterations);
}

TEST(Depth, HoldsOnEveryFamilyAlsoTimesAPowerOfTwo) {
  families::Source source(11);
  std::array<int, 3> verdicts = {};
  int tiny = 0;
  int huge = 0;
  for (int i = 0; i < 100 * kDepthFamilyCount; ++i) {
    const auto family = static_cast<DepthFamily>(i % kDepthFamilyCount);
    const auto representation = i % 2 == 0 && family != DepthFamily::extreme
                                    ? families::Representation::float_values
                                    : families::Representation::full_doubles;
    const Pair pair = meeting_pair(source, family, representation);
    double size = 0.0;
    for (const Point& p : pair.x) size = std::max(size, p.cwiseAbs().maxCoeff());
    tiny += 0.0 < size && size < 1e-140;
    huge += size > 1e140;
    const auto result = depth::penetration<double>(pair.query());
    if (result.error == gjk::Error::none) {
      ++verdicts[static_cast<std::size_t>(result.verdict)];
      const Truth truth = truth_of(pair);
      EXPECT_EQ("", broken_bar(result, judge(result, truth), kBars)) << name_of(family) << ' ' << i;
    }
    EXPECT_TRUE(keeps_bits_when_scaled(pair, result, source.among(-90, 90)));
  }
  for (const int count : verdicts) EXPECT_LT(50, count);
  EXPECT_LT(20, tiny);
  EXPECT_LT(20, huge);
}

}  // namespace depth_test
}  // namespace test
