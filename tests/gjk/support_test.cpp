// Phase "support": scan and climb, the difference of two vertices, and the plane that it proves.

#include "gjk/support.hpp"

#include <algorithm>

#include "check.hpp"
#include "study/families.hpp"

namespace support_test {

using gjk::Vec;

template <class R, class S>
gjk::SupportPoint<R, 2> support_point(const families::Pair<S>& pair, gjk::VertexPair indices) {
  return gjk::support_point(pair.query(), gjk::prepare<R>(pair.query(), {}), indices);
}

TEST(scan_first, "the scan takes the first vertex with the largest dot product") {
  const std::vector<Vec<double, 2>> vertices = {{11, 9}, {13, 10}, {13, 8}, {10, 9}};
  const std::vector<Vec<double, 2>> point = {{0, 0}};
  const gjk::Query<double, 2> query{{point}, {vertices}};
  const auto prepared = gjk::prepare<double>(query, {});
  gjk::State<double, 2> state;
  state.d = Vec<double, 2>(2, 0);
  gjk::Record<double, 2> record;
  gjk::find_support(state, query, prepared, record);
  CHECK_EQ(1, state.support.pair.y);
  CHECK_EQ(std::size_t{4}, record.scan_y.size());
  const double values[] = {22, 26, 26, 20};  // measured from the origin, not from the center
  const bool improves[] = {true, true, false, false};
  for (int i = 0; i < 4; ++i) {
    CHECK_EQ(i, record.scan_y[i].index);
    CHECK_EQ(values[i], record.scan_y[i].value);
    CHECK_EQ(improves[i], record.scan_y[i].improves);
  }
}

TEST(ties, "of vertices that lie equally far the scan takes the first, wherever they stand") {
  for (int count = 1; count <= 7; ++count) {
    for (int far = 1; far < 1 << count; ++far) {
      const check::Context context("vertices", count, "far ones, as bits", far);
      std::vector<Vec<double, 2>> vertices;
      for (int i = 0; i < count; ++i) vertices.emplace_back((far >> i) & 1, i);
      const gjk::Query<double, 2> query{{vertices}, {vertices}};
      const auto prepared = gjk::prepare<double>(query, {});
      CHECK_EQ(__builtin_ctz(static_cast<unsigned>(far)),
               gjk::farthest_vertex(Vec<double, 2>(1, 0), query.y, prepared, prepared.y));
    }
  }
}

/// `count` corners of an ellipse, `flatness` times as high as wide, turned and moved.
template <class S>
std::vector<Vec<S, 2>> ellipse(families::Source& random, int count, double flatness) {
  std::vector<Vec<S, 2>> out;
  const double turn = random.between(0, 6.283185307179586);
  const double far = random.with_chance(0.5) ? 0 : random.magnitude(1, 1e3);
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * (i + random.between(0, 0.5)) / count;
    const double x = std::cos(angle);
    const double y = flatness * std::sin(angle);
    out.emplace_back(static_cast<S>(x * std::cos(turn) - y * std::sin(turn) + far),
                     static_cast<S>(x * std::sin(turn) + y * std::cos(turn) - far));
  }
  if (random.with_chance(0.5)) std::reverse(out.begin(), out.end());
  return out;
}

struct Climbs {
  long count = 0;
  long looked_at = 0;  ///< Vertices, and how many there were.
  long vertices = 0;
};
/// Directions of all kinds; most lie across an edge, where two vertices and more come close.
/// The vertex of Y farthest along d, by climbing or by a scan.
template <class R, class S>
int farthest(const gjk::Query<S, 2>& query, const gjk::Prepared<R, 2>& prepared, const Vec<R, 2>& d,
             bool climbs, long& looked_at) {
  gjk::Body<R, 2> body = prepared.y;
  CHECK(body.is_ring);
  body.is_ring = climbs;
  looked_at += static_cast<long>(gjk::scan_entries(d, query.y, prepared, body).size());
  return gjk::farthest_vertex(d, query.y, prepared, body);
}
template <class R, class S>
int farthest(const gjk::Query<S, 2>& query, const gjk::Prepared<R, 2>& prepared, const Vec<R, 2>& d,
             bool climbs) {
  long looked_at = 0;
  return farthest(query, prepared, d, climbs, looked_at);
}

