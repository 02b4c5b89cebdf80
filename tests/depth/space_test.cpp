#include <gtest/gtest.h>

#include "exact/rational.hpp"
#include "gjk/gjk.hpp"
#include "pairs_in_space.hpp"

namespace test::space {
namespace {

using depth::Phase;
using depth::StopReason;
using gjk::Verdict;
using gjkscope::Rational;
using Point = Eigen::Vector3d;
using Points = std::vector<Point>;

/// A box around a point, `size` from it to each face.
Points box(const Point& size, const Point& at = Point::Zero()) {
  Points out;
  for (int i = 0; i < 8; ++i) {
    const Point sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    out.push_back(at + sign.cwiseProduct(size));
  }
  return out;
}
const Points kCube = box({1, 1, 1});
const Points kTetrahedron = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};

families::Pair<Rational, 3> in_rationals(const Pair& pair) {
  families::Pair<Rational, 3> out;
  for (const Point& p : pair.x) out.x.emplace_back(Rational(p[0]), Rational(p[1]), Rational(p[2]));
  for (const Point& p : pair.y) out.y.emplace_back(Rational(p[0]), Rational(p[1]), Rational(p[2]));
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
    check(depth::penetration<Eigen::half>(families::converted<Eigen::half>(pair).query()));
    check(depth::penetration<float>(families::converted<float>(pair).query()));
    const auto exact = depth::penetration<Rational>(in_rationals(pair).query());
    EXPECT_EQ(truth.verdict, exact.verdict);
    if (truth.verdict == Verdict::separated) continue;
    const Rational depth_sq = gjk::dot(exact.translation, exact.translation);
    const mpq_class area(truth.per_unit * truth.per_unit);  // of a unit of length, squared
    EXPECT_EQ(mpq_class(truth.depth_sq / area).get_str(), to_string(depth_sq));
    EXPECT_TRUE(exact.x + exact.translation == exact.y);
    EXPECT_EQ(exact.depth, gjk::ScalarTraits<Rational>::root(depth_sq));
  }
}

TEST(DepthInSpace, OfShapesThatOverlap) {
  const Pair beside{kCube, box({1, 1, 1}, {1.5, 0.25, 0.125})};
  expect_right(beside);
  expect_right({kCube, box({0.25, 0.25, 0.25}, {0.125, 0, 0})});  // one inside the other
  expect_right({kCube, {{0, 0, 0.5}, {3, 2, 1}, {2, 3, 4}, {0, 3, 3}}});
  expect_right({kTetrahedron, {{1, 1, -1}, {2, 0.5, 5}}});
  const auto result = depth::penetration<double>(beside.query());
  EXPECT_EQ(0.5, result.depth);
  EXPECT_EQ(Point(-1, 0, 0), result.direction);
  EXPECT_EQ(Point(-0.5, 0, 0), result.translation);
  EXPECT_EQ(1, result.x[0]);
  EXPECT_EQ(0.5, result.y[0]);
}

TEST(DepthInSpace, OfIdenticalShapes) {
  expect_right({kCube, kCube});
  expect_right({kTetrahedron, kTetrahedron});
  EXPECT_EQ(2, depth::penetration<double>(Pair{kCube, kCube}.query()).depth);
}

