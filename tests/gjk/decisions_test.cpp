// "distance", "trace" and single steps take bit-identical decisions and give bit-identical results:
// recording a run cannot change it. Arguments: float|double and the number of pairs.

#include <string>

#include "check.hpp"
#include "same_bits.hpp"
#include "study/families.hpp"

namespace decisions_test {

using check::same_bits;
using families::Family;
using families::kFamilyCount;

constexpr std::uint64_t kSeed = 20100311;

template <class S>
bool same_bits(const gjk::State<S, 2>& a, const gjk::State<S, 2>& b) {
  return a.phase == b.phase && a.previous == b.previous && a.iteration == b.iteration &&
         a.region == b.region && a.evidence.touches_plane == b.evidence.touches_plane &&
         a.stop == b.stop && a.error == b.error && same_bits(a.simplex, b.simplex) &&
         same_bits(a.p, b.p) && same_bits(a.p_sq, b.p_sq) && same_bits(a.d, b.d) &&
         same_bits(a.support, b.support) && same_bits(a.support_value, b.support_value) &&
         same_bits(a.evidence.best, b.evidence.best) &&
         same_bits(a.evidence.best_sq, b.evidence.best_sq) &&
         same_bits(a.evidence.plane_distance_sq, b.evidence.plane_distance_sq) &&
         same_bits(a.evidence.plane_reach_sq, b.evidence.plane_reach_sq);
}
/// Half of the pairs run with the default options, the others with mixed ones.
gjk::Options random_options(families::Source& random, int x_count, int y_count) {
  gjk::Options options;
  if (random.with_chance(0.5)) return options;
  if (random.with_chance(0.5)) options.direction_rule = gjk::DirectionRule::towards_origin;
  if (random.with_chance(0.5)) options.region_order = gjk::RegionOrder::edges_first;
  options.stop_on_repeated_support = random.with_chance(0.7);
  options.stop_on_no_progress = random.with_chance(0.7);
  if (random.with_chance(0.3)) options.tolerance = 0.05;
  options.iteration_cap = random.among(1, 10);
  options.start.count = random.among(0, 3);
  for (int i = 0; i < options.start.count; ++i) {
    options.start.pairs[i] = {random.among(0, x_count - 1), random.among(0, y_count - 1)};
  }
  return options;
}

/// Runs the query in all ways; returns what differs, or nullptr.
template <class S>
const char* difference(const gjk::Query<S, 2>& query, const gjk::Options& options,
                       gjk::Result<S, 2>& answer) {
  answer = gjk::distance<S>(query, options);
  const gjk::Trace<S, 2> trace = gjk::trace<S>(query, options);
  if (!same_bits(answer, trace.result)) return "result of distance() and of trace()";

  const gjk::Prepared<S, 2> prepared = gjk::prepare<S>(query, options);
  gjk::State<S, 2> state = gjk::start(query, options, prepared);
  if (!same_bits(state, trace.initial)) return "initial state";
  gjk::NoRecord none;
  std::size_t i = 0;
  for (; state.stop == gjk::StopReason::running; ++i) {
    if (i == trace.steps.size()) return "number of steps";
    if (state.phase != trace.steps[i].phase) return "phase";
    if (state.iteration != trace.steps[i].iteration) return "iteration";
    gjk::step(state, query, options, prepared, none);
    if (!same_bits(state, trace.steps[i].after)) return "state after a step";
  }
  if (i != trace.steps.size()) return "number of steps";
  if (!same_bits(gjk::result(state, query, options, prepared), answer))
    return "result of the steps";
  return nullptr;
}

struct Shares {
  std::array<long, 9> stop = {};
  std::array<long, 5> verdict = {};
  std::array<long, 4> simplex_count = {};
  long iterations = 0;
  long pairs = 0;
};

template <class S>
Shares run(long pairs) {
  families::Source random(kSeed);
  Shares shares;
  shares.pairs = pairs;
  for (long i = 0; i < pairs; ++i) {
    const auto family = static_cast<Family>(i % kFamilyCount);
    const families::Pair<S> pair = random.pair<S>(family);
    const gjk::Options options =
        random_options(random, static_cast<int>(pair.x.size()), static_cast<int>(pair.y.size()));
    gjk::Result<S, 2> answer;
    if (const char* what = difference(pair.query(), options, answer)) {
      const check::Context context("seed", kSeed, "pair", i, "family",
                                   families::kFamilyNames[i % kFamilyCount]);
      check::fail(__FILE__, __LINE__, std::string("not bit-identical: ") + what);
    }
    ++shares.stop[static_cast<int>(answer.stop)];
    ++shares.verdict[static_cast<int>(answer.verdict)];
    ++shares.simplex_count[answer.simplex.count];
    shares.iterations += answer.iterations;
  }
  return shares;
}

/// The pairs cover what can happen: every outcome has a share worth the name.
void check_representative(const Shares& shares) {
  const auto share = [&](long count) {
    return static_cast<double>(count) / static_cast<double>(shares.pairs);
  };
  std::printf("  %ld pairs, %.2f iterations on average\n", shares.pairs,
              static_cast<double>(shares.iterations) / static_cast<double>(shares.pairs));
  const auto check_share = [&](const char* name, long count, double at_least) {
    std::printf("  %-18s %6.2f %%\n", name, 100 * share(count));
    const check::Context context(name);
    CHECK(share(count) >= at_least);
  };
  using gjk::StopReason;
  using gjk::Verdict;
  const auto stop = [&](StopReason reason) { return shares.stop[static_cast<int>(reason)]; };
  const auto verdict = [&](Verdict kind) { return shares.verdict[static_cast<int>(kind)]; };
  check_share("repeated support", stop(StopReason::repeated_support), 0.20);
  check_share("origin inside", stop(StopReason::origin_inside), 0.10);
  check_share("zero direction", stop(StopReason::zero_direction), 0.005);
  check_share("not nearer", stop(StopReason::not_nearer), 0.005);
  check_share("no progress", stop(StopReason::no_progress), 0.005);
  check_share("within tolerance", stop(StopReason::within_tolerance), 0.01);
  check_share("iteration cap", stop(StopReason::iteration_cap), 0.05);
  CHECK_EQ(0L, stop(StopReason::running));
  CHECK_EQ(0L, stop(StopReason::failed));
  check_share("separated", verdict(Verdict::separated), 0.30);
  check_share("touching", verdict(Verdict::touching), 0.002);
  check_share("overlapping", verdict(Verdict::overlapping), 0.10);
  check_share("undecided", verdict(Verdict::undecided), 0.02);
  check_share("answer: a vertex", shares.simplex_count[1], 0.10);
  check_share("answer: an edge", shares.simplex_count[2], 0.10);
  check_share("answer: a triangle", shares.simplex_count[3], 0.10);
}

TEST(recording_changes_nothing,
     "distance, trace and steps agree to the last bit on every random pair") {
  const std::vector<std::string>& arguments = check::session().arguments;
  const bool in_float = arguments.empty() || arguments[0] == "float";
  const long pairs = arguments.size() > 1 ? std::stol(arguments[1]) : 500000;
  check_representative(in_float ? run<float>(pairs) : run<double>(pairs));
}

}  // namespace decisions_test
