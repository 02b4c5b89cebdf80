// A trace is complete for every outcome; options have the effect that they name.

#include <algorithm>

#include "check.hpp"
#include "gjk/gjk.hpp"
#include "study/families.hpp"

namespace trace_test {

using gjk::Phase;
using gjk::StopReason;
using gjk::Vec;
using Points = std::vector<Vec<double, 2>>;

const Points kSquare = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
/// The slides' pentagon: a run from E takes C, then D, and drops E.
const Points kPentagon = {{6, 2}, {5, 6}, {1, 5}, {0, 1}, {3, -1}};

template <class S, int D>
void check_complete(const gjk::Trace<S, D>& trace, int x_count, int y_count) {
  CHECK(!trace.steps.empty());
  CHECK_EQ(Phase::closest, trace.steps.front().phase);
  CHECK_EQ(Phase::stop, trace.steps.back().phase);
  CHECK(trace.steps.back().after.stop != StopReason::running);
  CHECK_EQ(trace.result.stop, trace.steps.back().after.stop);
  CHECK_EQ(trace.result.iterations, trace.steps.back().iteration);
  int iteration = 1;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const gjk::Step<S, D>& step = trace.steps[i];
    CHECK_EQ(step.phase, step.after.previous);
    CHECK_EQ(iteration, step.iteration);
    if (step.phase == Phase::add) ++iteration;
    if (i + 1 < trace.steps.size()) {
      CHECK_EQ(step.after.phase, trace.steps[i + 1].phase);
      CHECK_EQ(StopReason::running, step.after.stop);
    }
    const gjk::Record<S, D>& record = step.record;
    CHECK_EQ(step.phase == Phase::closest, !record.region_tests.empty());
    CHECK_EQ(step.phase == Phase::stop, !record.stop_tests.empty());
    CHECK_EQ(step.phase == Phase::support ? x_count : 0, static_cast<int>(record.scan_x.size()));
    CHECK_EQ(step.phase == Phase::support ? y_count : 0, static_cast<int>(record.scan_y.size()));
    CHECK(step.phase == Phase::drop || record.dropped.empty());
  }
}

gjk::Trace<double, 2> traced(const Points& x, const Points& y, const gjk::Options& options = {}) {
  gjk::Trace<double, 2> trace = gjk::trace(gjk::Query<double, 2>{{x}, {y}}, options);
  check_complete(trace, static_cast<int>(x.size()), static_cast<int>(y.size()));
  return trace;
}

TEST(complete, "a trace ends with a stop phase: separated, touching, overlapping, cap reached") {
  CHECK_EQ(gjk::Verdict::separated, traced({{3, 0}}, kSquare).result.verdict);
  CHECK_EQ(gjk::Verdict::touching, traced({{0, -1}}, kSquare).result.verdict);
  CHECK_EQ(StopReason::zero_direction, traced({{-1, -1}}, kSquare).result.stop);
  CHECK_EQ(gjk::Verdict::overlapping, traced(kSquare, kSquare).result.verdict);
  gjk::Options options;
  options.iteration_cap = 1;
  CHECK_EQ(StopReason::iteration_cap, traced({{0.5, 0.5}}, kSquare, options).result.stop);
}

TEST(random_complete, "traces of random pairs are complete, whatever the outcome") {
  constexpr std::uint64_t kSeed = 7;
  families::Source random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const int family = i % families::kFamilyCount;
    const check::Context context("seed", kSeed, "pair", i, families::kFamilyNames[family]);
    const auto pair = random.pair<float>(static_cast<families::Family>(family));
    gjk::Options options;
    options.iteration_cap = random.among(1, 12);
    options.stop_on_no_progress = random.with_chance(0.5);
    check_complete(gjk::trace(pair.query(), options), static_cast<int>(pair.x.size()),
                   static_cast<int>(pair.y.size()));
  }
}

TEST(given_up, "a run may be given up before any of its phases") {
  const gjk::Query<double, 2> query{{kSquare}, {kPentagon}};
  const std::size_t phases = gjk::trace(query).steps.size();
  CHECK(phases > 6);
  for (std::size_t limit = 0; limit <= phases; ++limit) {
    std::size_t begun = 0;
    bool given_up = false;
    try {
      const auto trace = gjk::trace(query, {}, [&] {
        if (begun == limit) throw limit;
        ++begun;
      });
    } catch (std::size_t) {
      given_up = true;
    }
    CHECK_EQ(limit, begun);
    CHECK_EQ(limit < phases, given_up);
  }
}

