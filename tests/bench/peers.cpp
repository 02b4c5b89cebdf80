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

/// Float libraries see nothing but pairs of floats.
std::vector<Library> libraries_for(Representation representation) {
  std::vector<Library> out = libraries();
  if (representation == Representation::full_doubles) {
    std::erase_if(out, [](const Library& library) { return !library.in_double; });
  }
  return out;
}

/// What happened to one family, library by library.
struct Row {
  Family family = Family::random;
  std::vector<Tally> tallies;
  std::vector<double> ns;  ///< Median per query; empty when times were not wanted.
};

/// On the pairs that fit all libraries. One that crashed has nothing to do.
std::vector<double> times(const std::vector<Library>& libraries, const std::vector<Case>& cases,
                          const std::vector<Tally>& tallies) {
  std::vector<Pair> pairs;
  for (const Case& one : cases) {
    const bool all = std::all_of(libraries.begin(), libraries.end(),
                                 [&](const Library& library) { return fits(library, one.pair); });
    if (all && pairs.size() < kTimedPairs) pairs.push_back(one.pair);
  }
  std::vector<Contestant> contestants;
  for (std::size_t i = 0; i < libraries.size(); ++i) {
    contestants.push_back(
        libraries[i].prepare(tallies[i].crashed > 0 ? std::span<const Pair>() : std::span(pairs)));
  }
  std::vector<double> out;
  for (const Timing& timing : interleave(contestants, pairs.size(), kRepetitions)) {
    out.push_back(quartiles(timing.ns).median);
  }
  return out;
}

std::vector<Row> rows(Representation representation, const Settings& settings) {
  const std::vector<Library> asked = libraries_for(representation);
  std::vector<Row> out;
  for (int i = 0; i < families::kFamilyCount; ++i) {
    Row& row = out.emplace_back();
    row.family = static_cast<Family>(i);
    const std::vector<Case> cases =
        cases_of(row.family, representation, settings.pairs, settings.seed);
    for (const Library& library : asked) row.tallies.push_back(tally(library, cases));
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
template <class Cell>
std::string table(Representation representation, const std::vector<Row>& rows, Cell cell) {
  const std::vector<Library> asked = libraries_for(representation);
  std::string head = "| family |";
  std::string rule = "| --- |";
  for (const Library& library : asked) {
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

std::string failures_table(Representation representation, const std::vector<Row>& rows) {
  return table(representation, rows,
               [](const Row& row, std::size_t i) { return failures(row.tallies[i]); });
}

std::string errors_table(Representation representation, const std::vector<Row>& rows) {
  return table(representation, rows, [](const Row& row, std::size_t i) {
    const double worst = row.tallies[i].worst;
    return worst > 0.0 ? fmt::format("{:.0e}", worst) : std::string(".");
  });
}

std::string times_table(Representation representation, const std::vector<Row>& rows) {
  return table(representation, rows, [](const Row& row, std::size_t i) {
    return row.tallies[i].crashed > 0 ? std::string("-") : fmt::format("{:.0f}", row.ns[i]);
  });
}

std::string preamble(const Settings& settings) {
  std::string out = fmt::format(
      "Made by `peers --pairs {} --seed {} --write docs/numerics.md`. Of {} pairs in each "
      "family:\n\n"
      "- m: overlap missed, the answer is above 4 u * scale,\n"
      "- i: overlap invented, the answer is 0 and the shapes are apart,\n"
      "- r: relative error above {:.0e} (libraries in float) or {:.0e} (in double),\n"
      "- n: NaN or infinity,\n"
      "- g: gave up: said so, or threw,\n"
      "- c: crashed, or took more than {} s.\n\n"
      "| library | computes in | asked by |\n| --- | --- | --- |\n",
      settings.pairs, settings.seed, settings.pairs, kFloatLimit, kDoubleLimit, kSecondsPerQuery);
  for (const Library& library : libraries()) {
    out += fmt::format("| {} | {} | {} |\n", library.name, library.in_double ? "double" : "float",
                       library.how);
  }
  return out;
}

void run(const Settings& settings) {
  std::string document = "\n" + preamble(settings);
  std::string times;
  for (const Representation representation :
       {Representation::float_values, Representation::full_doubles}) {
    const bool floats = representation == Representation::float_values;
    const std::string what = floats ? "Coordinates that are floats" : "Coordinates in full doubles";
    const std::vector<Row> found = rows(representation, settings);
    document += fmt::format(
        "\n### {}\n\n{}\nLargest relative error, where the answer to shapes apart is not 0:\n\n{}",
        what, failures_table(representation, found), errors_table(representation, found));
    if (settings.times) {
      times +=
          fmt::format("\n{}: median ns per query\n\n{}", what, times_table(representation, found));
    }
  }
  document += "\n";
  fmt::print("{}{}", document, times);
  if (!settings.document.empty()) write_section(settings.document, "peers", document);
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
