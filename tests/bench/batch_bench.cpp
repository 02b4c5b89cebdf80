// The batch beside the scalar code, on the same pairs of floats.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "bench/grid_pairs.hpp"
#include "gjk/batch.hpp"
#include "study/interleave.hpp"

namespace {

using namespace bench;
using namespace gjkscope::study;
using FloatPair = families::Pair<float>;

constexpr double kWanted = 4.0;  ///< Times as fast as the scalar code, as a geometric mean.

struct Settings {
  std::size_t pairs = 2000;
  std::size_t repetitions = 31;
};

std::vector<FloatPair> in_float(const std::vector<Pair>& pairs) {
  std::vector<FloatPair> out;
  for (const Pair& pair : pairs) out.push_back(families::converted<float>(pair));
  return out;
}

std::vector<FloatPair> of_family(families::Family family, std::size_t pairs) {
  families::Source random(1);
  std::vector<FloatPair> out;
  while (out.size() < pairs) {
    out.push_back(random.pair<float>(family, families::Representation::float_values));
  }
  return out;
}

/// Prints a line; returns how many times faster the batch is.
double compare(const std::string& name, const std::vector<FloatPair>& pairs,
               std::size_t repetitions) {
  gjk::Batch batch;
  std::vector<gjk::Query<float, 2>> queries;
  for (const FloatPair& pair : pairs) batch.add(queries.emplace_back(pair.query()));
  std::vector<gjk::BatchResult> results(pairs.size());
  int handed_over = 0;

  Contestant scalar;
  scalar.sweep = [&] {
    double sum = 0.0;
    for (const gjk::Query<float, 2>& query : queries) {
      sum += static_cast<double>(gjk::distance(query).distance);
    }
    return sum;
  };
  Contestant lanes;
  lanes.sweep = [&] {
    handed_over = batch.distance(results);
    return 0.0;
  };
  const std::vector<Timing> timings = interleave({scalar, lanes}, pairs.size(), repetitions);

  const Quartiles times = ratio(timings[0], timings[1]);
  fmt::print("{:<22}{:8.1f}{:8.1f}{:8.2f} ({:.2f} ... {:.2f}){:10.2f} %\n", name,
             quartiles(timings[0].ns).median, quartiles(timings[1].ns).median, times.median,
             times.low, times.high, 100.0 * handed_over / static_cast<double>(pairs.size()));
  return times.median;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the batch of float pairs beside the scalar code");
  Settings settings;
  app.add_option("--pairs", settings.pairs, "pairs a line")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", settings.repetitions, "repetitions of a line")
      ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  fmt::print(
      "{} pairs a line, {} interleaved repetitions, one thread. Median ns a pair, times as fast\n"
      "with quartiles over the repetitions, pairs that the lanes handed over to the scalar "
      "code.\n\n"
      "{:<22}{:>8}{:>8}{:>8}{:>28}\n",
      settings.pairs, settings.repetitions, "", "scalar", "batch", "times", "handed over");
  double log_sum = 0.0;
  int lines = 0;
  for (const int count : {3, 4, 8}) {
    for (const Spacing& spacing : kSpacings) {
      PairSource random(static_cast<std::uint64_t>(count));
      log_sum += std::log(compare(fmt::format("{} {}", count, spacing.name),
                                  in_float(random.pairs(settings.pairs, count, spacing)),
                                  settings.repetitions));
      ++lines;
    }
  }
  const double mean = std::exp(log_sum / lines);
  fmt::print("geometric mean {:.2f}, wanted >= {:.2f}: {}\n\n", mean, kWanted,
             mean >= kWanted ? "ok" : "FAIL");
  for (int i = 0; i < families::kFamilyCount; ++i) {
    compare(std::string(families::kFamilyNames[static_cast<std::size_t>(i)]),
            of_family(static_cast<families::Family>(i), settings.pairs), settings.repetitions);
  }
  return 0;
}
