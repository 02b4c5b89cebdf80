// The core's time beside that of other libraries, one thread, on the same pairs: transform of Y,
// distance, witness points and, for the core, certificate. It reports; nothing fails when a target
// is missed. `--write` puts the report into a document.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>

#include "document.hpp"
#include "libraries.hpp"
#include "study/accuracy.hpp"

namespace {

using namespace bench;

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

/// A library and what share of its time the core may take.
template <int D>
struct Rival {
  Library<D> library;
  double mean = HUGE_VAL;           ///< Geometric mean over the grid.
  std::vector<double> shares = {};  ///< As measured, cell by cell.
};

/// The same work done otherwise by the core itself.
template <int D>
std::vector<Rival<D>> own_variants() {
  return {{core_float_in_double<D>()},
          {core_float<D>()},
          {.library = core_bounds<D>(), .mean = 1.10},
          {core_no_proof<D>()},
          {core_stepping<D>()}};
}

template <int D>
std::vector<Rival<D>> native_peers() {
  std::vector<Rival<D>> out;
  for (const Library<D>& library : peers<D>(Peers::native)) {
    out.push_back({.library = library, .mean = library.measures ? 1.00 : HUGE_VAL});
  }
  return out;
}

struct Cell {
  int vertices;
  Poses poses;
  Spacing spacing;
};

/// What is timed. Polygons are always posed, as bodies are.
template <int D>
std::vector<Cell> grid() {
  std::vector<Cell> out;
  for (const int vertices : D == 2 ? std::array{3, 4, 8} : std::array{4, 8, 32}) {
    for (const Poses poses : {Poses::none, Poses::set}) {
      if (D == 2 && poses == Poses::none) continue;
      for (const Spacing& spacing : kSpacings) out.push_back({vertices, poses, spacing});
    }
  }
  return out;
}

struct Counts {
  std::size_t pairs = 2048;  ///< More than a branch predictor learns by heart.
  std::size_t repetitions = 101;
};

template <int D>
void time_cell(Report& report, const Cell& cell, const Counts& counts, const Library<D>& core,
               std::vector<Rival<D>>& rivals) {
  const std::vector<Pair<D>> pairs =
      PairSource<D>(kSeed).pairs(counts.pairs, cell.vertices, cell.spacing, cell.poses);
  std::vector<Contestant> contestants = {core.prepare(pairs)};
  for (const Rival<D>& rival : rivals) contestants.push_back(rival.library.prepare(pairs));
  const std::vector<Timing> timings = interleave(contestants, counts.pairs, counts.repetitions);

  // Float libraries err by about 1e-7 a query; more means that one did other work.
  const auto did_other_work = [&](std::size_t i) {
    return rivals[i].library.measures && !(std::abs(timings[i + 1].sum - timings[0].sum) <
                                           1e-6 * static_cast<double>(counts.pairs));
  };
  report.print("| {}{} | {} | {:.1f} |", cell.vertices,
               cell.poses == Poses::set ? "" : ", no poses", cell.spacing.name,
               quartiles(timings[0].ns).median);
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

template <int D>
void time_grid(Report& report, const std::string& what, const Counts& counts,
               const Library<D>& core, std::vector<Rival<D>> against) {
  if (against.empty()) return;
  report.print("### {}: {}\n\n- {}: {}\n", D == 2 ? "In the plane" : "In space", what, core.name,
               core.how);
  for (const Rival<D>& rival : against) {
    report.print("- {}: {}\n", rival.library.name, rival.library.how);
  }
  report.print("\n| vertices | pairs | {} |", core.name);
  for (const Rival<D>& rival : against) report.print(" {} |", rival.library.name);
  report.print("\n| --- | --- | --- |");
  for (std::size_t i = 0; i < against.size(); ++i) report.print(" --- |");
  report.print("\n");
  for (const Cell& cell : grid<D>()) time_cell(report, cell, counts, core, against);
  report.print("\n");
  for (const Rival<D>& rival : against) {
    double logarithms = 0.0;
    for (const double share : rival.shares) logarithms += std::log(share);
    const std::string of = fmt::format("{} / {}", core.name, rival.library.name);
    judge(report, std::exp(logarithms / static_cast<double>(rival.shares.size())), rival.mean,
          "geometric mean of " + of);
    judge(report, *std::max_element(rival.shares.begin(), rival.shares.end()), HUGE_VAL,
          "largest " + of);
  }
  report.print("\n");
}

template <int D>
void time_all(Report& report, const Counts& counts) {
  time_grid(report, "other libraries", counts, core_double<D>(), native_peers<D>());
  time_grid(report, "other libraries, and nothing proved", counts, core_no_proof<D>(),
            native_peers<D>());
  time_grid(report, "other ways to ask this core", counts, core_double<D>(), own_variants<D>());
}

/// Convex polygons with many vertices against the same ones with two vertices swapped, in which the
/// core has to look at all of them.
void time_large(Report& report, std::size_t repetitions) {
  constexpr std::size_t kPairs = 64;
  constexpr int kLarge = 1024;
  const std::vector<Pair<2>> ordered = PairSource<2>(kSeed).pairs(kPairs, kLarge, kSpacings[0]);
  std::vector<Pair<2>> disordered = ordered;
  for (Pair<2>& pair : disordered) {
    std::swap(pair.x[0], pair.x[1]);
    std::swap(pair.y[0], pair.y[1]);
  }
  const std::vector<Timing> timings =
      interleave({core_double<2>().prepare(ordered), core_double<2>().prepare(disordered)}, kPairs,
                 repetitions);
  const Quartiles share = ratio(timings[0], timings[1]);
  report.print("### In the plane: many vertices\n\n");
  report.print("{} vertices: {:.0f} ns, by plain scan {:.0f} ns, ratio {:.3f} ({:.3f}-{:.3f}).\n\n",
               kLarge, quartiles(timings[0].ns).median, quartiles(timings[1].ns).median,
               share.median, share.low, share.high);
  judge(report, share.median, 0.25, "gjkscope / plain scan");
  judge(report, std::abs(timings[0].sum - timings[1].sum), 0.0, "difference of the answers");
}

void run(const Counts& counts, const std::string& document) {
  Report report;
  const gjkscope::study::Machine machine = gjkscope::study::this_machine();
  report.print(
      "\nMade by `core-compare --pairs {} --repetitions {} --write docs/numerics.md` on {}, one "
      "thread, {},\n`{}`. A library from a distribution is as that compiled it (Debian: -O2).\n\n"
      "A cell has the median time of a query in ns; after the colon the third column's time as a "
      "share of it, with its quartiles over\ninterleaved repetitions: below 1 gjkscope is faster. "
      "\"Other work\" marks answers that differ by more than floats err.\n"
      "Shapes are about 2 across; they are 1, 1e-3 or 1e-6 apart, or overlap by far. Y has a pose, "
      "or "
      "(\"no poses\") its vertices are where it stands.\n\n",
      counts.pairs, counts.repetitions, machine.processor, machine.compiler, machine.flags);
  time_all<2>(report, counts);
  time_large(report, counts.repetitions);
  report.print("\n");
  time_all<3>(report, counts);
  if (!document.empty()) write_section(document, "core-compare", report.text());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the core beside other libraries");
  Counts counts;
  std::string document;
  app.add_option("--pairs", counts.pairs, "pairs a cell")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", counts.repetitions, "repetitions of a cell")
      ->check(CLI::PositiveNumber);
  app.add_option("--write", document, "document whose marked section gets the report");
  CLI11_PARSE(app, argc, argv);
  try {
    run(counts, document);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "core-compare: {}\n", problem.what());
    return 1;
  }
  return 0;
}