TEST(phases, "one iteration is closest, drop, direction, support, stop, add") {
  const auto trace = traced({{9, 0}}, kPentagon);
  const Phase order[] = {Phase::closest, Phase::drop, Phase::direction,
                         Phase::support, Phase::stop, Phase::add};
  for (std::size_t i = 0; i < trace.steps.size(); ++i) CHECK_EQ(order[i % 6], trace.steps[i].phase);
}

TEST(pentagon, "the slides' pentagon: from E to C, from CE to D, E dropped, D repeats") {
  gjk::Options options;
  options.start.count = 1;
  options.start.pairs[0] = {0, 4};
  const auto trace = traced({{-3, 4}}, kPentagon, options);
  std::vector<int> supports;
  std::vector<int> dropped;
  for (const gjk::Step<double, 2>& step : trace.steps) {
    if (step.phase == Phase::support) supports.push_back(step.after.support.pair.y);
    for (const auto& vertex : step.record.dropped) dropped.push_back(vertex.pair.y);
  }
  CHECK(supports == std::vector<int>({2, 3, 3}) || supports == std::vector<int>({2, 3, 2}));
  CHECK(dropped == std::vector<int>({4}));
  CHECK_EQ(StopReason::repeated_support, trace.result.stop);
  CHECK_EQ(3, trace.result.iterations);
}

TEST(start_simplex, "a run may start with a segment or a triangle") {
  gjk::Options options;
  options.start.count = 3;
  options.start.pairs = {{{0, 0}, {0, 1}, {0, 2}}};
  const auto trace = traced({{-3, 4}}, kPentagon, options);
  CHECK_EQ(3, trace.initial.simplex.count);
  CHECK_EQ(traced({{-3, 4}}, kPentagon).result.distance, trace.result.distance);
}

TEST(center, "center to center starts at the support point along the line of centers") {
  gjk::Options options;
  options.start.count = 0;
  const Points right = {{4, -1}, {6, -1}, {6, 1}, {4, 1}};
  const auto trace = traced(kSquare, right, options);
  CHECK_EQ(1, trace.initial.simplex.count);
  CHECK_EQ(3.0, trace.initial.simplex.vertices[0].w.cwiseAbs().maxCoeff());
  CHECK_EQ(3.0, trace.result.distance);
  CHECK(gjk::is_zero(trace.initial.p));  // nothing of the search for the start is kept
  CHECK_EQ(0.0, trace.initial.evidence.plane_distance_sq);
  CHECK(traced(kSquare, kSquare, options).result.verdict == gjk::Verdict::overlapping);
}

TEST(direction_rule, "the direction rule decides how d is built") {
  gjk::Options options;
  options.start.count = 2;
  options.start.pairs[1] = {0, 1};
  const auto normal_of = [&](gjk::DirectionRule rule) {
    options.direction_rule = rule;
    const auto trace = traced({{0.3, -3}}, kSquare, options);
    const auto step =
        std::find_if(trace.steps.begin(), trace.steps.end(),
                     [](const auto& candidate) { return candidate.phase == Phase::direction; });
    CHECK(step != trace.steps.end());
    return step->record.direction.from_normal;
  };
  CHECK(normal_of(gjk::DirectionRule::perpendicular));
  CHECK(!normal_of(gjk::DirectionRule::towards_origin));
}

TEST(warm, "warm started with the answer's pairs a run takes one iteration") {
  constexpr std::uint64_t kSeed = 8;
  families::Source random(kSeed);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    const auto pair = random.pair<double>(families::Family::random);
    const auto cold = gjk::distance(pair.query());
    gjk::Options options;
    options.start.count = cold.simplex.count;
    for (int k = 0; k < cold.simplex.count; ++k)
      options.start.pairs[k] = cold.simplex.vertices[k].pair;
    const auto warm = gjk::distance(pair.query(), options);
    CHECK_EQ(1, warm.iterations);
    CHECK_EQ(cold.verdict, warm.verdict);
    CHECK_NEAR(cold.distance, warm.distance, 1e-15);
    if (cold.iterations > 1) ++compared;
  }
  CHECK(compared > 10000);
}

TEST(simplices, "the answer's simplex, weights and witness points belong together") {
  const auto result = traced({{-3, 4}}, kPentagon).result;
  Vec<double, 2> y = Vec<double, 2>::Zero();
  double sum = 0;
  for (int i = 0; i < result.simplex.count; ++i) {
    CHECK(result.simplex.weights[i] > 0);
    sum += result.simplex.weights[i];
    y += result.simplex.weights[i] * kPentagon[result.simplex.vertices[i].pair.y];
  }
  CHECK_NEAR(1.0, sum, 1e-15);
  CHECK_NEAR(0.0, (y - result.y).norm(), 1e-15);
  CHECK_NEAR(result.distance, (result.y - result.x).norm(), 1e-15);
}

}  // namespace trace_test
