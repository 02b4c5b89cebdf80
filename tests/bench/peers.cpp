// The core and other libraries side by side on pairs of every family: how often each fails, held
// against the exact truth, and how long it takes. `--write` puts the failures into a document.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "document.hpp"
#include "trial.hpp"

namespace {

using namespace bench;
using families::Family;
using families::Representation;

constexpr std::size_t kTimedPairs = 500;
constexpr std::size_t kRepetitions = 15;

struct Settings {
  std::size_t pairs = 2000;
  std::uint64_t seed = 20100309;
  bool times = true;
  std::string document;
};

/// The core in double and in float, and what can be asked beside it. Float libraries see nothing
/// but pairs of floats.
template <int D>
std::vector<Library<D>> libraries_for(Representation representation) {
  std::vector<Library<D>> out = peers<D>(Peers::all);
  out.insert(out.begin(), {core_double<D>(), core_float<D>()});
  if (representation == Representation::full_doubles) {
    std::erase_if(out, [](const auto& library) { return !library.in_double; });
  }
  return out;
}

/// The outcome of one family, library by library.
struct Row {
  Family family = Family::random;
  std::vector<Tally> tallies;
  std::vector<double> ns;  ///< Median per query; empty when times were not wanted.
};

/// On the pairs that fit all libraries. One that crashed has nothing to do.
template <int D>
std::vector<double> times(const std::vector<Library<D>>& libraries,
                          const std::vector<Case<D>>& cases, const std::vector<Tally>& tallies) {
  std::vector<Pair<D>> pairs;
  for (const Case<D>& one : cases) {
    const bool all = std::all_of(libraries.begin(), libraries.end(),
                                 [&](const auto& library) { return fits(library, one.pair); });
    if (all && pairs.size() < kTimedPairs) pairs.push_back(one.pair);
  }
  std::vector<Contestant> contestants;
  for (std::size_t i = 0; i < libraries.size(); ++i) {
    contestants.push_back(libraries[i].prepare(tallies[i].crashed > 0 ? std::span<const Pair<D>>()
                                                                      : std::span(pairs)));
  }
  std::vector<double> out;
  for (const Timing& timing : interleave(contestants, pairs.size(), kRepetitions)) {
    out.push_back(quartiles(timing.ns).median);
  }
  return out;
}

template <int D>
std::vector<Row> rows(const std::vector<Library<D>>& asked, Representation representation,
                      const Settings& settings) {
  std::vector<Row> out;
  for (int i = 0; i < (D == 2 ? families::kFamilyCount : families::kSpaceFamilyCount); ++i) {
    Row& row = out.emplace_back();
    row.family = static_cast<Family>(i);
    const auto cases = cases_of<D>(row.family, representation, settings.pairs, settings.seed);
    for (const Library<D>& library : asked) row.tallies.push_back(tally(library, cases));
    if (settings.times) row.ns = times(asked, cases, row.tallies);
  }
  return out;
}

std::string failures(const Tally& tally) {
  std::string out;
  const auto add = [&](int count, const char* of) {
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, of);
  };
  add(tally.missed, "m");
  add(tally.invented, "i");
  add(tally.inaccurate, "r");
  add(tally.not_finite, "n");
  add(tally.gave_up, "g");
  add(tally.crashed, "c");
  return out.empty() ? "." : out;
}

/// A Markdown table of families and libraries; `cell(row, i)` is what stands at library i.
template <int D, class Cell>
std::string table(const std::vector<Library<D>>& asked, const std::vector<Row>& rows, Cell cell) {
  std::string head = "| family |";
  std::string rule = "| --- |";
  for (const Library<D>& library : asked) {
    head += fmt::format(" {} |", library.name);
    rule += " --- |";
  }
  std::string out = fmt::format("{}\n{}\n", head, rule);
  for (const Row& row : rows) {
    out += fmt::format("| {} |", families::kFamilyNames[static_cast<std::size_t>(row.family)]);
    for (std::size_t i = 0; i < asked.size(); ++i) out += fmt::format(" {} |", cell(row, i));
    out += "\n";
  }
  return out;
}