TEST(DepthInSpace, IsZeroWhereShapesTouch) {
  const Points plate = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const std::vector<Pair> pairs = {
      {kCube, box({1, 1, 1}, {2, 0.25, 0.5})},      // two faces
      {kCube, box({1, 1, 1}, {2, 2, 0.5})},         // two edges
      {kCube, box({1, 1, 1}, {2, 2, 2})},           // two vertices
      {kCube, {{1, 0, 0}, {3, 2, 1}, {3, -3, 2}}},  // a vertex on a face
      {kCube, {{0, 1, 1}, {3, 2, 2}}},              // an end on an edge
      {kCube, {{0, 2, 0}, {0, 0, 2}}},              // edges that cross
      {kCube, {{1, 0.5, 0.25}}},                    // a point on a face,
      {kCube, {{1, 1, 0.25}}},                      // on an edge,
      {kCube, {{1, 1, -1}}},                        // on a vertex
      {{{2, 3, 4}}, {{2, 3, 4}}},                   // two points
      {{{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1}}},        // a point on a segment
      {{{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1}, {4, 4, 4}}},
      {{{0, 0, 0}, {2, 2, 2}}, {{0, 2, 0}, {2, 0, 2}}},  // crossing segments
      {plate, plate},                                    // in one plane
      {plate, {{0, 0, 0}, {0, 0, 1}}},                   // a segment that ends on a plate
      {plate, {{0, 0, 0}}},
      {plate, {{0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}}},
  };
  for (const Pair& pair : pairs) {
    expect_right(pair);
    const auto result = depth::penetration<double>(pair.query());
    EXPECT_EQ(Verdict::touching, result.verdict);
    EXPECT_EQ(0, result.depth);
    EXPECT_EQ(0, result.upper);
    EXPECT_NEAR(1, gjk::length(result.direction), 1e-15);
    EXPECT_EQ(result.x, result.y);
  }
}

TEST(DepthInSpace, WhereGjkEndsBesideAFullSimplex) {
  // O lies on a face, an edge or a vertex of the simplex, and is an inner point of Z.
  const Points plate = {{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}};
  const std::vector<Pair> pairs = {
      {kCube, {{0, 0, 0}}},
      {kCube, {{0, 0, 0}, {0.5, 0, 0}}},
      {kCube, plate},
      {plate, {{0, 0, -1}, {0, 0, 3}}},
      {plate, {{-1, 0, -1}, {1, 0, -1}, {0, 0, 2}}},
      {kTetrahedron, {{1, 1, 1}, {1, 1, 1}}},
      {{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, -2, 0}, {1, 0, 2}, {1, 0, -2}},
       {{1, 0, 0}}},  // vertices inside of the hull
  };
  for (const Pair& pair : pairs) {
    expect_right(pair);
    EXPECT_EQ(Verdict::overlapping, depth::penetration<double>(pair.query()).verdict);
  }
  // Whatever simplex it starts from, also one with all of its vertices in one place.
  const Pair pair{kCube, box({0.5, 0.25, 1}, {0.25, 0.25, 0.125})};
  const Truth truth = truth_of(pair);
  families::Source source(5);
  std::array<int, 5> counts = {};
  for (int i = 0; i < 400; ++i) {
    gjk::Options options;
    options.start.count = source.among(1, 4);
    for (int k = 0; k < options.start.count; ++k)
      options.start.pairs[static_cast<std::size_t>(k)] = {source.among(0, 7), source.among(0, 7)};
    const auto trace = depth::space::trace(pair.query(), options);
    ++counts[static_cast<std::size_t>(trace.gjk.result.simplex.count)];
    EXPECT_EQ("", broken_bar(trace.result, judge(trace.result, truth), kBars)) << i;
  }
  EXPECT_LT(20, counts[4]);
}

TEST(DepthInSpace, StartsFromAnyPointsOfZ) {
  // Starts that GJK never leaves: points beside O, twice the same, on one line or in one plane.
  const Pair pair{kCube, box({0.5, 0.25, 1}, {0.25, 0.25, 0.125})};
  const auto query = pair.query();
  const auto prepared = gjk::prepare<double>(query, {});
  const double depth = depth::penetration<double>(query).depth;
  families::Source source(6);
  for (int i = 0; i < 400; ++i) {
    gjk::Result<double, 3> found;
    found.verdict = Verdict::overlapping;
    found.simplex.count = source.among(1, 4);
    for (gjk::SupportPoint<double, 3>& vertex : found.simplex.vertices)
      vertex.pair = {source.among(0, 7), source.among(0, 7)};
    auto state = depth::space::start(query, prepared, found);
    depth::space::run(state, query, prepared);
    EXPECT_NEAR(depth * depth, depth::detail::inner_distance_sq(state), 1e-14);
  }
}

