// Phases "closest" and "drop".

#include "gjk/regions.hpp"

#include <algorithm>
#include <set>

#include "check.hpp"
#include "study/families.hpp"

namespace regions_test {

using gjk::Face;
using gjk::Vec;

template <class S, int D>
gjk::State<S, D> state_of(const std::vector<Vec<S, D>>& points) {
  gjk::State<S, D> state;
  for (const Vec<S, D>& point : points) {
    gjk::SupportPoint<S, D>& vertex = state.simplex.vertices[state.simplex.count];
    vertex.w = point;
    vertex.pair = {state.simplex.count, 0};
    ++state.simplex.count;
  }
  return state;
}

struct Closest {
  Vec<double, 2> p;
  Face region = 0;
  bool no_region_held = false;
  std::vector<gjk::RegionTest<double>> tests;
};
Closest closest(const std::vector<Vec<double, 2>>& points,
                gjk::RegionOrder order = gjk::RegionOrder::vertices_first) {
  gjk::State<double, 2> state = state_of<double, 2>(points);
  gjk::Options options;
  options.region_order = order;
  gjk::Record<double, 2> record;
  gjk::find_closest_point(state, options, record);
  return {state.p, state.region, record.no_region_held, record.region_tests};
}

/// By definition: the least |p| over the vertices, the edges' feet and, inside, 0.
double brute_force_sq(const std::vector<Vec<double, 2>>& points) {
  double best = 1e300;
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<double, 2>& a = points[i];
    const Vec<double, 2>& b = points[(i + 1) % points.size()];
    const Vec<double, 2> edge = b - a;
    const double length_sq = edge.squaredNorm();
    double t = length_sq > 0 ? -a.dot(edge) / length_sq : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    best = std::min(best, (a + edge * t).squaredNorm());
    const double side = a[0] * b[1] - a[1] * b[0];
    left = left || side > 0;
    right = right || side < 0;
  }
  return points.size() == 3 && left != right ? 0.0 : best;
}

TEST(segment_regions, "the three regions of a segment: A, B and between") {
  CHECK_EQ(0b01, static_cast<int>(closest({{1, 1}, {3, 1}}).region));
  CHECK_EQ(0b10, static_cast<int>(closest({{-3, 1}, {-1, 1}}).region));
  const Closest between = closest({{-1, 1}, {3, 1}});
  CHECK_EQ(0b11, static_cast<int>(between.region));
  CHECK_EQ(0.0, between.p[0]);
  CHECK_EQ(1.0, between.p[1]);
}

TEST(triangle_regions, "all seven regions of a triangle occur, and give their closest point") {
  struct Expected {
    double x, y;  // where O stands, seen from the triangle (0,0) (4,0) (0,4)
    int region;
    double p_x, p_y;
  };
  const Expected cases[] = {
      {-1, -1, 0b001, 0, 0}, {6, -1, 0b010, 4, 0}, {-1, 6, 0b100, 0, 4}, {2, -1, 0b011, 2, 0},
      {3, 3, 0b110, 2, 2},   {-1, 2, 0b101, 0, 2}, {1, 1, 0b111, 1, 1},
  };
  for (const Expected& expected : cases) {
    const check::Context context("O at", expected.x, expected.y);
    const Vec<double, 2> o(expected.x, expected.y);
    const Closest found =
        closest({Vec<double, 2>(0, 0) - o, Vec<double, 2>(4, 0) - o, Vec<double, 2>(0, 4) - o});
    CHECK_EQ(expected.region, static_cast<int>(found.region));
    CHECK_EQ(expected.p_x, found.p[0] + o[0]);
    CHECK_EQ(expected.p_y, found.p[1] + o[1]);
  }
}