template <class R, class S>
Climbs check_climbs(std::uint64_t seed, double least_flatness) {
  Climbs climbs;
  families::Source random(seed);
  for (int i = 0; i < 600; ++i) {
    const int most_octave = i % 20 == 0 ? 12 : 8;
    const int count = i % 7 == 0 ? (1 << random.among(5, most_octave))
                                 : random.among(32, 1 << random.among(6, most_octave));
    const auto list = ellipse<S>(random, count, random.magnitude(least_flatness, 1));
    const std::vector<Vec<S, 2>> origin = {{0, 0}};
    const gjk::Query<S, 2> query{{origin}, {list}};
    if (!gjk::Measures<S, 2>(list).is_ring) continue;
    const auto prepared = gjk::prepare<R>(query, {});
    for (int k = 0; k < 40; ++k) {
      const check::Context context("seed", seed, "ring", i, "corners", count, "direction", k);
      Vec<R, 2> d(static_cast<R>(random.between(-1, 1)), static_cast<R>(random.between(-1, 1)));
      if (k < 4) d = Vec<R, 2>(k == 0 ? 1 : k == 1 ? -1 : 0, k == 2 ? 1 : k == 3 ? -1 : 0);
      if (k > 12) {
        const auto at = static_cast<std::size_t>(random.among(0, count - 1));
        const Vec<S, 2> edge = list[(at + 1) % list.size()] - list[at];
        d = Vec<R, 2>(static_cast<R>(edge[1]), -static_cast<R>(edge[0]));
        if (k % 2 == 0) d = -d;
      }
      long looked_at = 0;
      const int found = farthest(query, prepared, d, true, looked_at);
      CHECK_EQ(farthest(query, prepared, d, false), found);
      ++climbs.count;
      climbs.looked_at += looked_at;
      climbs.vertices += count;
    }
  }
  return climbs;
}

TEST(climbing,
     "on rings of 32 to 4096 corners, near-flat ones too, the climb finds what a scan does") {
  const Climbs round = check_climbs<double, double>(51, 0.2);
  const Climbs flat = check_climbs<double, double>(52, 1e-9);
  const Climbs in_float = check_climbs<float, float>(53, 1e-3);
  const Climbs mixed = check_climbs<double, float>(54, 1e-3);
  for (const Climbs& climbs : {round, flat, in_float, mixed}) {
    std::printf("  %ld climbs, %ld of %ld vertices\n", climbs.count, climbs.looked_at,
                climbs.vertices);
    CHECK(climbs.count > 4000);
  }
  CHECK(round.looked_at * 4 < round.vertices);
}

/// A parabola whose corners are bent by as little as doubles allow, closed by a corner above.
std::vector<Vec<double, 2>> flat_chain(families::Source& random, int count) {
  std::vector<Vec<double, 2>> out;
  const long slope = (1L << 41) + (static_cast<long>(random.among(0, 1 << 30)) << 11) + 1;
  const int bend = random.among(1, 2);
  for (long i = -count / 2; i <= count / 2; ++i) {
    const auto y = static_cast<double>(i * slope + bend * i * i);
    out.emplace_back(static_cast<double>(i) * 0x1p-11, y * 0x1p-53);
  }
  out.emplace_back(-1, 2);
  return out;
}

TEST(flat_climbs,
     "where many vertices lie as far up to rounding, the climb looks beyond them all") {
  families::Source random(56);
  int rings = 0;
  for (int i = 0; i < 400; ++i) {
    const auto list = flat_chain(random, random.among(2000, 4000));
    const std::vector<Vec<double, 2>> origin = {{0, 0}};
    const gjk::Query<double, 2> query{{origin}, {list}};
    if (!gjk::Measures<double, 2>(list).is_ring) continue;
    ++rings;
    const auto prepared = gjk::prepare<double>(query, {});
    for (int k = 0; k < 20; ++k) {
      const check::Context context("seed", 56, "ring", i, "direction", k);
      const auto at = static_cast<std::size_t>(random.among(0, static_cast<int>(list.size()) - 3));
      const Vec<double, 2> edge = list[at + 1] - list[at];
      const Vec<double, 2> d(edge[1], -edge[0]);
      CHECK_EQ(farthest(query, prepared, d, false), farthest(query, prepared, d, true));
    }
  }
  CHECK(rings > 100);
}