TEST(DepthInSpace, OfShapesOfVeryDifferentSizes) {
  const double speck = 0x1p-27;
  const Pair with_speck{kCube, box({speck, speck, speck}, {0.5, 0.25, 0.125})};
  const auto found = depth::penetration<double>(with_speck.query());
  EXPECT_EQ("", broken_bar(found, judge(found, truth_of(with_speck)), kBars));
  const Pair far_inside{box({0x1p27, 0x1p27, 0x1p27}), box({1, 1, 1}, {5, 6, 7})};
  EXPECT_EQ(0x1p27 - 7 + 1, depth::penetration<double>(far_inside.query()).depth);
  for (const int exponent : {332, -332}) {
    const Pair pair = scaled(Pair{kCube, box({1, 1, 1}, {1.5, 0.25, 0.125})}, exponent);
    const auto result = depth::penetration<double>(pair.query());
    EXPECT_EQ(std::ldexp(0.5, exponent), result.depth);
    EXPECT_EQ("", broken_bar(result, judge(result, truth_of(pair)), kBars));
  }
}

TEST(DepthInSpace, OfShapesApartIsANamedVerdict) {
  const auto trace = depth::space::trace(Pair{kCube, {{5, 0, 0}}}.query());
  EXPECT_EQ(Verdict::separated, trace.result.verdict);
  EXPECT_EQ(StopReason::separated, trace.result.stop);
  EXPECT_TRUE(std::isnan(trace.result.depth));
  EXPECT_TRUE(trace.steps.empty());
  EXPECT_FALSE(trace.gjk.steps.empty());
}

TEST(DepthInSpace, RefusesWhatGjkRefuses) {
  EXPECT_EQ(gjk::Error::x_has_no_vertices,
            depth::penetration<double>(Pair{{}, kCube}.query()).error);
  const auto result = depth::penetration<double>(Pair{kCube, {{0, 0, std::nan("")}}}.query());
  EXPECT_EQ(gjk::Error::y_not_finite, result.error);
  EXPECT_EQ(StopReason::failed, result.stop);
  EXPECT_EQ(Verdict::none, result.verdict);
}

TEST(DepthInSpace, IsProvedAsFarAsOptionsAsk) {
  const Pair pair{kCube, box({1, 1, 1}, {1.5, 0.25, 0.125})};
  gjk::Options options;
  options.proof = gjk::Proof::none;
  const auto guessed = depth::penetration<double>(pair.query(), options);
  EXPECT_EQ(0.5, guessed.depth);
  EXPECT_TRUE(std::isnan(guessed.lower));
  EXPECT_TRUE(std::isnan(guessed.upper));
  // Touching takes exact arithmetic.
  options.proof = gjk::Proof::bounds;
  const Pair touching{kCube, box({1, 1, 1}, {2, 0.25, 0.5})};
  const auto bounded = depth::penetration<double>(touching.query(), options);
  EXPECT_EQ(Verdict::undecided, bounded.verdict);
  EXPECT_EQ(StopReason::undecided, bounded.stop);
  EXPECT_TRUE(depth::penetration<double>(touching.query()).settled);
}

/// Its faces are joined without a gap, and no corner lies outside of one of them.
void expect_convex(const depth::space::Polytope<double>& polytope) {
  using Face = depth::space::Face<double>;
  int alive = 0;
  for (int k = 0; k < static_cast<int>(polytope.faces.size()); ++k) {
    const Face& face = polytope.faces[static_cast<std::size_t>(k)];
    if (face.is_outgrown) continue;
    ++alive;
    for (int i = 0; i < 3; ++i) {
      const auto& beyond = polytope.faces[static_cast<std::size_t>(face.neighbours[i])];
      ASSERT_FALSE(beyond.is_outgrown);
      int shared = 0;
      for (int j = 0; j < 3; ++j) {
        shared += beyond.neighbours[j] == k && beyond.corners[j] == face.corners[(i + 1) % 3] &&
                  beyond.corners[(j + 1) % 3] == face.corners[i];
      }
      ASSERT_EQ(1, shared);
    }
    for (const auto& corner : polytope.corners) {
      ASSERT_LE(gjkscope::orientation(polytope.at(face, 0), polytope.at(face, 2),
                                      polytope.at(face, 1), corner.w),
                0);
    }
    if (alive > 2) {
      const auto plane = depth::space::face_plane<double>(
          {polytope.at(face, 0), polytope.at(face, 1), polytope.at(face, 2)});
      ASSERT_FALSE(gjk::is_zero(plane.n)) << "a face without an area";
    }
  }
  ASSERT_LE(2, alive);
  ASSERT_EQ(0, alive % 2);
}

