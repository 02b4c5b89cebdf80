// Facts that a run knows beforehand: errors by name, the unit of length, how far Z reaches, how
// much rounding can do.

#include "gjk/proof/prepare.hpp"

#include "check.hpp"
#include "gjk/proof/error_free.hpp"
#include "gjk/support.hpp"
#include "study/families.hpp"

namespace prepare_test {

using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using families::Pair;
using gjk::Error;
using gjk::Vec;

constexpr std::uint64_t kSeed = 43;

template <class R, class S>
gjk::Prepared<R, 2> prepared(const Pair<S>& pair, const gjk::Options& options = {}) {
  return gjk::prepare<R>(pair.query(), options);
}
/// The point (at, 0) against the origin.
template <class S>
Pair<S> points_apart(S at) {
  return {{{S(0), S(0)}}, {{at, S(0)}}};
}

TEST(errors, "each fault has its name, and the first one is named") {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Pair<double> good = points_apart(1.0);
  CHECK_EQ(Error::none, prepared<double>(good).error);
  gjk::Options options;
  options.start.count = 1;
  options.start.pairs[0] = {0, 1};
  CHECK_EQ(Error::bad_start, prepared<double>(good, options).error);
  options.tolerance = 1.0;
  CHECK_EQ(Error::bad_options, prepared<double>(good, options).error);
  options.tolerance = -0x1p-1000;
  CHECK_EQ(Error::bad_options, prepared<double>(good, options).error);
  Pair<double> bad = good;
  bad.y_pose.rotation = Eigen::Matrix2d{{1, kNaN}, {0, 1}};
  CHECK_EQ(Error::y_not_finite, prepared<double>(bad, options).error);
  bad.x_pose.translation[1] = kNaN;
  CHECK_EQ(Error::x_not_finite, prepared<double>(bad, options).error);
  bad.y.clear();
  CHECK_EQ(Error::y_has_no_vertices, prepared<double>(bad, options).error);
  bad.x.clear();
  CHECK_EQ(Error::x_has_no_vertices, prepared<double>(bad, options).error);
}

TEST(start_limits, "start pairs may name every vertex, and no other; up to 3 of them") {
  const Pair<double> pair{{{0, 0}, {1, 0}}, {{5, 0}, {5, 1}, {5, 2}}};
  for (int count = -1; count < 6; ++count) {
    gjk::Options options;
    options.start.count = count;
    CHECK_EQ(count >= 0 && count <= 3 ? Error::none : Error::bad_start,
             prepared<double>(pair, options).error);
  }
  for (int x = -1; x < 4; ++x) {
    for (int y = -1; y < 5; ++y) {
      const check::Context context("pair", x, y);
      gjk::Options options;
      options.start.count = 3;
      options.start.pairs[2] = {x, y};
      const bool good = 0 <= x && x < 2 && 0 <= y && y < 3;
      CHECK_EQ(good ? Error::none : Error::bad_start, prepared<double>(pair, options).error);
      options.start.count = 2;  // the third pair is not read
      CHECK_EQ(Error::none, prepared<double>(pair, options).error);
    }
  }
}

TEST(option_limits, "a cap of 1 and tolerances from 0 to just below 1 are options") {
  const Pair<double> pair = points_apart(1.0);
  gjk::Options options;
  options.iteration_cap = 1;
  CHECK_EQ(Error::none, prepared<double>(pair, options).error);
  options.tolerance = 1.0 - 0x1p-53;
  CHECK_EQ(Error::none, prepared<double>(pair, options).error);
  options.iteration_cap = 0;
  CHECK_EQ(Error::bad_options, prepared<double>(pair, options).error);
}

/// Every power of two at which a point can stand.
template <class S>
void check_units() {
  using Limits = std::numeric_limits<S>;
  using Traits = gjk::ScalarTraits<S>;
  for (int e = Limits::min_exponent - Limits::digits; e < Limits::max_exponent; ++e) {
    const check::Context context("exponent", e, "bytes", sizeof(S));
    const Pair<S> pair = points_apart(Traits::scaled(S(1), e));
    const gjk::Prepared<S, 2> found = prepared<S>(pair);
    CHECK_EQ(Error::none, found.error);
    const bool good = Traits::least_exponent() <= e && e <= Traits::largest_exponent();
    const int limit = Limits::max_exponent - 3;
    CHECK_EQ(good ? 0 : std::clamp(e, -limit, limit), found.exponent);
    CHECK_EQ(S(1), Traits::scaled(found.unit, found.exponent));
    CHECK_EQ(Traits::scaled(S(1), e - found.exponent), found.reach);
    CHECK_EQ(found.reach, gjk::support_point(pair.query(), found, {0, 0}).w[0]);
  }
}

TEST(units, "the unit of length is 1, or the size where squares would over- or underflow") {
  check_units<float>();
  check_units<double>();
  check_units<long double>();
}

TEST(half_units, "half has room for no size: its exact products are not relied on") {
  CHECK_EQ(Error::none, prepared<Eigen::half>(points_apart(Eigen::half(4.0f))).error);
  CHECK_EQ(Error::underflow, prepared<Eigen::half>(points_apart(Eigen::half(6e-8f))).error);
}

TEST(overflow, "what no unit of length can hold is refused by name") {
  constexpr double kMost = std::numeric_limits<double>::max();
  Pair<double> pair = points_apart(kMost);
  CHECK_EQ(Error::none, prepared<double>(pair).error);
  pair.y.push_back({0, 0});
  CHECK_EQ(Error::none, prepared<double>(pair).error);
  pair.x_pose.rotation = Eigen::Matrix2d::Identity() * kMost;
  pair.x[0] = {kMost, 0};
  CHECK_EQ(Error::overflow, prepared<double>(pair).error);
}

TEST(centers, "shapes around their own origin keep it, others are measured from their middle") {
  const Pair<double> pair{{{-1, -1}, {3, 1}}, {{-1, 5}, {3, 9}}};
  const gjk::Prepared<double, 2> found = prepared<double>(pair);
  CHECK((found.x.center == Vec<double, 2>(0, 0)));
  CHECK((found.y.center == Vec<double, 2>(1, 7)));
  CHECK((found.offset == Vec<double, 2>(1, 7)));
  CHECK(found.same_frame);
  Pair<double> moved = pair;
  moved.x_pose.translation = {0, 5};
  CHECK(!prepared<double>(moved).same_frame);
  CHECK((prepared<double>(moved).offset == Vec<double, 2>(1, 2)));
  moved = pair;
  moved.y_pose.rotation = Eigen::Matrix2d{{0, -1}, {1, 0}};
  CHECK(!prepared<double>(moved).same_frame);
  CHECK((prepared<double>(moved).offset == Vec<double, 2>(-7, 1)));
}

TEST(exact, "for exact scalars Y stands from X as its translation does") {
  using gjk::Expansion;
  gjk::Query<Expansion, 2> query;
  const std::vector<Vec<Expansion, 2>> origin = {{Expansion(0.0), Expansion(0.0)}};
  query.x = {origin, {}};
  query.y = {origin, {}};
  query.x.pose.translation = {Expansion(1.0), Expansion(5.0)};
  query.y.pose.translation = {Expansion(4.0), Expansion(3.0)};
  const gjk::Prepared<Expansion, 2> found = gjk::prepare<Expansion>(query, {});
  CHECK(found.offset[0] == Expansion(3.0));
  CHECK(found.offset[1] == Expansion(-2.0));
}

constexpr double kRoundoff = 0x1p-53;
const Eigen::Matrix2d kQuarterTurn{{0, -1}, {1, 0}};

// Shapes for which every term of a bound is known exactly: the radii are 1 and 5, the centers 8
// apart, and a point of Y may round 2.5 times its radius.
TEST(rounding, "bounds of rounding add up to what the analysis of each operation says") {
  Pair<double> pair{{{-1, 0}, {1, 0}}, {{3, 4}, {-3, -4}}};
  pair.y_pose = {kQuarterTurn, {8, 0}};
  const gjk::Prepared<double, 2> found = prepared<double>(pair);
  constexpr double kExtent = 1 + 5;
  constexpr double kMoved = 2.5 * 5;
  constexpr double kReach = 8 + kExtent;
  constexpr double kVertex = kRoundoff * (kExtent + kMoved);
  CHECK_EQ(kReach, found.from_origins);
  CHECK_EQ(kVertex, found.vertex_error);
  // Each of the vertices that a scan compares is a dot product, and was placed before.
  constexpr double kScan = kRoundoff * (4 * kExtent + 2 * kMoved);
  CHECK_EQ(kScan, found.scan_error_within(0.0));
  CHECK_EQ(kScan + 2 * 0x1p-50 * kExtent, found.scan_error_within(0x1p-50));
  // A small shape's vertex is seen where it is placed.
  CHECK_EQ(kVertex + kRoundoff * 4 * kExtent, found.plane_error(0.0, 0.0));
  CHECK_EQ(256 * kRoundoff * kRoundoff * kReach, found.careful_error());
  CHECK_EQ(kVertex + 16 * kRoundoff * kReach, found.simplex_error());

  for (int i = 0; i < 9; ++i) pair.x.push_back(pair.x[0]);
  CHECK_EQ(kVertex + kScan, prepared<double>(pair).plane_error(0.0, 0.0));
}

TEST(far_from_origins, "what is measured from a middle rounds with its distance from the origin") {
  Pair<double> pair{{{100, 0}, {102, 0}}, {{0, 50}, {0, 54}}};
  pair.y_pose = {kQuarterTurn, {0, 0}};
  const gjk::Prepared<double, 2> found = prepared<double>(pair);
  CHECK((found.offset == Vec<double, 2>(-52 - 101, 0)));
  CHECK_EQ(153.0 + 3.0, found.reach);
  CHECK_EQ(found.reach + (101.0 + 52.0), found.from_origins);
  CHECK_EQ(kRoundoff * 153.0, found.offset_error);
  CHECK_EQ(found.offset_error + kRoundoff * (3.0 + (1.0 + 2.0 + 2.5 * 2.0)), found.vertex_error);
}

TEST(in_space, "in space a product with a matrix rounds a little more") {
  using Point = Vec<double, 3>;
  const std::vector<Point> x = {{-1, 0, 0}, {1, 0, 0}};
  const std::vector<Point> y = {{0, 3, 4}, {0, -3, -4}};
  gjk::Query<double, 3> query{{x, {}}, {y, {}}};
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = kQuarterTurn;
  query.y.pose = {turn, {8, 0, 0}};
  const gjk::Prepared<double, 3> found = gjk::prepare<double>(query, {});
  CHECK_EQ(3.75 * 5, found.moved);
  CHECK_EQ(kRoundoff * (6 * 6.0 + 2 * found.moved), found.scan_error_within(0.0));
}

using Wide = Vec<long double, 2>;
Wide widened(const Vec<double, 2>& a) { return a.cast<long double>(); }
/// y - x in the world. What both translations share cancels first.
Wide difference(const Pair<double>& pair, std::size_t x, std::size_t y) {
  const Wide x_turned = pair.x_pose.rotation.matrix().cast<long double>() * widened(pair.x[x]);
  const Wide y_turned = pair.y_pose.rotation.matrix().cast<long double>() * widened(pair.y[y]);
  return (y_turned - x_turned) +
         (widened(pair.y_pose.translation) - widened(pair.x_pose.translation));
}

/// Over the pairs of a family, errors divided by their bounds.
struct Ratios {
  long double reach_low = 1e9L;
  long double reach_high = 0;
  long double least_high = 0;
  long double corner_low = 1;
  long double corner_high = 0;
  long double vertex = 0;
  int pairs = 0;
};
template <class R, class S>
Ratios measure(Family family, int pairs) {
  Ratios found;
  families::Source random(kSeed);
  const auto u = static_cast<long double>(gjk::ScalarTraits<R>::unit_roundoff());
  for (int i = 0; i < pairs; ++i) {
    const Pair<S> narrow = random.pair<S>(family);
    const Pair<double> pair = families::converted<double>(narrow);
    const gjk::Prepared<R, 2> ready = prepared<R>(narrow);
    if (ready.error != Error::none) continue;
    long double largest = 0;
    for (std::size_t a = 0; a < pair.x.size(); ++a) {
      for (std::size_t b = 0; b < pair.y.size(); ++b) {
        const Wide exact = difference(pair, a, b) * std::ldexp(1.0L, -ready.exponent);
        const gjk::VertexPair indices{static_cast<int>(a), static_cast<int>(b)};
        const Vec<R, 2> w = gjk::support_point(narrow.query(), ready, indices).w;
        const long double bound = static_cast<long double>(ready.vertex_error) +
                                  u * w.template cast<long double>().norm();
        const long double error = (w.template cast<long double>() - exact).norm();
        if (bound > 0) found.vertex = std::max(found.vertex, error / bound);
        if (!(bound > 0)) CHECK_EQ(0.0L, error);
        largest = std::max(largest, exact.norm());
      }
    }
    if (largest == 0) continue;
    const long double reach = static_cast<long double>(ready.reach) / largest;
    found.reach_low = std::min(found.reach_low, reach);
    found.reach_high = std::max(found.reach_high, reach);
    found.least_high =
        std::max(found.least_high, static_cast<long double>(ready.least_reach) / largest);
    long double corner = 0;
    for (const int a : ready.x.far_apart) {
      for (const int b : ready.y.far_apart) {
        const Vec<R, 2> w = gjk::support_point(narrow.query(), ready, {a, b}).w;
        corner = std::max(corner, w.template cast<long double>().norm());
      }
    }
    found.corner_low = std::min(found.corner_low, corner / largest);
    found.corner_high = std::max(found.corner_high, corner / largest);
    ++found.pairs;
  }
  return found;
}

TEST(reach,
     "some vertex of Z is as far as least_reach, none lies beyond reach; of four corners one lies "
     "at "
     "least a fifth as far as any") {
  for (int i = 0; i < kFamilyCount; ++i) {
    const auto family = static_cast<Family>(i);
    const check::Context context("seed", kSeed, kFamilyNames[i]);
    const Ratios found = measure<double, double>(family, 500);
    CHECK(found.reach_low >= 1 - 0x1p-50L);
    CHECK(found.reach_high <= 3);
    CHECK(found.least_high <= 1 + 0x1p-50L);
    CHECK(found.corner_low >= 0.2L);
    CHECK(found.corner_high <= 1 + 0x1p-50L);
    CHECK(found.pairs > 400);
  }
}

TEST(vertices, "vertices of Z err by less than their bound, but not by much less") {
  long double most = 0;
  for (int i = 0; i < kFamilyCount; ++i) {
    const check::Context context("seed", kSeed, kFamilyNames[i]);
    const Ratios in_float = measure<float, float>(static_cast<Family>(i), 500);
    const Ratios in_double = measure<double, double>(static_cast<Family>(i), 500);
    CHECK(in_float.vertex <= 1);
    CHECK(in_double.vertex <= 1);
    std::printf("  %-15s %.3Lf %.3Lf  reach %.3Lf ... %.3Lf\n", kFamilyNames[i].data(),
                in_float.vertex, in_double.vertex, in_double.reach_low, in_double.reach_high);
    if (static_cast<Family>(i) == Family::posed) most = std::min(in_float.vertex, in_double.vertex);
  }
  CHECK(most > 0.25L);
}

}  // namespace prepare_test