TEST(vertex_order, "closest point on a triangle is the same for all six vertex orders") {
  constexpr std::uint64_t kSeed = 1;
  families::Source random(kSeed);
  std::array<int, 8> regions = {};
  for (int i = 0; i < 20000; ++i) {
    const check::Context context("seed", kSeed, "triangle", i);
    std::vector<Vec<double, 2>> points;
    for (int k = 0; k < 3; ++k) {
      points.push_back(i % 2 == 0 ? Vec<double, 2>(random.among(-4, 4), random.among(-4, 4))
                                  : Vec<double, 2>(random.between(-1, 1), random.between(-1, 1)));
    }
    const double expected_sq = brute_force_sq(points);
    std::array<int, 3> order = {0, 1, 2};
    ++regions[closest(points).region];
    do {
      const Closest found = closest({points[order[0]], points[order[1]], points[order[2]]});
      CHECK_NEAR(expected_sq, found.p.squaredNorm(), 1e-14 * (1 + expected_sq));
    } while (std::next_permutation(order.begin(), order.end()));
  }
  for (int region = 1; region < 8; ++region) {
    const check::Context context("region", region);
    CHECK(regions[region] > 300);
  }
}

TEST(degenerate, "triangles without area give the closest point of what is left of them") {
  const std::vector<std::vector<Vec<double, 2>>> triangles = {
      {{1, 2}, {1, 2}, {1, 2}},     // one point
      {{1, 2}, {1, 2}, {3, 2}},     // two points, closest at the double one
      {{-1, 2}, {3, 2}, {3, 2}},    // two points, closest between
      {{-3, 1}, {-1, 1}, {2, 1}},   // collinear, closest between B and C
      {{-3, 1}, {2, 1}, {-1, 1}},   // the same, other order
      {{1, 1}, {2, 2}, {3, 3}},     // collinear with O, closest at A
      {{-1, -1}, {0, 0}, {3, 3}},   // O is a vertex
      {{-2, -2}, {-1, -1}, {3, 3}}  // O on the edge BC
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const double expected_sq = brute_force_sq(triangles[i]);
    std::array<int, 3> order = {0, 1, 2};
    do {
      const check::Context context("triangle", i, "order", order[0], order[1], order[2]);
      const Closest found =
          closest({triangles[i][order[0]], triangles[i][order[1]], triangles[i][order[2]]});
      CHECK_NEAR(expected_sq, found.p.squaredNorm(), 1e-30);
      CHECK(gjk::vertex_count(found.region) < 3);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(one_holds, "the region taken is the last one tested, and the only one that holds") {
  const Closest found = closest({{1, -1}, {1, 2}, {5, 0}});
  CHECK_EQ(0b011, static_cast<int>(found.region));
  CHECK_EQ(std::size_t{4}, found.tests.size());  // A, B, C, AB
  for (std::size_t i = 0; i < found.tests.size(); ++i) {
    CHECK_EQ(i + 1 == found.tests.size(), found.tests[i].holds);
    bool all = true;
    for (const gjk::RegionTerm<double>& term : found.tests[i].terms) {
      CHECK_EQ(term.wants_positive == (term.numerator > 0), term.holds);
      all = all && term.holds;
    }
    CHECK_EQ(all, found.tests[i].holds);
  }
  CHECK(!found.no_region_held);
}

TEST(slides_order, "segments test B before A, triangles A B C AB BC CA ABC") {
  const Closest segment = closest({{-1, 1}, {1, 1}});
  CHECK_EQ(std::size_t{3}, segment.tests.size());
  CHECK_EQ(0b10, static_cast<int>(segment.tests[0].region));
  CHECK_EQ(0b01, static_cast<int>(segment.tests[1].region));
  const Closest triangle = closest({{-1, -1}, {2, -1}, {-1, 2}});
  const int expected[] = {0b001, 0b010, 0b100, 0b011, 0b110, 0b101, 0b111};
  CHECK_EQ(std::size_t{7}, triangle.tests.size());
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK_EQ(expected[i], static_cast<int>(triangle.tests[i].region));
  }
}

TEST(edges_first, "edges_first tests edges before vertices and comes to the same answer") {
  const auto order = gjk::RegionOrder::edges_first;
  const Closest found = closest({{-1, -1}, {2, -1}, {-1, 2}}, order);
  CHECK_EQ(2, gjk::vertex_count(found.tests[0].region));
  CHECK_EQ(0b111, static_cast<int>(found.region));
  constexpr std::uint64_t kSeed = 2;
  families::Source random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const check::Context context("seed", kSeed, "triangle", i);
    std::vector<Vec<double, 2>> points;
    for (int k = 0; k < 3; ++k) points.emplace_back(random.among(-4, 4), random.among(-4, 4));
    CHECK_NEAR(closest(points).p.squaredNorm(), closest(points, order).p.squaredNorm(), 1e-14);
  }
}

TEST(rounding, "when rounding leaves every test false the nearest face is taken, and it is noted") {
  // Three points on a line through O, up to rounding: the signs of the areas are noise.
  constexpr std::uint64_t kSeed = 3;
  families::Source random(kSeed);
  int happened = 0;
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.between(0, 6.283185307179586);
    std::vector<Vec<float, 2>> points;
    std::vector<Vec<double, 2>> same_points;
    for (int k = 0; k < 3; ++k) {
      const double along = random.between(-4, 4);
      points.emplace_back(static_cast<float>(along * std::cos(angle)),
                          static_cast<float>(along * std::sin(angle)));
      same_points.push_back(points.back().cast<double>());
    }
    gjk::State<float, 2> state = state_of<float, 2>(points);
    gjk::Record<float, 2> record;
    gjk::find_closest_point(state, {}, record);
    const check::Context context("seed", kSeed, "triangle", i);
    CHECK_NEAR(std::sqrt(brute_force_sq(same_points)), static_cast<double>(std::sqrt(state.p_sq)),
               4e-6);
    if (record.no_region_held) ++happened;
  }
  CHECK(happened > 50);
}