TEST(DepthInSpace, OfANeedleHasContactPointsInFloat) {
  // Nearly on one line: float, and words of two, lose the areas of all faces that are near.
  const Points x = {{-3.25, -2.75, -3.75}, {-4, -3, -4}, {1.25, -1.25, -2.25}, {-1, -2, -3}};
  const Points y = {{-3.75, -2.91666675F, -3.91666675F},
                    {-1.77635684e-15F, -1.66666663F, -2.66666675F},
                    {1.5, -1.16666663F, -2.16666675F},
                    {-4.5, -3.16666675F, -4.16666651F}};
  for (const Pair& pair : {Pair{x, y}, Pair{y, x}}) {
    const auto result = depth::penetration<float>(families::converted<float>(pair).query());
    EXPECT_EQ("", broken_bar(result, judge(result, truth_of(pair)), kBars));
  }
}

TEST(DepthInSpace, TraceTakesTheSameDecisionsAndKeepsEveryPhase) {
  families::Source source(7);
  std::array<int, depth::kPhaseCount> phases = {};
  int outgrown = 0;
  for (int i = 0; i < 20 * kDepthFamilyCount; ++i) {
    const auto family = static_cast<DepthFamily>(i % kDepthFamilyCount);
    const Pair pair = meeting_pair(source, family, families::Representation::full_doubles);
    const auto trace = depth::space::trace(pair.query());
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
      const depth::space::Step<double>& step = trace.steps[k];
      ASSERT_EQ(static_cast<Phase>(k % depth::kPhaseCount), step.phase);
      ASSERT_EQ(static_cast<int>(k) / depth::kPhaseCount + 1, step.iteration);
      ++phases[static_cast<std::size_t>(step.phase)];
      ASSERT_LE(step.bounds.lower, upper);
      ASSERT_TRUE(k == 0 || lower <= step.bounds.upper);
      outgrown += static_cast<int>(step.record.outgrown.size());
      ASSERT_EQ(step.phase == Phase::nearest, !step.record.faces.empty());
      ASSERT_EQ(step.phase == Phase::support, !step.record.scan_x.empty());
      ASSERT_EQ(step.phase == Phase::stop, !step.record.stop_tests.empty());
      ASSERT_EQ(step.phase == Phase::expand, !step.record.added.empty());
      if (step.phase == Phase::nearest) expect_convex(step.after.polytope);
    }
    ASSERT_EQ(Phase::stop, trace.steps.back().phase);
    ASSERT_NE(StopReason::running, trace.steps.back().after.stop);
  }
  for (const int count : phases) EXPECT_LT(500, count);
  EXPECT_LT(500, outgrown);
}

TEST(DepthInSpace, OfRoundShapesHasNoCapBelowManyFaces) {
  const auto ball = [](int count, double radius) {
    Points points;
    for (int i = 0; i < count; ++i) {  // along a spiral
      const double height = 1 - (2.0 * i + 1) / count;
      const double away = std::sqrt(1 - height * height);
      const double angle = 2.399963229728653 * i;
      points.emplace_back(radius * away * std::cos(angle), radius * away * std::sin(angle),
                          radius * height);
    }
    return points;
  };
  // Nearly all faces of Z are about as near, and must be reached before one is the nearest.
  Pair pair{ball(200, 1), ball(200, 1)};
  // GJK's first vertex is O for two balls in one place, and bounds alone prove nothing.
  for (Point& vertex : pair.y) vertex += Point(1e-3, 7e-4, 5e-4);
  gjk::Options options;
  options.proof = gjk::Proof::bounds;
  const auto result = depth::penetration<double>(pair.query(), options);
  EXPECT_NE(StopReason::iteration_cap, result.stop);
  EXPECT_LT(1.9, result.lower);
  EXPECT_LE(result.upper - result.lower, 1e-13);
  EXPECT_FALSE(depth::penetration<double>(pair.query()).settled) << "it takes 100 times as long";
  const auto query = pair.query();
  const auto prepared = gjk::prepare<double>(query, options);
  auto state = depth::space::start(query, prepared, gjk::distance(query, options));
  depth::space::run(state, query, prepared);
  EXPECT_LT(256, std::count_if(state.polytope.faces.begin(), state.polytope.faces.end(),
                               [](const auto& face) { return !face.is_outgrown; }));
}

