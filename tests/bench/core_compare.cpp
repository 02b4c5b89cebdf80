// The core's time beside Box2D's, one thread, on the same pairs: transform of Y, distance, witness
// points and, for the core, certificate. It reports; nothing fails when a target is missed.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "libraries.hpp"

namespace {

using namespace bench;

constexpr int kVertices[] = {3, 4, 8};
constexpr std::uint64_t kSeed = 20100309;

/// A library and what share of its time the core in double may take.
struct Rival {
  Library library;
  double mean = HUGE_VAL;           ///< Geometric mean over the grid.
  double worst = HUGE_VAL;          ///< In one cell.
  std::vector<double> shares = {};  ///< As measured, cell by cell.
};

/// The same work done otherwise by the core itself.
std::vector<Rival> own_variants() {
  return {{core_float_in_double()},
          {core_float()},
          {.library = core_uncertified(), .mean = 1.10},
          {.library = core_stepping(), .mean = 1.02}};
}

std::vector<Rival> peers() {
  std::vector<Rival> out;
#ifdef GJKSCOPE_BOX2D_2
  out.push_back({.library = box2d_2(), .mean = 0.80});
#else
  fmt::print("Box2D 2.4 was not found when this was built.\n");
#endif
#ifdef GJKSCOPE_BOX2D_3
  out.push_back({.library = box2d_3(), .mean = 0.75, .worst = 0.90});
#else
  fmt::print("Box2D 3 was not found when this was built.\n");
#endif
  return out;
}

void time_cell(int vertices, const Spacing& spacing, std::size_t count, std::size_t repetitions,
               std::vector<Rival>& rivals) {
  const std::vector<Pair> pairs = PairSource(kSeed).pairs(count, vertices, spacing);
  std::vector<Contestant> contestants = {core_double().prepare(pairs)};
  for (const Rival& rival : rivals) contestants.push_back(rival.library.prepare(pairs));
  const std::vector<Timing> timings = interleave(contestants, count, repetitions);

  fmt::print("| {} | {:<9} | {:6.1f} |", vertices, spacing.name, quartiles(timings[0].ns).median);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const Timing& timing = timings[i + 1];
    const Quartiles share = ratio(timings[0], timing);
    fmt::print(" {:7.1f}: {:.2f} ({:.2f}-{:.2f}) |", quartiles(timing.ns).median, share.median,
               share.low, share.high);
    rivals[i].shares.push_back(share.median);
  }
  fmt::print("\n");

  // Float libraries err by about 1e-7 a query; more means that one did other work.
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const double difference = (timings[i + 1].sum - timings[0].sum) / static_cast<double>(count);
    if (std::abs(difference) < 1e-6) continue;
    fmt::print("  {} did other work: its mean distance differs by {:.1e}\n", rivals[i].library.name,
               difference);
  }
}

void report(double measured, double wanted, const std::string& what) {
  if (std::isinf(wanted)) {
    fmt::print("      {} is {:.3f}\n", what, measured);
  } else {
    fmt::print("{}  {} is {:.3f}, wanted <= {:.2f}\n", measured <= wanted ? "pass" : "FAIL", what,
               measured, wanted);
  }
}

void time_grid(std::vector<Rival> against, std::size_t pairs, std::size_t repetitions) {
  if (against.empty()) return;
  fmt::print("\n| n | pairs     |     ns |");
  for (const Rival& rival : against) fmt::print(" {:<25} |", rival.library.name);
  fmt::print("\n");
  for (const int vertices : kVertices) {
    for (const Spacing& spacing : kSpacings) {
      time_cell(vertices, spacing, pairs, repetitions, against);
    }
  }
  fmt::print("\n");
  for (const Rival& rival : against) {
    double logarithms = 0.0;
    for (const double share : rival.shares) logarithms += std::log(share);
    report(std::exp(logarithms / static_cast<double>(rival.shares.size())), rival.mean,
           "geometric mean of gjkscope / " + rival.library.name);
    report(*std::max_element(rival.shares.begin(), rival.shares.end()), rival.worst,
           "largest gjkscope / " + rival.library.name);
  }
}

/// Convex polygons with many vertices against the same ones with two vertices swapped, in which the
/// core has to look at all of them.
void time_large(std::size_t repetitions) {
  constexpr std::size_t kPairs = 64;
  constexpr int kLarge = 1024;
  const std::vector<Pair> ordered = PairSource(kSeed).pairs(kPairs, kLarge, kSpacings[0]);
  std::vector<Pair> disordered = ordered;
  for (Pair& pair : disordered) {
    std::swap(pair.x[0], pair.x[1]);
    std::swap(pair.y[0], pair.y[1]);
  }
  const std::vector<Timing> timings = interleave(
      {core_double().prepare(ordered), core_double().prepare(disordered)}, kPairs, repetitions);
  const Quartiles share = ratio(timings[0], timings[1]);
  fmt::print("\n{} vertices: {:.0f} ns, by plain scan {:.0f} ns, ratio {:.3f} ({:.3f}-{:.3f})\n\n",
             kLarge, quartiles(timings[0].ns).median, quartiles(timings[1].ns).median, share.median,
             share.low, share.high);
  report(share.median, 0.25, "gjkscope / plain scan");
  report(std::abs(timings[0].sum - timings[1].sum), 0.0, "difference of the answers");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the core beside Box2D");
  std::size_t pairs = 2048;  // too many for the branch predictor to learn
  std::size_t repetitions = 101;
  app.add_option("--pairs", pairs, "pairs a cell")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", repetitions, "repetitions of a cell")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  fmt::print(
      "{} pairs a cell, {} interleaved repetitions, one thread. Median ns per query; after the\n"
      "colon the share of that time that the core in double takes, with its quartiles over the\n"
      "repetitions. A peer from a distribution is as that compiled it (Debian: -O2).\n",
      pairs, repetitions);
  time_grid(peers(), pairs, repetitions);
  time_grid(own_variants(), pairs, repetitions);
  time_large(repetitions);
  return 0;
}