TEST(unchecked, "unchecked tests find the same region, but where rounding fools them") {
  const auto order = gjk::RegionOrder::unchecked;
  constexpr std::uint64_t kSeed = 4;
  families::Source random(kSeed);
  int fooled = 0;
  for (int i = 0; i < 20000; ++i) {
    const check::Context context("seed", kSeed, "triangle", i);
    std::vector<Vec<double, 2>> points;
    for (int k = 0; k < 3; ++k) points.emplace_back(random.among(-4, 4), random.among(-4, 4));
    const bool thin = gjk::cross(Vec<double, 2>(points[1] - points[0]),
                                 Vec<double, 2>(points[2] - points[0])) == 0.0;
    if (!thin) CHECK_EQ(closest(points).region, closest(points, order).region);
    // On a line through O, up to rounding, and on both sides of it.
    const double angle = random.between(0, 6.283185307179586);
    for (Vec<double, 2>& point : points) {
      point = random.between(-4, 4) * Vec<double, 2>(std::cos(angle), std::sin(angle));
    }
    const Closest believed = closest(points, order);
    if (believed.region != closest(points).region) {
      CHECK_EQ(0b111, static_cast<int>(believed.region));
      ++fooled;
    }
  }
  CHECK(fooled > 20);
}

std::vector<int> faces(int vertices, gjk::RegionOrder order) {
  std::vector<int> out;
  for (const gjk::Face face : gjk::tested_faces(vertices, order)) out.push_back(face);
  return out;
}

TEST(lists, "every face is listed once, in the order that was asked for") {
  using gjk::RegionOrder;
  using Faces = std::vector<int>;
  for (int vertices = 1; vertices <= 4; ++vertices) {
    const check::Context context("vertices", vertices);
    for (const auto order : {RegionOrder::vertices_first, RegionOrder::edges_first}) {
      Faces sorted = faces(vertices, order);
      CHECK_EQ((std::size_t{1} << vertices) - 1, sorted.size());
      std::sort(sorted.begin(), sorted.end());
      for (std::size_t i = 0; i < sorted.size(); ++i) CHECK_EQ(static_cast<int>(i) + 1, sorted[i]);
    }
  }
  CHECK((faces(2, RegionOrder::edges_first) == Faces{3, 2, 1}));
  CHECK((faces(3, RegionOrder::edges_first) == Faces{3, 6, 5, 1, 2, 4, 7}));
  CHECK((faces(4, RegionOrder::vertices_first) ==
         Faces{1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14, 15}));
}

