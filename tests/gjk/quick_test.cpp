// The ordinary query: what the quick way answers is what the phases answer, and it does answer.

#include "gjk/quick.hpp"

#include "check.hpp"
#include "geometry/families.hpp"
#include "same_bits.hpp"

namespace {

using families::Family;
using gjk::Vec;

struct Shares {
  long ordinary = 0;
  long answered = 0;
};

template <class S>
void compare(const gjk::Query<S, 2>& query, const gjk::Options& options, Shares& shares) {
  if (!gjk::quick::is_ordinary(query, options)) return;
  ++shares.ordinary;
  gjk::Result<double, 2> quick;
  if (!gjk::quick::distance(query, options, quick)) return;
  ++shares.answered;
  const auto prepared = gjk::prepare<double>(query, options);
  const auto end = gjk::detail::run(query, options, prepared);
  CHECK(check::same_bits(gjk::result(end, query, options, prepared), quick));
}

/// Cold, warm, and with a cap that some runs reach.
template <class S>
void compare_all_families(std::uint64_t seed) {
  families::Source random(seed);
  for (int i = 0; i < 40 * families::kFamilyCount; ++i) {
    const auto family = static_cast<Family>(i % families::kFamilyCount);
    const check::Context context("seed", seed, "pair", i, "family",
                                 families::kFamilyNames[i % families::kFamilyCount]);
    const families::Pair<S> pair = random.pair<S>(family);
    Shares shares;
    compare(pair.query(), {}, shares);
    gjk::Options warm;
    warm.start_count = 1;
    warm.start[0] = {random.among(0, static_cast<int>(pair.x.size()) - 1),
                     random.among(0, static_cast<int>(pair.y.size()) - 1)};
    compare(pair.query(), warm, shares);
    gjk::Options short_run;
    short_run.iteration_cap = random.among(1, 3);
    compare(pair.query(), short_run, shares);
  }
}

TEST(as_the_phases, "what the quick way answers, the phases do, to the last bit") {
  compare_all_families<double>(20100312);
  compare_all_families<float>(20100313);
}

TEST(near_an_end, "so it is where P lies nearly at an end of an edge, within what rounding hides") {
  const std::vector<Vec<double, 2>> point = {{0, 0}};
  const std::vector<Vec<double, 2>> triangle = {{0, 0}, {3, 0}, {1, -2}};
  Shares shares;
  long on_edge = 0;
  for (int exponent = 40; exponent <= 60; ++exponent) {
    for (const double height : {0x1p-10, 0x1p-25, 0x1p-27}) {
      gjk::Query<double, 2> query{{point}, {triangle}};
      query.x.pose.translation = Vec<double, 2>(std::ldexp(1.0, -exponent), height);
      query.y.pose.rotation = Eigen::Matrix2d{{0.6, -0.8}, {0.8, 0.6}};
      query.x.pose.translation = query.y.pose.rotated(query.x.pose.translation);
      const check::Context context("2^-", exponent, "height", height);
      compare(query, {}, shares);
      on_edge += gjk::distance(query).simplex.count == 2 ? 1 : 0;
    }
  }
  CHECK(shares.answered > 30);
  CHECK(on_edge > 60);
}

/// How shapes of `count` vertices stand.
enum class Stand { in_one_frame, moved, turned, turned_far_from_their_origin };

Shares shares_of(int count, Stand stand) {
  constexpr std::uint64_t kSeed = 20100314;
  families::Source random(kSeed);
  Shares shares;
  for (int i = 0; i < 500; ++i) {
    const check::Context context("seed", kSeed, "pair", i, "vertices", count);
    families::Pair<double> pair = random.polygons(count);
    if (stand == Stand::turned_far_from_their_origin) {
      for (Vec<double, 2>& vertex : pair.x) vertex += Vec<double, 2>(100.0, -30.0);
      for (Vec<double, 2>& vertex : pair.y) vertex += Vec<double, 2>(100.0, -30.0);
    }
    if (stand != Stand::in_one_frame) pair.y_pose.translation[0] = random.between(-0.5, 0.5);
    if (stand >= Stand::turned) {
      const double angle = random.between(-0.2, 0.2);
      pair.x_pose.rotation =
          Eigen::Matrix2d{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
      pair.y_pose.rotation = pair.x_pose.rotation;
    }
    compare(pair.query(), {}, shares);
  }
  return shares;
}

TEST(ordinary, "polygons go the quick way, however they stand, and come to its end") {
  for (const int count : {1, 2, 3, 4, 5, 8, 9, 12}) {
    for (const Stand stand :
         {Stand::in_one_frame, Stand::moved, Stand::turned, Stand::turned_far_from_their_origin}) {
      const check::Context context("vertices", count, "stand", static_cast<int>(stand));
      const Shares shares = shares_of(count, stand);
      CHECK_EQ(500L, shares.ordinary);
      CHECK(shares.answered >= 495);
    }
  }
}

TEST(not_ordinary, "other rules and large rings go through the phases") {
  const std::vector<Vec<double, 2>> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<Vec<double, 2>> ring;
  for (int i = 0; i < 64; ++i)
    ring.emplace_back(3.0 + std::cos(0.098 * i - 3.1), std::sin(0.098 * i - 3.1));
  const auto is_ordinary = gjk::quick::is_ordinary<double>;
  const gjk::Query<double, 2> query{{square}, {square}};
  CHECK(is_ordinary(query, {}));
  gjk::Options warm;
  warm.start_count = 1;
  CHECK(is_ordinary(query, warm));
  const auto refused = [&](const auto& change) {
    gjk::Options options;
    change(options);
    return !is_ordinary(query, options);
  };
  CHECK(refused([](auto& o) { o.start_count = 2; }));
  CHECK(refused([](auto& o) { o.direction_rule = gjk::DirectionRule::towards_origin; }));
  CHECK(refused([](auto& o) { o.region_order = gjk::RegionOrder::edges_first; }));
  CHECK(refused([](auto& o) { o.stop_on_repeated_support = false; }));
  CHECK(refused([](auto& o) { o.stop_on_no_progress = false; }));
  CHECK(refused([](auto& o) { o.tolerance = 0.1; }));
  CHECK(refused([](auto& o) { o.iteration_cap = 0; }));
  CHECK(!is_ordinary({{square}, {ring}}, {}));
  CHECK(!is_ordinary({{ring}, {square}}, {}));
  const std::vector<Vec<double, 2>> huge = {{1e300, 0}, {2e300, 1e300}, {1e300, 2e300}};
  gjk::Result<double, 2> out;
  CHECK(!gjk::quick::distance<double>({{huge}, {square}}, {}, out));
  for (const double bad : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    for (const std::size_t count : {2U, 9U}) {
      const std::vector<Vec<double, 2>> some(ring.begin(), ring.begin() + static_cast<long>(count));
      const std::vector<Vec<double, 2>> many(ring.begin(), ring.begin() + 9);
      gjk::Query<double, 2> poisoned{{many}, {some}};
      poisoned.y.pose.rotation = Eigen::Matrix2d{{bad, bad}, {-bad, bad}};
      poisoned.x.pose.translation = {bad, -bad};
      CHECK(!gjk::quick::distance(poisoned, {}, out));
    }
  }
}

TEST(grid, "where the run does not round it gives up nothing that bounds can prove") {
  families::Source random(20100317);
  long apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const check::Context context("pair", i);
    const int extent = random.among(1, 3);
    const auto list = random.grid_points<double>(random.among(1, 10), extent);
    const auto other = random.grid_points<double>(random.among(1, 10), extent);
    gjk::Query<double, 2> query{{list}, {other}};
    query.y.pose.translation = Vec<double, 2>(random.among(0, 2 * extent), random.among(0, extent));
    gjk::Options from;
    from.start_count = 1;
    from.start[0] = {random.among(0, static_cast<int>(list.size()) - 1),
                     random.among(0, static_cast<int>(other.size()) - 1)};
    Shares shares;
    compare(query, from, shares);
    const gjk::Result<double, 2> result = gjk::distance(query, from);
    if (result.verdict != gjk::Verdict::separated || result.settled) continue;
    CHECK_EQ(1L, shares.answered);
    ++apart;
  }
  CHECK(apart > 5000);
}

/// Calls `check` with the shapes of every kind that has room for them.
template <class Check>
void with_each_kind_of_shapes(const gjk::Query<double, 2>& query,
                              const gjk::Prepared<double, 2>& prepared, const Check& check) {
  constexpr int kRows = gjk::Rows::kCount;
  if (!gjk::detail::has_trait(query, gjk::Points<double, 2>::kMoreThanFour)) {
    check(gjk::quick::SmallShapes<double, 4>(query, prepared));
  }
  check(gjk::quick::SmallShapes<double, kRows>(query, prepared));
  check(gjk::quick::AnyShapes<double>(query, prepared));
}

TEST(scans, "a scan takes the first of the vertices that lie farthest, on either side") {
  families::Source random(20100315);
  for (int i = 0; i < 20000; ++i) {
    const int count = random.among(1, 12);
    const auto list = random.grid_points<double>(count, random.among(1, 3));
    const auto other = random.grid_points<double>(random.among(1, 12), random.among(1, 3));
    const gjk::Two d{static_cast<double>(random.among(-2, 2)),
                     static_cast<double>(random.among(-2, 2))};
    const auto first_along = [](const std::vector<Vec<double, 2>>& vertices, const gjk::Two& to) {
      int first = 0;
      for (int k = 1; k < static_cast<int>(vertices.size()); ++k) {
        const auto along = [&](int j) {
          const Vec<double, 2>& vertex = vertices[static_cast<std::size_t>(j)];
          return to[0] * vertex[0] + to[1] * vertex[1];
        };
        first = along(first) < along(k) ? k : first;
      }
      return first;
    };
    const check::Context context("list", i, "of", count);
    CHECK_EQ(first_along(list, d), gjk::quick::farthest(count, d, [&](int k) {
               return gjk::two(list[static_cast<std::size_t>(k)]);
             }));
    gjk::Query<double, 2> query{{list}, {other}};
    if (i % 2 == 0) query.y.pose.translation[0] = 0.25;
    const auto prepared = gjk::prepare<double>(query, {});
    if (!query.x.vertices.is_small() || !query.y.vertices.is_small() || prepared.centred) continue;
    const bool other_way = random.with_chance(0.5);
    const gjk::Two along = other_way ? -d : d;
    const gjk::VertexPair farthest{first_along(list, -along), first_along(other, along)};
    const auto expected = gjk::support_point(query, prepared, farthest);
    const auto check = [&](const auto& shapes) {
      const auto check_found = [&](const gjk::quick::Corner& found) {
        CHECK((farthest == gjk::quick::indices(found.pair)));
        CHECK((expected.w == Vec<double, 2>(found.w[0], found.w[1])));
      };
      CHECK((farthest == gjk::quick::indices(shapes.farthest_against(-along).pair)));
      check_found(shapes.support_against(-along));
      const gjk::Two edge{-d[1], d[0]};
      check_found(shapes.support_across(edge, gjk::quick::both(other_way ? -0.0 : 0.0)));
    };
    with_each_kind_of_shapes(query, prepared, check);
  }
}

TEST(alone, "it knows as the phases do when no vertex but the simplex's can lie as far") {
  families::Source random(20100316);
  long known = 0;
  long not_known = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto list = random.grid_points<double>(random.among(1, 8), random.among(1, 3));
    const auto other = random.grid_points<double>(random.among(1, 8), random.among(1, 3));
    gjk::Query<double, 2> query{{list}, {other}};
    query.y.pose.translation[0] = 0.25;
    const auto prepared = gjk::prepare<double>(query, {});
    const Vec<double, 2> d(random.among(-2, 2), random.among(-2, 2));
    const auto any_pair = [&] {
      return gjk::VertexPair{random.among(0, static_cast<int>(list.size()) - 1),
                             random.among(0, static_cast<int>(other.size()) - 1)};
    };
    const gjk::VertexPair a = gjk::detail::farthest_pair(query, prepared, d);
    gjk::VertexPair b = any_pair();
    if (random.with_chance(0.3)) b.x = a.x;
    if (random.with_chance(0.3)) b.y = a.y;
    const bool on_edge = !(a == b);
    const double angle = random.with_chance(0.5) ? 0.0 : 0.2;
    const bool expected = gjk::detail::ShapesAsked<double, double>{query, prepared, a, b, on_edge}
                              .is_certainly_farthest(gjk::flat(d), gjk::length(d), angle);
    const double error = gjk::length(d) * prepared.scan_error_within(angle);
    const gjk::Two along = gjk::two(d);
    const check::Context context("pair", i);
    with_each_kind_of_shapes(query, prepared, [&](const auto& shapes) {
      CHECK_EQ(expected, shapes.are_alone(along, a, b, error));
    });
    ++(expected ? known : not_known);
  }
  CHECK(known > 500);
  CHECK(not_known > 5000);
}

}  // namespace