TEST(climb_notes, "a climb notes the vertices that it looked at, with their values") {
  families::Source random(55);
  const auto list = ellipse<double>(random, 1024, 0.7);
  const std::vector<Vec<double, 2>> origin = {{0, 0}};
  const gjk::Query<double, 2> query{{origin}, {list}};
  gjk::State<double, 2> state;
  state.d = Vec<double, 2>(0.3, -0.8);
  gjk::Record<double, 2> record;
  gjk::find_support(state, query, gjk::prepare<double>(query, {}), record);
  CHECK(record.scan_y.size() < 100);
  CHECK_EQ(32, record.scan_y[1].index);  // samples are as far apart as there are
  double best = -std::numeric_limits<double>::infinity();
  for (const gjk::ScanEntry<double>& entry : record.scan_y) {
    CHECK_NEAR(gjk::dot(state.d, list[entry.index]), entry.value, 1e-12);
    CHECK(!entry.improves || entry.value > best);
    best = std::max(best, entry.value);
  }
  CHECK_NEAR(best, gjk::dot(state.d, list[state.support.pair.y]), 1e-12);
}

TEST(turned_scans,
     "few vertices are turned into the world, of many the direction into their frame") {
  constexpr std::uint64_t kSeed = 8;
  families::Source random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const check::Context context("seed", kSeed, "shape", i);
    std::vector<Vec<double, 2>> vertices;
    for (int k = 0; k < 8 + i % 2; ++k) {
      vertices.emplace_back(random.between(-1, 1), random.between(-1, 1));
    }
    const std::vector<Vec<double, 2>> point = {{0, 0}};
    gjk::Query<double, 2> query{{point}, {vertices}};
    const double angle = random.between(0, 6.3);
    query.y.pose.rotation =
        Eigen::Matrix2d{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
    const auto prepared = gjk::prepare<double>(query, {});
    const Vec<double, 2> d(random.between(-1, 1), random.between(-1, 1));
    const bool small = vertices.size() == 8;
    const gjk::Along<double, double, 2> along(d, query.y, prepared, prepared.y);
    CHECK_EQ(static_cast<int>(vertices.size()), along.count());
    for (int k = 0; k < along.count(); ++k) {
      const double expected = small ? gjk::dot(d, query.y.pose.rotated(vertices[k]))
                                    : gjk::dot(query.y.pose.direction_to_local(d), vertices[k]);
      CHECK_EQ(expected, along(k));
    }
  }
}

TEST(convention, "Z = Y - X: a support point is y - x in the world, with both indices") {
  families::Pair<double> pair{{{1, 1}, {2, 5}}, {{7, 3}, {4, 4}, {9, 9}}};
  pair.x_pose.translation = Vec<double, 2>(10, 0);
  const auto point = support_point<double>(pair, {1, 2});
  CHECK_EQ(-3.0, point.w[0]);
  CHECK_EQ(4.0, point.w[1]);
  CHECK((point.pair == gjk::VertexPair{1, 2}));
}

TEST(farthest, "support(Z, d) = support(Y, d) - support(X, -d) is the farthest point of Z") {
  constexpr std::uint64_t kSeed = 5;
  families::Source random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    const auto pair = random.pair<double>(families::Family::grid);
    const gjk::Query<double, 2> query = pair.query();
    gjk::State<double, 2> state;
    state.d = Vec<double, 2>(random.among(-3, 3), random.among(-3, 3));
    gjk::NoRecord none;
    gjk::find_support(state, query, gjk::prepare<double>(query, {}), none);
    for (const Vec<double, 2>& x : pair.x) {
      for (const Vec<double, 2>& y : pair.y) {
        CHECK(gjk::dot<double, 2>(state.d, y - x) <= state.support_value);
      }
    }
  }
}