TEST(weights, "weights are positive in P's face, add up to 1, and are 0 elsewhere") {
  constexpr std::uint64_t kSeed = 5;
  families::Source random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const check::Context context("seed", kSeed, "triangle", i);
    std::vector<Vec<double, 2>> points;
    for (int k = 0; k < 3; ++k) points.emplace_back(random.between(-1, 1), random.between(-1, 1));
    gjk::State<double, 2> state = state_of<double, 2>(points);
    gjk::NoRecord none;
    gjk::find_closest_point(state, {}, none);
    double sum = 0;
    Vec<double, 2> p = Vec<double, 2>::Zero();
    for (int k = 0; k < 3; ++k) {
      CHECK_EQ(gjk::contains(state.region, k), state.simplex.weights[k] > 0);
      CHECK(state.simplex.weights[k] >= 0);
      sum += state.simplex.weights[k];
      p += state.simplex.weights[k] * points[k];
    }
    CHECK_NEAR(1.0, sum, 1e-15);
    CHECK_NEAR(0.0, (p - state.p).norm(), 1e-12);
  }
}

TEST(divisors, "segments divide by the squared length, larger faces by the sum of their parts") {
  gjk::Simplex<double, 2> simplex = state_of<double, 2>({{1, 0}, {0, 1}, {2, 2}}).simplex;
  gjk::Barycentric<double, 2> coordinates;
  coordinates.numerator = {1, 1, 2};
  coordinates.denominator = 8;
  gjk::set_weights(simplex.weights, 0b011, coordinates);
  CHECK((simplex.weights == std::array<double, 3>{0.125, 0.125, 0}));
  gjk::set_weights(simplex.weights, 0b111, coordinates);
  CHECK((simplex.weights == std::array<double, 3>{0.25, 0.25, 0.5}));
  gjk::set_weights(simplex.weights, 0b100, coordinates);
  CHECK((simplex.weights == std::array<double, 3>{0, 0, 1}));
}

TEST(zero_terms, "a coordinate that is 0 counts, and is noted, as not positive") {
  const Closest found = closest({{0, 1}, {2, 1}, {5, 3}});
  CHECK_EQ(0b001, static_cast<int>(found.region));
  int zeros = 0;
  for (const gjk::RegionTerm<double>& term : found.tests[0].terms) {
    CHECK(!term.wants_positive);
    CHECK(term.holds);
    zeros += term.numerator == 0 ? 1 : 0;
  }
  CHECK_EQ(1, zeros);
}

TEST(believed, "weights of a full simplex are believed when P comes within 12 u of O, by size") {
  const auto believed = [](double size, double beside) {
    const auto simplex =
        state_of<double, 2>({{size, 0}, {-size, 0}, {0, size}}).simplex;  // P = (2 beside size, 0)
    gjk::Barycentric<double, 2> coordinates;
    coordinates.numerator = {0.5 + beside, 0.5 - beside, 0};
    return gjk::weights_reach_origin(simplex, coordinates);
  };
  const auto tall = state_of<double, 2>({{1, 0}, {-1, 0}, {0, 8}}).simplex;
  gjk::Barycentric<double, 2> beside;
  beside.numerator = {0.5 + 0x1p-49, 0.5 - 0x1p-49, 0};
  CHECK(gjk::weights_reach_origin(tall, beside));
  for (const double size : {1.0, 8.0}) {
    CHECK(believed(size, 0));
    CHECK(believed(size, 0x1.4p-51));
    CHECK(believed(size, 0x1.8p-51));
    CHECK(!believed(size, 0x1.cp-51));
    CHECK(!believed(size, 1e-3));
  }
}

