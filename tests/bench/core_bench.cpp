// The core's time by task: queries by family and scalar, traces, vertex counts, and what is made of
// a finished run.

#include <benchmark/benchmark.h>

#include <string>

#include "depth/depth.hpp"
#include "grid_pairs.hpp"

namespace {

using namespace bench;
using families::Family;

constexpr std::uint64_t kSeed = 20100309;
constexpr std::size_t kPairs = 1024;  ///< Pairs of each family.

template <class S>
std::vector<families::Pair<S>> pairs_of(Family family) {
  families::Source source(kSeed);
  std::vector<families::Pair<S>> pairs(kPairs);
  for (families::Pair<S>& pair : pairs) {
    pair = families::converted<S>(source.pair<double>(family));
  }
  return pairs;
}

/// One iteration is one query.
template <class S, class Run>
void cycle(benchmark::State& state, const std::vector<families::Pair<S>>& pairs, Run run) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(run(pairs[next].query()));
    next = (next + 1) % pairs.size();
  }
}

template <class S>
void distance(benchmark::State& state, Family family) {
  cycle(state, pairs_of<S>(family), [](const auto& query) { return gjk::distance(query); });
}

template <class S>
void trace(benchmark::State& state, Family family) {
  cycle(state, pairs_of<S>(family), [](const auto& query) { return gjk::trace(query); });
}

template <class S>
void penetration(benchmark::State& state, Family family) {
  cycle(state, pairs_of<S>(family), [](const auto& query) { return depth::penetration(query); });
}

std::string name_of(Family family) {
  return std::string(families::kFamilyNames[static_cast<std::size_t>(family)]);
}

void add_families() {
  for (int i = 0; i < families::kFamilyCount; ++i) {
    const auto family = static_cast<Family>(i);
    const std::string name = name_of(family);
    benchmark::RegisterBenchmark(("distance<double>/" + name).c_str(), distance<double>, family);
    benchmark::RegisterBenchmark(("distance<float>/" + name).c_str(), distance<float>, family);
  }
  for (const Family family : {Family::random, Family::grid, Family::posed}) {
    const std::string name = name_of(family);
    benchmark::RegisterBenchmark(("distance<half>/" + name).c_str(), distance<Eigen::half>, family);
    benchmark::RegisterBenchmark(("distance<long double>/" + name).c_str(), distance<long double>,
                                 family);
    benchmark::RegisterBenchmark(("trace<double>/" + name).c_str(), trace<double>, family);
  }
  for (const Family family : {Family::identical, Family::inside, Family::shallow}) {
    benchmark::RegisterBenchmark(("penetration<double>/" + name_of(family)).c_str(),
                                 penetration<double>, family);
  }
}

/// Convex polygons, their vertices in order or not: then the core has to look at all of them.
void by_vertices(benchmark::State& state, bool in_order) {
  std::vector<Pair<2>> pairs =
      PairSource<2>(kSeed).pairs(64, static_cast<int>(state.range(0)), kSpacings[0]);
  for (Pair<2>& pair : pairs) {
    if (in_order) continue;
    std::swap(pair.x[0], pair.x[1]);
    std::swap(pair.y[0], pair.y[1]);
  }
  cycle(state, pairs, [](const auto& query) { return gjk::distance(query); });
}
BENCHMARK_CAPTURE(by_vertices, ring, true)->RangeMultiplier(4)->Range(4, 1024);
BENCHMARK_CAPTURE(by_vertices, disordered, false)->RangeMultiplier(4)->Range(4, 1024);

/// Results of a run that has ended: distance, witness points, bounds.
void result(benchmark::State& state, bool certify) {
  struct Ended {
    families::Pair<double> pair;
    gjk::Prepared<double, 2> prepared;
    gjk::State<double, 2> end;
  };
  gjk::Options options;
  options.proof = certify ? gjk::Proof::exact : gjk::Proof::bounds;
  std::vector<Ended> runs;
  for (const families::Pair<double>& pair : pairs_of<double>(Family::random)) {
    const auto trace = gjk::trace(pair.query(), options);
    runs.push_back({pair, trace.prepared, trace.steps.back().after});
  }
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Ended& run = runs[next];
    benchmark::DoNotOptimize(gjk::result(run.end, run.pair.query(), options, run.prepared));
    next = (next + 1) % runs.size();
  }
}
BENCHMARK_CAPTURE(result, certified, true);
BENCHMARK_CAPTURE(result, not_certified, false);

}  // namespace

int main(int argc, char** argv) {
  add_families();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