TEST(translation, "a huge translation common to both poses cancels to the last bit") {
  constexpr std::uint64_t kSeed = 6;
  families::Source random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    auto pair = random.pair<float>(families::Family::random);
    pair.x_pose.translation = pair.y_pose.translation = Vec<float, 2>(1, 0);
    const auto near = support_point<float>(pair, {0, 0});
    pair.x_pose.translation = pair.y_pose.translation = Vec<float, 2>(1e9f, -3e8f);
    const auto far = support_point<float>(pair, {0, 0});
    CHECK(near.w == far.w);
  }
}

TEST(plane, "a support plane with O beyond it is noted, unless a farther one is known") {
  gjk::State<double, 2> state;
  state.d = Vec<double, 2>(-2, 0);  // length does not matter
  state.support.w = Vec<double, 2>(3, 7);
  state.support_value = -6;
  state.evidence.add_plane(state.d, state.support.w, state.support_value);
  CHECK_EQ(9.0, state.evidence.plane_distance_sq);
  CHECK_EQ(58.0, state.evidence.plane_reach_sq);
  state.support.w = Vec<double, 2>(3, 1);  // as far
  state.evidence.add_plane(state.d, state.support.w, state.support_value);
  CHECK_EQ(58.0, state.evidence.plane_reach_sq);
  state.support.w = Vec<double, 2>(2, 1);
  state.support_value = -4;
  state.evidence.add_plane(state.d, state.support.w, state.support_value);
  CHECK_EQ(9.0, state.evidence.plane_distance_sq);
  CHECK_EQ(58.0, state.evidence.plane_reach_sq);
}

TEST(no_plane, "a plane through O, or with O on the side of Z, proves nothing; nor does d = 0") {
  gjk::State<double, 2> state;
  state.support.w = Vec<double, 2>(3, 7);
  state.d = Vec<double, 2>(-1, 0);
  for (const double value : {0.0, 1.0}) {
    state.support_value = value;
    state.evidence.add_plane(state.d, state.support.w, state.support_value);
    CHECK_EQ(0.0, state.evidence.plane_distance_sq);
    CHECK_EQ(0.0, state.evidence.plane_reach_sq);
  }
  state.d = Vec<double, 2>::Zero();
  state.support_value = -1;
  state.evidence.add_plane(state.d, state.support.w, state.support_value);
  CHECK_EQ(0.0, state.evidence.plane_distance_sq);
}

TEST(plane_through_origin, "a support plane through O is seen, and no other") {
  for (const double x : {-1.0, 0.0, 1.0}) {
    const std::vector<Vec<double, 2>> point = {{0, 0}};
    const std::vector<Vec<double, 2>> other = {{x, 5}};
    const gjk::Query<double, 2> query{{point}, {other}};
    gjk::State<double, 2> state;
    state.d = Vec<double, 2>(-1, 0);
    gjk::NoRecord record;
    gjk::find_support(state, query, gjk::prepare<double>(query, {}), record);
    CHECK_EQ(x == 0.0, state.evidence.touches_plane);
  }
}

TEST(plane_rounding, "a plane proves its distance but for what rounding may have added") {
  constexpr double kRoundoff = 0x1p-53;
  gjk::Prepared<double, 2> prepared;
  prepared.vertex_error = 8 * kRoundoff;
  prepared.scans_placed = true;
  // w and dot(d, w) round with |w|; |d| and the division with the distance.
  constexpr double kError = (8 + 3 * 5 + 4 * 3) * kRoundoff;
  CHECK_EQ(kError, prepared.plane_error(3.0, 5.0));
  const gjk::Prepared<double, 3> in_space;
  CHECK_EQ((4 * 5 + 4.5 * 3) * kRoundoff, in_space.plane_error(3.0, 5.0));
}

}  // namespace support_test
