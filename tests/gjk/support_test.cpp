// Phase "support": scan and climb, the difference of two vertices, and the plane that it proves.

#include "gjk/support.hpp"

#include "check.hpp"
#include "families.hpp"

namespace {

using gjk::Vec;

template <class R, class S>
gjk::SupportPoint<R, 2> support_point(const families::Pair<S>& pair, gjk::VertexPair indices) {
  return gjk::support_point(pair.query(), gjk::prepare<R>(pair.query(), {}), indices);
}

TEST(scan_first, "the scan takes the first vertex with the largest dot product") {
  const std::vector<Vec<double, 2>> vertices = {{1, 0}, {3, 1}, {3, -1}, {0, 0}};
  const std::vector<Vec<double, 2>> point = {{0, 0}};
  const gjk::Query<double, 2> query{{point}, {vertices}};
  const auto prepared = gjk::prepare<double>(query, {});
  gjk::State<double, 2> state;
  state.d = Vec<double, 2>(2, 0);
  gjk::Record<double, 2> record;
  gjk::detail::find_support(state, query, prepared, record);
  CHECK_EQ(1, state.support.pair.y);
  CHECK_EQ(std::size_t{4}, record.scan_y.size());
  const double values[] = {2, 6, 6, 0};
  const bool improves[] = {true, true, false, false};
  for (int i = 0; i < 4; ++i) {
    CHECK_EQ(i, record.scan_y[i].index);
    CHECK_EQ(values[i], record.scan_y[i].value);
    CHECK_EQ(improves[i], record.scan_y[i].improves);
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
    gjk::detail::find_support(state, query, gjk::prepare<double>(query, {}), none);
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
  gjk::detail::note_support_plane(state);
  CHECK_EQ(9.0, state.plane_distance_sq);
  CHECK_EQ(58.0, state.plane_reach_sq);
  state.support.w = Vec<double, 2>(2, 1);
  state.support_value = -4;
  gjk::detail::note_support_plane(state);
  CHECK_EQ(9.0, state.plane_distance_sq);
  CHECK_EQ(58.0, state.plane_reach_sq);
}

TEST(no_plane, "a plane through O, or with O on the side of Z, proves nothing; nor does d = 0") {
  gjk::State<double, 2> state;
  state.support.w = Vec<double, 2>(3, 7);
  state.d = Vec<double, 2>(-1, 0);
  for (const double value : {0.0, 1.0}) {
    state.support_value = value;
    gjk::detail::note_support_plane(state);
    CHECK_EQ(0.0, state.plane_distance_sq);
    CHECK_EQ(0.0, state.plane_reach_sq);
  }
  state.d = Vec<double, 2>::Zero();
  state.support_value = -1;
  gjk::detail::note_support_plane(state);
  CHECK_EQ(0.0, state.plane_distance_sq);
}

}  // namespace