/// The least reach over the normals of all triples of vertices, and of all pairs of pairs.
mpq_class brute_depth_sq(const Truth& truth) {
  mpq_class least;
  bool is_first = true;
  const auto offer = [&](const ExactPoint& normal) {
    if (is_zero(normal)) return;
    for (const ExactPoint& n : {normal, minus(ExactPoint(), normal)}) {
      const mpz_class reach = truth.reach(n);
      mpq_class found(reach * reach, dot(n, n));
      found.canonicalize();
      if (is_first || found < least) least = found;
      is_first = false;
    }
  };
  const auto ways = [](const std::vector<ExactPoint>& points) {
    std::vector<ExactPoint> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) out.push_back(minus(points[i], points[k]));
    }
    return out;
  };
  const std::vector<ExactPoint> x = ways(truth.x.points);
  const std::vector<ExactPoint> y = ways(truth.y.points);
  for (const auto& [first, second] : {std::pair{&x, &x}, std::pair{&y, &y}, std::pair{&x, &y}}) {
    for (const ExactPoint& a : *first) {
      for (const ExactPoint& b : *second) offer(cross(a, b));
    }
  }
  return least;
}

TEST(DepthInSpace, TruthIsTheLeastReachOfAll) {
  families::Source source(3);
  int overlapping = 0;
  for (int i = 0; i < 16; ++i) {
    const auto family =
        i % 2 == 0 ? static_cast<DepthFamily>(families::Family::random) : DepthFamily::boxes;
    const Truth truth =
        truth_of(meeting_pair(source, family, families::Representation::float_values));
    if (truth.verdict != Verdict::overlapping) continue;
    ++overlapping;
    EXPECT_EQ(brute_depth_sq(truth), truth.depth_sq);
  }
  EXPECT_LT(5, overlapping);
}

TEST(DepthInSpace, HoldsOnEveryFamilyAlsoTimesAPowerOfTwo) {
  families::Source source(11);
  std::array<int, 3> verdicts = {};
  int tiny = 0;
  int huge = 0;
  for (int i = 0; i < 40 * kDepthFamilyCount; ++i) {
    const auto family = static_cast<DepthFamily>(i % kDepthFamilyCount);
    const auto representation = i % 2 == 0 && family != DepthFamily::extreme
                                    ? families::Representation::float_values
                                    : families::Representation::full_doubles;
    const Pair pair = meeting_pair(source, family, representation);
    double size = 0.0;
    for (const Point& p : pair.x) size = std::max(size, p.cwiseAbs().maxCoeff());
    tiny += 0.0 < size && size < 1e-95;
    huge += size > 1e95;
    const auto result = depth::penetration<double>(pair.query());
    if (result.error == gjk::Error::none) {
      ++verdicts[static_cast<std::size_t>(result.verdict)];
      const Truth truth = truth_of(pair);
      EXPECT_EQ("", broken_bar(result, judge(result, truth), kBars)) << name_of(family) << ' ' << i;
    }
    EXPECT_TRUE(keeps_bits_when_scaled(pair, result, source.among(-90, 90)));
  }
  for (const int count : verdicts) EXPECT_LT(40, count);
  EXPECT_LT(5, tiny);
  EXPECT_LT(5, huge);
}

}  // namespace
}  // namespace test::space
