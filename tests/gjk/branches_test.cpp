// Every branch of a run is taken: each outcome of each region test, of each direction and of each
// stop test, and each way to an answer, is counted over pairs of all families, and none is missing.

#include <map>
#include <string>

#include "check.hpp"
#include "study/families.hpp"

namespace branches_test {

using families::Family;
using families::kFamilyCount;
using gjk::Phase;
using gjk::StopReason;
using gjk::Verdict;

constexpr std::uint64_t kSeed = 44;

using Counts = std::map<std::string, long>;

const char* const kReasons[] = {"running",          "repeated support", "origin inside",
                                "zero direction",   "not nearer",       "no progress",
                                "within tolerance", "iteration cap",    "failed"};
const char* const kVerdicts[] = {"separated", "touching", "overlapping", "undecided", "none"};

std::string face_name(gjk::Face face) {
  std::string name;
  for (int i = 0; i < 4; ++i) {
    if (gjk::contains(face, i)) name += static_cast<char>('A' + i);
  }
  return name;
}

gjk::Options random_options(families::Source& random, int x_count, int y_count) {
  gjk::Options options;
  if (random.with_chance(0.3)) options.direction_rule = gjk::DirectionRule::towards_origin;
  if (random.with_chance(0.5)) options.region_order = gjk::RegionOrder::edges_first;
  options.stop_on_repeated_support = random.with_chance(0.7);
  options.stop_on_no_progress = random.with_chance(0.7);
  if (random.with_chance(0.3)) options.tolerance = 0.05;
  if (random.with_chance(0.3)) options.iteration_cap = random.among(1, 10);
  options.start.count = random.among(1, 3);
  for (int i = 0; i < options.start.count; ++i) {
    options.start.pairs[i] = {random.among(0, x_count - 1), random.among(0, y_count - 1)};
  }
  return options;
}

template <class S>
void count_regions(const gjk::Options& options, const gjk::State<S, 2>& before,
                   const gjk::Step<S, 2>& step, Counts& counts) {
  const int size = before.simplex.count;
  const std::string order =
      options.region_order == gjk::RegionOrder::vertices_first ? "vertices first" : "edges first";
  const std::string of = " of " + std::to_string(size) + ", " + order;
  for (const gjk::RegionTest<S>& test : step.record.region_tests) {
    ++counts["region " + face_name(test.region) + of + (test.holds ? ": yes" : ": no")];
  }
  const gjk::RegionTest<S>& last = step.record.region_tests.back();
  if (size == 3 && last.region == before.simplex.all() && last.holds) {
    ++counts[step.after.region == last.region ? "triangle believed" : "triangle not believed"];
  }
  if (step.record.no_region_held) {
    ++counts["no region, nearest " +
             std::string(gjk::vertex_count(step.after.region) == 1 ? "vertex" : "edge")];
  }
  if (gjk::vertex_count(step.after.region) == 2) {
    ++counts[gjk::is_zero(step.after.p) ? "O on an edge" : "O beside an edge"];
  }
}

template <class S>
void count_direction(const gjk::Options& options, const gjk::State<S, 2>& before,
                     const gjk::Step<S, 2>& step, Counts& counts) {
  const gjk::DirectionNote<S, 2>& note = step.record.direction;
  const bool perpendicular = options.direction_rule == gjk::DirectionRule::perpendicular;
  if (note.from_normal) {
    ++counts[note.sign_is_arbitrary ? "normal of either sign"
             : note.flipped         ? "normal flipped"
                                    : "normal as it is"];
  } else {
    ++counts[!perpendicular              ? "O - P by the rule"
             : before.simplex.count == 1 ? "O - P at a vertex"
                                         : "O - P where an edge has no length"];
  }
  ++counts[step.after.phase == Phase::stop ? "no direction" : "a direction"];
}

template <class S>
void count_steps(const gjk::Options& options, const gjk::Trace<S, 2>& trace, Counts& counts) {
  const gjk::State<S, 2>* before = &trace.initial;
  for (const gjk::Step<S, 2>& step : trace.steps) {
    const gjk::State<S, 2>& after = step.after;
    switch (step.phase) {
      case Phase::closest:
        count_regions(options, *before, step, counts);
        break;
      case Phase::drop:
        ++counts["dropped " + std::to_string(step.record.dropped.size())];
        ++counts[after.evidence.best_sq == after.p_sq && after.phase == Phase::direction
                     ? "P is the best"
                 : after.phase == Phase::direction ? "P is not the best"
                 : after.simplex.count == 3        ? "P inside"
                                                   : "P no nearer"];
        break;
      case Phase::direction:
        count_direction(options, *before, step, counts);
        break;
      case Phase::support:
        ++counts[!(after.support_value < 0) ? "no plane between"
                 : after.evidence.plane_distance_sq != before->evidence.plane_distance_sq
                     ? "a farther plane"
                     : "a nearer plane"];
        if (after.evidence.touches_plane && !before->evidence.touches_plane)
          ++counts["a plane through O"];
        break;
      case Phase::stop:
        for (const gjk::StopTest<S>& test : step.record.stop_tests) {
          ++counts[std::string(kReasons[static_cast<int>(test.reason)]) + (test.holds   ? ": yes"
                                                                           : test.tried ? ": no"
                                                                           : test.enabled
                                                                               ? ": late"
                                                                               : ": off")];
        }
        break;
      case Phase::add:
        ++counts["added to " + std::to_string(before->simplex.count)];
        break;
    }
    before = &after;
  }
}

template <class S>
void count_answer(const gjk::Result<S, 2>& result, Counts& counts) {
  const std::string verdict = kVerdicts[static_cast<int>(result.verdict)];
  ++counts[(result.settled ? "settled: " : "by the run: ") + verdict];
  ++counts["answer of " + std::to_string(result.simplex.count) + " vertices"];
}

template <class S>
void count(int pairs, Counts& counts) {
  families::Source random(kSeed);
  for (int i = 0; i < pairs; ++i) {
    const auto pair = random.pair<S>(static_cast<Family>(i % kFamilyCount));
    const gjk::Options options =
        random_options(random, static_cast<int>(pair.x.size()), static_cast<int>(pair.y.size()));
    const auto trace = gjk::trace<S>(pair.query(), options);
    if (trace.result.error != gjk::Error::none) continue;
    count_steps(options, trace, counts);
    count_answer(trace.result, counts);
  }
}

/// Region tests that follow from those before them, and cannot fail, have no "no".
const char* const kAll[] = {
    "O - P at a vertex",
    "O - P by the rule",
    "O beside an edge",
    "O on an edge",
    "P inside",
    "P is not the best",
    "P is the best",
    "P no nearer",
    "a direction",
    "a farther plane",
    "a nearer plane",
    "a plane through O",
    "added to 1",
    "added to 2",
    "answer of 1 vertices",
    "answer of 2 vertices",
    "answer of 3 vertices",
    "by the run: overlapping",
    "by the run: separated",
    "by the run: undecided",
    "dropped 0",
    "dropped 1",
    "dropped 2",
    "iteration cap: late",
    "iteration cap: no",
    "iteration cap: off",
    "iteration cap: yes",
    "no direction",
    "no plane between",
    "no progress: late",
    "no progress: no",
    "no progress: off",
    "no progress: yes",
    "not nearer: off",
    "not nearer: yes",
    "no region, nearest edge",
    "normal as it is",
    "normal flipped",
    "normal of either sign",
    "origin inside: no",
    "origin inside: yes",
    "region A of 1, edges first: yes",
    "region A of 1, vertices first: yes",
    "region A of 2, edges first: yes",
    "region A of 2, vertices first: no",
    "region A of 2, vertices first: yes",
    "region A of 3, edges first: no",
    "region A of 3, edges first: yes",
    "region A of 3, vertices first: no",
    "region A of 3, vertices first: yes",
    "region AB of 2, edges first: no",
    "region AB of 2, edges first: yes",
    "region AB of 2, vertices first: yes",
    "region AB of 3, edges first: no",
    "region AB of 3, edges first: yes",
    "region AB of 3, vertices first: no",
    "region AB of 3, vertices first: yes",
    "region ABC of 3, edges first: yes",
    "region ABC of 3, vertices first: yes",
    "region AC of 3, edges first: no",
    "region AC of 3, edges first: yes",
    "region AC of 3, vertices first: no",
    "region AC of 3, vertices first: yes",
    "region B of 2, edges first: no",
    "region B of 2, edges first: yes",
    "region B of 2, vertices first: no",
    "region B of 2, vertices first: yes",
    "region B of 3, edges first: no",
    "region B of 3, edges first: yes",
    "region B of 3, vertices first: no",
    "region B of 3, vertices first: yes",
    "region BC of 3, edges first: no",
    "region BC of 3, edges first: yes",
    "region BC of 3, vertices first: no",
    "region BC of 3, vertices first: yes",
    "region C of 3, edges first: no",
    "region C of 3, edges first: yes",
    "region C of 3, vertices first: no",
    "region C of 3, vertices first: yes",
    "repeated support: no",
    "repeated support: off",
    "repeated support: yes",
    "settled: overlapping",
    "settled: separated",
    "settled: touching",
    "triangle believed",
    "triangle not believed",
    "within tolerance: late",
    "within tolerance: no",
    "within tolerance: off",
    "within tolerance: yes",
    "zero direction: no",
    "zero direction: off",
    "zero direction: yes",
};

TEST(all_taken, "every branch of regions, directions, planes, stop tests and answers is taken") {
  Counts counts;
  count<float>(22000, counts);
  count<double>(22000, counts);
  for (const char* name : kAll) {
    const check::Context context(name);
    std::printf("  %-36s %8ld\n", name, counts[name]);
    CHECK(counts[name] > 0);
  }
  CHECK_EQ(std::size(kAll), counts.size());
}

}  // namespace branches_test