TEST(nearest, "the nearest face is the first of those whose P is nearest") {
  const auto nearest = [](const std::vector<Vec<double, 2>>& points) {
    return static_cast<int>(gjk::nearest_face(state_of<double, 2>(points).simplex));
  };
  CHECK_EQ(0b001, nearest({{1, 1}, {1, 1}, {3, 4}}));
  CHECK_EQ(0b010, nearest({{3, 4}, {1, 1}, {1, 1}}));
  CHECK_EQ(0b100, nearest({{3, 4}, {1, 7}, {1, 1}}));
  CHECK_EQ(0b011, nearest({{-1, 1}, {1, 1}, {0, 5}}));
  CHECK_EQ(0b101, nearest({{-1, 1}, {0, 5}, {1, 1}}));
  CHECK_EQ(0b110, nearest({{0, 5}, {-1, 1}, {1, 1}}));
  CHECK_EQ(0b111, nearest({{0, 5}, {-1, -1}, {1, -1}}));
}

TEST(thin, "a thin triangle around O is taken or not, but no answer lies farther than its width") {
  constexpr std::uint64_t kSeed = 6;
  families::Source random(kSeed);
  int full = 0;
  int edges = 0;
  for (int i = 0; i < 20000; ++i) {
    const check::Context context("seed", kSeed, "triangle", i);
    const double width = random.magnitude(1e-8, 1e-3);
    const double angle = random.between(0, 6.283185307179586);
    std::vector<Vec<float, 2>> points;
    for (const Vec<double, 2>& p : {Vec<double, 2>(-1, 0), Vec<double, 2>(1, width),
                                    Vec<double, 2>(random.between(-1, 1), -width)}) {
      points.emplace_back(static_cast<float>(p[0] * std::cos(angle) - p[1] * std::sin(angle)),
                          static_cast<float>(p[0] * std::sin(angle) + p[1] * std::cos(angle)));
    }
    gjk::State<float, 2> state = state_of<float, 2>(points);
    gjk::Record<float, 2> record;
    gjk::find_closest_point(state, {}, record);
    CHECK(std::sqrt(state.p_sq) <= width + 1e-6);
    const bool is_full = state.region == 0b111;
    if (is_full) CHECK(!record.no_region_held);
    ++(is_full ? full : edges);
  }
  CHECK(full > 5000);
  CHECK(edges > 1000);
}

/// The regions that O lies in of `rounds` random simplices. A vertex is drawn from its
/// simplex's center. P is the
/// closest point of the hull exactly when no vertex lies nearer to O along P.
template <class Center, class Vertex>
std::set<int> regions_in_space(int rounds, int count, const Center& any_center,
                               const Vertex& any_vertex) {
  std::set<int> regions;
  for (int i = 0; i < rounds; ++i) {
    const check::Context context("simplex", i);
    const Vec<double, 3> center = any_center();
    std::vector<Vec<double, 3>> points;
    for (int k = 0; k < count; ++k) points.push_back(center + any_vertex());
    gjk::State<double, 3> state = state_of<double, 3>(points);
    gjk::NoRecord none;
    gjk::find_closest_point(state, {}, none);
    regions.insert(state.region);
    for (const Vec<double, 3>& point : points) {
      CHECK(state.p.dot(point) >= state.p.squaredNorm() - 1e-9);
    }
  }
  return regions;
}

TEST(triangles_in_space, "a triangle in space has the same seven regions") {
  constexpr std::uint64_t kSeed = 7;
  const check::Context context("seed", kSeed);
  families::Source random(kSeed);
  const auto coordinate = [&] { return random.between(-1, 1); };
  const std::set<int> regions = regions_in_space(
      5000, 3, [&] { return Vec<double, 3>(coordinate(), coordinate(), 0.5); },
      [&] { return Vec<double, 3>(coordinate(), coordinate(), random.between(-0.3, 0.3)); });
  CHECK_EQ(std::size_t{7}, regions.size());
}

TEST(tetrahedra, "all fifteen regions of a tetrahedron occur; the closest point is the least") {
  constexpr std::uint64_t kSeed = 4;
  const check::Context context("seed", kSeed);
  families::Source random(kSeed);
  const auto coordinate = [&] { return random.between(-1, 1); };
  const auto anywhere = [&] { return Vec<double, 3>(coordinate(), coordinate(), coordinate()); };
  const std::set<int> regions = regions_in_space(20000, 4, anywhere, anywhere);
  CHECK_EQ(std::size_t{15}, regions.size());
}

