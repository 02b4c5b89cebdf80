// The core's time beside Box2D's, one thread, on the same pairs: transform of Y, distance, witness
// points and, for the core, certificate. It reports; nothing fails when a target is missed.
// `--write` puts the report into a document.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "document.hpp"
#include "libraries.hpp"
#include "study/accuracy.hpp"

namespace {

using namespace bench;

constexpr int kVertices[] = {3, 4, 8};
constexpr std::uint64_t kSeed = 20100309;

/// What is printed, kept for a document.
class Report {
 public:
  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    const std::string text = fmt::format(format, std::forward<Values>(values)...);
    fmt::print("{}", text);
    std::fflush(stdout);
    text_ += text;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

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
          {.library = core_bounds(), .mean = 1.10},
          {core_no_proof()},
          {core_stepping()}};
}

std::vector<Rival> peers([[maybe_unused]] Report& report) {
  std::vector<Rival> out;
#ifdef GJKSCOPE_BOX2D_2
  out.push_back({.library = box2d_2(), .mean = 1.00});
#else
  report.print("Box2D 2.4 was not found when this was built.\n\n");
#endif
#ifdef GJKSCOPE_BOX2D_3
  out.push_back({.library = box2d_3(), .mean = 1.00});
#else
  report.print("Box2D 3 was not found when this was built.\n\n");
#endif
  return out;
}

void time_cell(Report& report, int vertices, const Spacing& spacing, std::size_t count,
               std::size_t repetitions, std::vector<Rival>& rivals) {
  const std::vector<Pair> pairs = PairSource(kSeed).pairs(count, vertices, spacing);
  std::vector<Contestant> contestants = {core_double().prepare(pairs)};
  for (const Rival& rival : rivals) contestants.push_back(rival.library.prepare(pairs));
  const std::vector<Timing> timings = interleave(contestants, count, repetitions);

  // Float libraries err by about 1e-7 a query; more means that one did other work.
  const auto did_other_work = [&](std::size_t i) {
    return !(std::abs(timings[i + 1].sum - timings[0].sum) < 1e-6 * static_cast<double>(count));
  };
  report.print("| {} | {} | {:.1f} |", vertices, spacing.name, quartiles(timings[0].ns).median);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const Timing& timing = timings[i + 1];
    const Quartiles share = ratio(timings[0], timing);
    report.print(" {:.1f}: {:.2f} ({:.2f}-{:.2f}){} |", quartiles(timing.ns).median, share.median,
                 share.low, share.high, did_other_work(i) ? " other work" : "");
    rivals[i].shares.push_back(share.median);
  }
  report.print("\n");
}

void judge(Report& report, double measured, double wanted, const std::string& what) {
  if (std::isinf(wanted)) {
    report.print("- {}: {:.3f}\n", what, measured);
  } else {
    report.print("- {}: {:.3f}, wanted at most {:.2f}: {}\n", what, measured, wanted,
                 measured <= wanted ? "ok" : "FAIL");
  }
}

void time_grid(Report& report, std::vector<Rival> against, std::size_t pairs,
               std::size_t repetitions) {
  if (against.empty()) return;
  report.print("| vertices | pairs | gjkscope |");
  for (const Rival& rival : against) report.print(" {} |", rival.library.name);
  report.print("\n| --- | --- | --- |");
  for (std::size_t i = 0; i < against.size(); ++i) report.print(" --- |");
  report.print("\n");
  for (const int vertices : kVertices) {
    for (const Spacing& spacing : kSpacings) {
      time_cell(report, vertices, spacing, pairs, repetitions, against);
    }
  }
  report.print("\n");
  for (const Rival& rival : against) {
    double logarithms = 0.0;
    for (const double share : rival.shares) logarithms += std::log(share);
    judge(report, std::exp(logarithms / static_cast<double>(rival.shares.size())), rival.mean,
          "geometric mean of gjkscope / " + rival.library.name);
    judge(report, *std::max_element(rival.shares.begin(), rival.shares.end()), rival.worst,
          "largest gjkscope / " + rival.library.name);
  }
  report.print("\n");
}

/// Convex polygons with many vertices against the same ones with two vertices swapped, in which the
/// core has to look at all of them.
void time_large(Report& report, std::size_t repetitions) {
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
  report.print("{} vertices: {:.0f} ns, by plain scan {:.0f} ns, ratio {:.3f} ({:.3f}-{:.3f}).\n\n",
               kLarge, quartiles(timings[0].ns).median, quartiles(timings[1].ns).median,
               share.median, share.low, share.high);
  judge(report, share.median, 0.25, "gjkscope / plain scan");
  judge(report, std::abs(timings[0].sum - timings[1].sum), 0.0, "difference of the answers");
}

void run(std::size_t pairs, std::size_t repetitions, const std::string& document) {
  Report report;
  const gjkscope::study::Machine machine = gjkscope::study::this_machine();
  report.print(
      "\nMade by `core-compare --pairs {} --repetitions {} --write docs/numerics.md` on {}, one "
      "thread, {},\n`{}`. Median ns per query; after the colon the share of that time that "
      "the core in double takes, with\nits quartiles over interleaved repetitions. A peer from a "
      "distribution is as that compiled it (Debian: -O2).\n\n",
      pairs, repetitions, machine.processor, machine.compiler, machine.flags);
  time_grid(report, peers(report), pairs, repetitions);
  time_grid(report, own_variants(), pairs, repetitions);
  time_large(report, repetitions);
  report.print("\n");
  if (!document.empty()) write_section(document, "core-compare", report.text());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the core beside Box2D");
  std::size_t pairs = 2048;  // more than a branch predictor learns by heart
  std::size_t repetitions = 101;
  std::string document;
  app.add_option("--pairs", pairs, "pairs a cell")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", repetitions, "repetitions of a cell")->check(CLI::PositiveNumber);
  app.add_option("--write", document, "document whose marked section gets the report");
  CLI11_PARSE(app, argc, argv);
  try {
    run(pairs, repetitions, document);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "core-compare: {}\n", problem.what());
    return 1;
  }
  return 0;
}
