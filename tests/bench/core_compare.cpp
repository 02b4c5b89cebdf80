// The core's time beside that of other libraries, one thread, on the same pairs: transform of Y,
// distance, witness points and, for the core, certificate. It reports; nothing fails when a target
// is missed. `--write` puts the report into a document.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "document.hpp"
#include "libraries.hpp"
#include "study/accuracy.hpp"

namespace {

using namespace bench;

constexpr std::uint64_t kSeed = 20100309;

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

/// `mean`: the share of a peer's time that the core may take.
template <int D>
std::vector<Rival<D>> native_peers(double mean) {
  std::vector<Rival<D>> out;
  for (const Library<D>& library : peers<D>(Peers::native)) {
    out.push_back({.library = library, .mean = library.measures ? mean : HUGE_VAL});
  }
  return out;
}

struct Cell {
  int vertices;
  Poses poses;
  Spacing spacing;
};

/// The cells to be timed. Polygons are always posed, as bodies are.
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
  // Box2D computes in float; libraries of space are held to their own times.
  time_grid(report, "other libraries", counts, core_double<D>(),
            native_peers<D>(D == 2 ? 1.40 : 1.00));
  time_grid(report, "other libraries, and nothing proved", counts, core_no_proof<D>(),
            native_peers<D>(D == 2 ? 1.10 : 1.00));
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

/// Plain ranges of points, which each query measures, beside shapes that were measured before.
void time_plain(Report& report, const Counts& counts) {
  report.print("### In the plane: plain ranges of points\n\n");
  for (const int vertices : {3, 8, 64}) {
    const std::vector<Pair<2>> pairs =
        PairSource<2>(kSeed).pairs(counts.pairs, vertices, kSpacings[0]);
    const std::vector<Timing> timings =
        interleave({core_plain<2>().prepare(pairs), core_double<2>().prepare(pairs)}, counts.pairs,
                   counts.repetitions);
    judge(report, ratio(timings[0], timings[1]).median, vertices <= 8 ? 1.4 : 2.0,
          fmt::format("plain ranges / measured shapes, {} vertices", vertices));
    judge(report, std::abs(timings[0].sum - timings[1].sum), 0.0, "difference of the answers");
  }
  report.print("\n");
}

/// The contestants whose instructions are counted.
std::vector<Library<2>> counted_libraries() {
  std::vector<Library<2>> out = {core_double<2>(), core_no_proof<2>(), core_plain<2>()};
  for (const Library<2>& library : peers<2>(Peers::native)) out.push_back(library);
  return out;
}
constexpr std::size_t kCountedPairs = 128;

/// Asks one library about every cell of the plane's grid. Only what runs below it is counted.
[[gnu::noinline]] double count_instructions_here(const std::vector<Contestant>& cells) {
  double sum = 0.0;
  for (const Contestant& cell : cells) sum += cell.sweep();
  return sum;
}
void answer_once(std::size_t library) {
  std::vector<Contestant> cells;
  for (const Cell& cell : grid<2>()) {
    cells.push_back(counted_libraries()[library].prepare(
        PairSource<2>(kSeed).pairs(kCountedPairs, cell.vertices, cell.spacing, cell.poses)));
  }
  keep(count_instructions_here(cells));
}

/// Instructions a query on the plane's grid, as callgrind counts them; nothing without valgrind.
void count_instructions(Report& report, const std::string& program) {
  if (std::system("command -v valgrind >/dev/null") != 0) return;
  report.print("### In the plane: instructions a query, by callgrind\n\n");
  const std::vector<Library<2>> libraries = counted_libraries();
  for (std::size_t i = 0; i < libraries.size(); ++i) {
    const std::string command = fmt::format(
        "valgrind --tool=callgrind --callgrind-out-file=/dev/null "
        "--toggle-collect='*count_instructions_here*' {} --answer-once {} 2>&1",
        program, i);
    std::FILE* output = popen(command.c_str(), "r");
    if (output == nullptr) throw std::runtime_error("cannot run valgrind");
    double collected = 0.0;
    std::array<char, 512> line{};
    while (std::fgets(line.data(), line.size(), output) != nullptr) {
      const std::string_view text(line.data());
      constexpr std::string_view kCollected = "Collected : ";
      if (const auto at = text.find(kCollected); at != text.npos)
        collected = std::strtod(line.data() + at + kCollected.size(), nullptr);
    }
    if (pclose(output) != 0 || collected == 0.0)
      throw std::runtime_error("valgrind gave no count for " + libraries[i].name);
    const auto queries = static_cast<double>(kCountedPairs * grid<2>().size());
    report.print("- {}: {:.0f}\n", libraries[i].name, collected / queries);
  }
  report.print("\n");
}

void run(const Counts& counts, const std::string& document, const std::string& program) {
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
  time_plain(report, counts);
  count_instructions(report, program);
  report.print("\n");
  time_all<3>(report, counts);
  if (!document.empty()) write_section(document, "core-compare", report.text());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the core beside other libraries");
  Counts counts;
  std::string document;
  std::optional<std::size_t> library;
  app.add_option("--answer-once", library, "only ask this library about the plane's grid, once");
  app.add_option("--pairs", counts.pairs, "pairs a cell")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", counts.repetitions, "repetitions of a cell")
      ->check(CLI::PositiveNumber);
  app.add_option("--write", document, "document whose marked section gets the report");
  CLI11_PARSE(app, argc, argv);
  try {
    if (library)
      answer_once(*library);
    else
      run(counts, document, argv[0]);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "core-compare: {}\n", problem.what());
    return 1;
  }
  return 0;
}