std::string preamble(const Settings& settings) {
  return fmt::format(
      "\nMade by `peers --pairs {0} --seed {1} --write docs/numerics.md`. Of each family of pairs "
      "(`src/study/families.hpp` says what is in them)\n{0} are drawn, each library is asked how "
      "far "
      "apart the shapes are, and the exact answer judges it. A cell counts its failures:\n\n"
      "- a dot: none,\n"
      "- m: overlap missed, the answer is above 4 u * scale,\n"
      "- i: overlap invented, the answer is 0 and the shapes are apart,\n"
      "- r: relative error above {2:.0e} (libraries in float) or {3:.0e} (in double),\n"
      "- n: NaN or infinity,\n"
      "- g: gave up: said so, or threw,\n"
      "- c: crashed, or took more than {4} s.\n\n"
      "u is the unit roundoff of what the library computes in, scale the largest distance between "
      "a vertex of one shape and one of the other.\n",
      settings.pairs, settings.seed, kFloatLimit, kDoubleLimit, kSecondsPerQuery);
}

struct Report {
  std::string document;
  std::string times;
};

template <int D>
void try_all(Representation representation, const Settings& settings, Report& report) {
  const std::vector<Library<D>> asked = libraries_for<D>(representation);
  const std::vector<Row> found = rows(asked, representation, settings);
  const std::string what = fmt::format(
      "{}, coordinates {}", D == 2 ? "In the plane" : "In space",
      representation == Representation::float_values ? "that are floats" : "in full doubles");
  report.document += fmt::format("\n#### {}: failures\n\n", what);
  report.document +=
      table(asked, found, [](const Row& row, std::size_t i) { return failures(row.tallies[i]); });
  report.document += fmt::format(
      "\n#### {}: largest relative error\n\nWhere shapes are apart and the answer is not 0.\n\n",
      what);
  report.document += table(asked, found, [](const Row& row, std::size_t i) {
    const double worst = row.tallies[i].worst;
    return worst > 0.0 ? fmt::format("{:.0e}", worst) : std::string(".");
  });
  if (!settings.times) return;
  report.times += fmt::format("\n{}: median ns per query\n\n", what);
  report.times += table(asked, found, [](const Row& row, std::size_t i) {
    return row.tallies[i].crashed > 0 ? std::string("-") : fmt::format("{:.0f}", row.ns[i]);
  });
}

template <int D>
void run(const Settings& settings, Report& report) {
  report.document +=
      fmt::format("\n### {}\n\n| library | computes in | asked by |\n| --- | --- | --- |\n",
                  D == 2 ? "In the plane" : "In space");
  for (const auto& library : libraries_for<D>(Representation::float_values)) {
    report.document += fmt::format("| {} | {} | {} |\n", library.name,
                                   library.in_double ? "double" : "float", library.how);
  }
  try_all<D>(Representation::float_values, settings, report);
  try_all<D>(Representation::full_doubles, settings, report);
}

void run(const Settings& settings) {
  Report report{preamble(settings), ""};
  run<2>(settings, report);
  run<3>(settings, report);
  report.document += "\n";
  fmt::print("{}{}", report.document, report.times);
  if (!settings.document.empty()) write_section(settings.document, "peers", report.document);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Failures and times of the core and of other libraries");
  Settings settings;
  bool no_times = false;
  app.add_option("--pairs", settings.pairs, "pairs of each family")->check(CLI::PositiveNumber);
  app.add_option("--seed", settings.seed, "of the pairs");
  app.add_option("--write", settings.document, "document whose marked section gets the failures");
  app.add_flag("--no-times", no_times, "do not measure times");
  CLI11_PARSE(app, argc, argv);
  settings.times = !no_times;
  try {
    run(settings);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "peers: {}\n", problem.what());
    return 1;
  }
  return 0;
}
