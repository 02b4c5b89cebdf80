// Phases "stop" and "add": every stop reason has a run that ends with it.

#include "gjk/stop.hpp"

#include "check.hpp"
#include "gjk/gjk.hpp"

namespace stop_test {

using gjk::StopReason;
using gjk::Vec;
using gjk::Verdict;
using Points = std::vector<Vec<double, 2>>;

const Points kSquare = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

struct Run {
  Points x;
  Points y;
  gjk::Options options;
  gjk::Trace<double, 2> trace;
  Run(Points x_points, Points y_points, const gjk::Options& run_options = {})
      : x(std::move(x_points)), y(std::move(y_points)), options(run_options) {
    trace = gjk::trace(gjk::Query<double, 2>{{x}, {y}}, options);
  }
  [[nodiscard]] const gjk::Result<double, 2>& result() const { return trace.result; }
  /// The test that ended the run.
  [[nodiscard]] gjk::StopTest<double> held() const {
    for (const gjk::StopTest<double>& test : trace.steps.back().record.stop_tests) {
      if (test.holds) return test;
    }
    return {};
  }
};

TEST(repeated, "repeated support: the support point is already in the simplex") {
  const Run run({{3, 0}}, kSquare);
  CHECK_EQ(StopReason::repeated_support, run.result().stop);
  CHECK_EQ(StopReason::repeated_support, run.held().reason);
  CHECK_EQ(2.0, run.result().distance);
  CHECK(run.held().left >= run.held().right);
}

TEST(inside, "origin inside: three vertices around O") {
  const Run run({{0.25, 0.5}}, kSquare);
  CHECK_EQ(StopReason::origin_inside, run.result().stop);
  CHECK_EQ(0.0, run.result().distance);
  CHECK_EQ(Verdict::overlapping, run.result().verdict);
  CHECK_EQ(3, run.result().simplex.count);
  CHECK_EQ(run.held().left, run.held().right);
}

TEST(zero, "zero direction: O lies on the simplex and d = O - P vanishes") {
  const Run vertex({{-1, -1}}, kSquare);
  CHECK_EQ(StopReason::zero_direction, vertex.result().stop);
  CHECK_EQ(0.0, vertex.result().distance);
  CHECK_EQ(1, vertex.result().iterations);
  gjk::Options options;
  options.direction_rule = gjk::DirectionRule::towards_origin;
  const Run edge({{0, -1}}, kSquare, options);
  CHECK_EQ(StopReason::zero_direction, edge.result().stop);
  CHECK_EQ(0.0, edge.result().distance);
}

TEST(no_farther, "no progress: another vertex, but no farther along d") {
  // The middle vertex of the long edge comes first, so the scan prefers it.
  const Points y = {{0, 0}, {-2, 0}, {2, 0}, {0, 3}};
  gjk::Options options;
  options.start.count = 2;
  options.start.pairs[0] = {0, 1};
  options.start.pairs[1] = {0, 2};
  const Run run({{0.5, -1}}, y, options);
  CHECK_EQ(StopReason::no_progress, run.result().stop);
  CHECK_EQ(1.0, run.result().distance);
  CHECK(run.held().left <= run.held().right);
}

TEST(not_nearer, "not nearer: P came no nearer") {
  gjk::State<double, 2> state;
  state.simplex.count = 1;
  state.previous = gjk::Phase::drop;
  state.phase = gjk::Phase::stop;
  state.p_sq = 4;
  state.evidence.best_sq = 4;
  gjk::Record<double, 2> record;
  gjk::run_stop_tests(state, {}, gjk::Prepared<double, 2>{}, record);
  CHECK_EQ(StopReason::not_nearer, state.stop);
}

TEST(on_diagonal,
     "not nearer: O on a segment inside Z is an overlap that no third vertex improves") {
  const Run run({{0.25, 0.25}}, kSquare);
  CHECK_EQ(StopReason::not_nearer, run.result().stop);
  CHECK_EQ(Verdict::overlapping, run.result().verdict);
  CHECK_EQ(0.0, run.result().distance);
}

TEST(tolerance, "within tolerance: the bounds are as close as was asked for") {
  Points circle;
  for (int i = 0; i < 1000; ++i) {
    const double angle = i * 0.006283185307179586;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  gjk::Options options;
  options.start.count = 1;
  const int to_the_end = Run({{2.1, 1.3}}, circle, options).result().iterations;
  options.tolerance = 0.01;
  const Run run({{2.1, 1.3}}, circle, options);
  CHECK_EQ(StopReason::within_tolerance, run.result().stop);
  CHECK(run.result().lower > 0.98 * run.result().upper);
  CHECK(run.result().iterations < to_the_end);
  CHECK(run.held().left <= run.held().right);
}

TEST(cap, "iteration cap: given up, said so, and the bounds still hold") {
  Points circle;
  for (int i = 0; i < 1000; ++i) {
    const double angle = i * 0.006283185307179586;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  for (int cap = 1; cap <= 4; ++cap) {
    const check::Context context("cap", cap);
    gjk::Options options;
    options.start.count = 1;
    options.iteration_cap = cap;
    const Run run({{0.0, 3.0}}, circle, options);
    CHECK_EQ(StopReason::iteration_cap, run.result().stop);
    CHECK_EQ(cap, run.result().iterations);
    CHECK(run.result().lower <= 2.0);
    CHECK(run.result().upper >= 2.0);
    CHECK(run.result().lower < run.result().upper);
    CHECK_EQ(gjk::Phase::stop, run.trace.steps.back().phase);
  }
}

TEST(cap_undecided, "a cap reached before the question was decided answers 'undecided'") {
  gjk::Options options;
  options.iteration_cap = 1;
  const Run run({{0.25, 0.25}}, kSquare, options);
  CHECK_EQ(StopReason::iteration_cap, run.result().stop);
  CHECK_EQ(Verdict::undecided, run.result().verdict);
  CHECK_EQ(0.0, run.result().lower);
  CHECK(run.result().upper > 0.0);
}

TEST(failed, "failed: the query was refused") {
  const Run run({}, kSquare);
  CHECK_EQ(StopReason::failed, run.result().stop);
  CHECK(run.trace.steps.empty());
  CHECK_EQ(StopReason::failed, run.trace.initial.stop);
}

TEST(listed, "tests after the one that holds are listed, not tried; disabled ones are not tried") {
  const Run run({{3, 0}}, kSquare);
  for (const gjk::Step<double, 2>& step : run.trace.steps) {
    if (step.phase != gjk::Phase::stop) continue;
    CHECK_EQ(std::size_t{7}, step.record.stop_tests.size());
    bool held = false;
    for (const gjk::StopTest<double>& test : step.record.stop_tests) {
      CHECK_EQ(test.enabled && !held, test.tried);
      CHECK(!test.holds || test.tried);
      held = held || test.holds;
    }
    CHECK_EQ(held, step.after.stop != StopReason::running);
  }
}

/// After a support phase that found `support` along d, from a simplex of two vertices.
gjk::State<double, 2> after_support(gjk::VertexPair support) {
  gjk::State<double, 2> state;
  state.simplex.count = 2;
  state.simplex.vertices[0] = {{-1, 2}, {0, 4}};
  state.simplex.vertices[1] = {{1, 2}, {3, 0}};
  state.d = Vec<double, 2>(0, -1);
  state.support.w = Vec<double, 2>(5, 1);
  state.support.pair = support;
  state.support_value = -1;
  state.previous = gjk::Phase::support;
  state.phase = gjk::Phase::stop;
  return state;
}
template <class S>
gjk::Record<S, 2> stop_tests(gjk::State<S, 2>& state, const gjk::Options& options = {},
                             const gjk::Prepared<S, 2>& prepared = {}) {
  gjk::Record<S, 2> record;
  gjk::run_stop_tests(state, options, prepared, record);
  return record;
}

TEST(repeats_any, "a support repeats when both of its vertices are those of any simplex vertex") {
  for (const gjk::VertexPair pair : {gjk::VertexPair{0, 4}, gjk::VertexPair{3, 0}}) {
    gjk::State<double, 2> state = after_support(pair);
    const auto record = stop_tests(state);
    CHECK_EQ(StopReason::repeated_support, state.stop);
    CHECK_EQ(pair.x == 0 ? 0.0 : 1.0, record.stop_tests[3].left);
  }
  for (const gjk::VertexPair pair : {gjk::VertexPair{0, 0}, gjk::VertexPair{3, 4}}) {
    gjk::State<double, 2> state = after_support(pair);
    const auto record = stop_tests(state);
    CHECK_EQ(StopReason::running, state.stop);
    CHECK_EQ(gjk::Phase::add, state.phase);
    CHECK_EQ(-1.0, record.stop_tests[3].left);
  }
}

TEST(values, "progress is compared with the vertex that lies farthest along d") {
  for (const int farther : {0, 1}) {
    gjk::State<double, 2> state = after_support({7, 7});
    state.simplex.vertices[farther].w[1] = 1.5;
    CHECK_EQ(-1.5, stop_tests(state).stop_tests[4].right);
    CHECK_EQ(StopReason::running, state.stop);
    state = after_support({7, 7});
    state.simplex.vertices[farther].w[1] = 1;  // as far as the support point
    stop_tests(state);
    CHECK_EQ(StopReason::no_progress, state.stop);
    CHECK_EQ(gjk::Phase::stop, state.phase);
  }
}

TEST(which, "what can be tested depends on the phase that led to the stop phase") {
  const auto enabled = [](gjk::Phase previous, int count) {
    gjk::State<double, 2> state = after_support({7, 7});
    state.previous = previous;
    state.simplex.count = count;
    std::string out;
    gjk::Options options;
    options.tolerance = 0.1;
    for (const auto& test : stop_tests(state, options).stop_tests) out += test.enabled ? '1' : '0';
    return out;
  };
  // Origin inside, not nearer, zero direction, repeated, no progress, tolerance, cap.
  CHECK_EQ(std::string("1011111"), enabled(gjk::Phase::support, 2));
  CHECK_EQ(std::string("1010000"), enabled(gjk::Phase::direction, 2));
  CHECK_EQ(std::string("1100000"), enabled(gjk::Phase::drop, 2));
  CHECK_EQ(std::string("1000000"), enabled(gjk::Phase::drop, 3));
  gjk::State<double, 2> state = after_support({7, 7});
  CHECK(!stop_tests(state).stop_tests[5].enabled);  // without a tolerance
}

TEST(tolerance_met, "a tolerance is met when it is met exactly") {
  gjk::Options options;
  options.tolerance = 0.5;
  for (const double plane_sq : {0.9999, 1.0, 1.0001}) {
    gjk::State<gjk::Expansion, 2> state;
    state.previous = gjk::Phase::support;
    state.simplex.count = 1;
    state.simplex.vertices[0].w = {gjk::Expansion(2.0), gjk::Expansion(0.0)};
    state.simplex.vertices[0].pair = {9, 9};
    state.d = {gjk::Expansion(-1.0), gjk::Expansion(0.0)};
    state.support_value = gjk::Expansion(-1.0);
    state.evidence.best_sq = gjk::Expansion(4.0);
    state.evidence.plane_distance_sq = gjk::Expansion(plane_sq);
    stop_tests(state, options);
    CHECK_EQ(plane_sq < 1 ? StopReason::running : StopReason::within_tolerance, state.stop);
  }
}

TEST(tolerance_rounding, "both errors count: that of the upper bound and that of the plane") {
  constexpr float kU = 0x1p-24f;
  gjk::Options options;
  options.tolerance = 0.5;
  gjk::State<float, 2> state;
  state.evidence.best_sq = 4;
  state.evidence.plane_distance_sq = 1;
  const auto wanted = [&](const gjk::Prepared<float, 2>& prepared) {
    return std::sqrt(
        gjk::wanted_plane_distance_sq<float, 2>(state.evidence, options.tolerance, prepared));
  };
  gjk::Prepared<float, 2> prepared;
  CHECK_NEAR(1.0f, wanted(prepared), 20 * kU);
  prepared.vertex_error = 0x1p-4f;  // half of it in the upper bound, all of it in the plane
  CHECK_NEAR(1.0f + 0x1.8p-4f, wanted(prepared), 20 * kU);
  prepared = {};
  prepared.moved = 0x1p-4f / (2 * kU);
  CHECK_NEAR(1.0f + 0x1p-4f, wanted(prepared), 20 * kU);
  prepared.scans_placed = true;  // scans have seen the vertices where they are placed
  CHECK_NEAR(1.0f, wanted(prepared), 20 * kU);
  prepared = {};
  prepared.reach = 0x1p20f;
  CHECK_NEAR(1.0f + 8 * kU * 0x1p20f, wanted(prepared), 20 * kU);
  prepared = {};
  state.evidence.plane_reach_sq = 0x1p36f;
  CHECK_NEAR(1.0f + 3 * kU * 0x1p18f, wanted(prepared), 20 * kU);
  state.evidence.plane_distance_sq = 0x1p36f;
  CHECK_NEAR(1.0f + 7 * kU * 0x1p18f, wanted(prepared), 20 * kU);
}

TEST(switched_off, "a stop rule switched off does not end the run; the next one does") {
  gjk::Options options;
  options.stop_on_repeated_support = false;
  CHECK_EQ(StopReason::no_progress, Run({{3, 0}}, kSquare, options).result().stop);
  options.stop_on_no_progress = false;
  options.iteration_cap = 7;
  const Run run({{3, 0}}, kSquare, options);
  CHECK_EQ(StopReason::iteration_cap, run.result().stop);
  CHECK_EQ(7, run.result().iterations);
  CHECK_EQ(2.0, run.result().distance);
}

TEST(adding, "add appends the support point and begins the next iteration") {
  gjk::State<double, 2> state;
  state.simplex.count = 1;
  state.support.w = Vec<double, 2>(4, 5);
  state.support.pair = {1, 2};
  gjk::add_support(state);
  CHECK_EQ(2, state.simplex.count);
  CHECK_EQ(2, state.iteration);
  CHECK((state.simplex.vertices[1].pair == gjk::VertexPair{1, 2}));
  CHECK_EQ(0.0, state.simplex.weights[1]);
  CHECK_EQ(gjk::Phase::closest, state.phase);
}

}  // namespace stop_test
