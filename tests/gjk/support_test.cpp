// Phase "support": the scan, the difference of two vertices, and the plane that it proves.

#include "gjk/support.hpp"

#include "check.hpp"
#include "families.hpp"

namespace {

using gjk::Vec;

TEST(scan_first, "the scan takes the first vertex with the largest dot product") {
  const std::vector<Vec<double, 2>> vertices = {{1, 0}, {3, 1}, {3, -1}, {0, 0}};
  std::vector<gjk::ScanEntry<double>> entries;
  const int best = gjk::detail::scan<true, double, 2>(vertices, Vec<double, 2>(2, 0), &entries);
  CHECK_EQ(1, best);
  CHECK_EQ(std::size_t{4}, entries.size());
  const double values[] = {2, 6, 6, 0};
  const bool improves[] = {true, true, false, false};
  for (int i = 0; i < 4; ++i) {
    CHECK_EQ(i, entries[i].index);
    CHECK_EQ(values[i], entries[i].value);
    CHECK_EQ(improves[i], entries[i].improves);
  }
}

TEST(convention, "Z = Y - X: a support point keeps y - x, both vertices and both indices") {
  const std::vector<Vec<double, 2>> x = {{1, 1}, {2, 5}};
  const std::vector<Vec<double, 2>> y = {{7, 3}, {4, 4}, {9, 9}};
  gjk::Query<double, 2> query{{x}, {y}};
  query.x.pose.translation = Vec<double, 2>(10, 0);
  const auto point = gjk::detail::support_point(query, {1, 2});
  CHECK_EQ(-3.0, point.w[0]);
  CHECK_EQ(4.0, point.w[1]);
  CHECK_EQ(12.0, point.x[0]);
  CHECK_EQ(9.0, point.y[0]);
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
    gjk::detail::find_support(state, query, gjk::prepare(query, {}), none);
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
    const gjk::SupportPoint<float, 2> near = gjk::detail::support_point(pair.query(), {0, 0});
    pair.x_pose.translation = pair.y_pose.translation = Vec<float, 2>(1e9f, -3e8f);
    const gjk::SupportPoint<float, 2> far = gjk::detail::support_point(pair.query(), {0, 0});
    CHECK(near.w == far.w);
  }
}

TEST(plane, "a support plane with O beyond it is a lower bound, less the rounding error") {
  gjk::State<double, 2> state;
  state.d = Vec<double, 2>(-2, 0);  // length does not matter
  state.support.w = Vec<double, 2>(3, 7);
  state.support_value = -6;
  gjk::detail::note_support_plane(state, gjk::Prepared<double>{10.0, gjk::Error::none});
  CHECK(state.plane_distance_sq < 9.0);
  CHECK_NEAR(9.0, state.plane_distance_sq, 1e-12);
  const double before = state.plane_distance_sq;
  state.support_value = -4;  // a nearer plane does not lower the bound
  gjk::detail::note_support_plane(state, gjk::Prepared<double>{10.0, gjk::Error::none});
  CHECK_EQ(before, state.plane_distance_sq);
}

TEST(no_plane, "a plane through O, or within rounding of it, proves nothing") {
  gjk::State<double, 2> state;
  state.d = Vec<double, 2>(-1, 0);
  for (const double value : {0.0, 1.0, -1e-16}) {
    state.support_value = value;
    gjk::detail::note_support_plane(state, gjk::Prepared<double>{10.0, gjk::Error::none});
    CHECK_EQ(0.0, state.plane_distance_sq);
  }
}

}  // namespace