TEST(dropping, "drop keeps the vertices of P's face in order, and drops the others") {
  gjk::State<double, 2> state = state_of<double, 2>({{1, -1}, {5, 0}, {1, 2}});
  gjk::Record<double, 2> record;
  gjk::find_closest_point(state, {}, record);
  gjk::drop(state, {}, record);
  CHECK_EQ(2, state.simplex.count);
  CHECK_EQ(0, state.simplex.vertices[0].pair.x);
  CHECK_EQ(2, state.simplex.vertices[1].pair.x);
  CHECK_EQ(1.0, state.simplex.weights[0] + state.simplex.weights[1]);
  CHECK_EQ(std::size_t{1}, record.dropped.size());
  CHECK_EQ(1, record.dropped[0].pair.x);
  CHECK_EQ(gjk::Phase::direction, state.phase);
  CHECK_EQ(1.0, state.evidence.best_sq);
}

TEST(facets, "the squared distance of P on a facet is that of the facet's line, or plane") {
  const auto check = [](double expected, auto state) {
    gjk::NoRecord none;
    gjk::find_closest_point(state, {}, none);
    CHECK_EQ(expected, state.p_sq);
  };
  check(9.0, state_of<double, 2>({{3, -1}, {3, 2}}));
  check(0.5, state_of<double, 2>({{0, 1}, {4, 4}, {1, 0}}));
  check(0.0, state_of<double, 2>({{0, 1}, {-5, -5}, {1, 0}}));
  check(0.8, state_of<double, 2>({{0, 2}, {1, 0}}));
  check(25.0, state_of<double, 2>({{3, 4}, {6, 8}}));
  check(4.0, state_of<double, 3>({{-1, -1, 2}, {2, -1, 2}, {-1, 2, 2}}));
  check(2.0, state_of<double, 3>({{-1, 1, 1}, {1, 1, 1}}));
}

TEST(p_itself, "where directions come from P, its squared length is that of P") {
  // In half P is so rounded that it is seen.
  gjk::Options options;
  options.direction_rule = gjk::DirectionRule::towards_origin;
  gjk::State<Eigen::half, 2> state = state_of<Eigen::half, 2>(
      {{Eigen::half(90.5), Eigen::half(8.5)}, {Eigen::half(-88.0), Eigen::half(-8.0)}});
  gjk::NoRecord none;
  gjk::find_closest_point(state, options, none);
  CHECK(gjk::dot(state.p, state.p) == state.p_sq);
  options.direction_rule = gjk::DirectionRule::perpendicular;
  gjk::find_closest_point(state, options, none);
  CHECK(gjk::dot(state.p, state.p) != state.p_sq);
}

TEST(drop_full, "a full simplex around O goes to the stop phase; so does a P that came no nearer") {
  gjk::State<double, 2> state = state_of<double, 2>({{-1, -1}, {2, -1}, {-1, 2}});
  gjk::NoRecord none;
  gjk::find_closest_point(state, {}, none);
  gjk::drop(state, {}, none);
  CHECK_EQ(gjk::Phase::stop, state.phase);
  CHECK(gjk::is_zero(state.p));

  gjk::State<double, 2> stale = state_of<double, 2>({{3, 4}});
  stale.evidence.best.count = 1;
  stale.evidence.best_sq = 25;
  gjk::find_closest_point(stale, {}, none);
  gjk::drop(stale, {}, none);
  CHECK_EQ(gjk::Phase::stop, stale.phase);

  for (const double best_sq :
       {0.0, 25.0}) {  // in exact arithmetic P comes nearer until it is there
    gjk::State<gjk::Expansion, 2> exact;
    exact.simplex.count = 1;
    exact.region = 1;
    exact.p_sq = gjk::Expansion(25.0);
    exact.evidence.best.count = 1;
    exact.evidence.best_sq = gjk::Expansion(best_sq);
    gjk::drop(exact, {}, none);
    CHECK_EQ(best_sq > 0 ? gjk::Phase::direction : gjk::Phase::stop, exact.phase);
  }
}

}  // namespace regions_test
