// The core's time beside Box2D's, one thread, on the same pairs: transform of Y, distance, witness
// points and, for the core, certificate. It reports; nothing fails when a target is missed.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>

#include "contestants.hpp"

namespace {

using namespace bench;

constexpr int kVertices[] = {3, 4, kBox2dVertices};
constexpr std::uint64_t kSeed = 20100309;

template <class S>
std::vector<gjk::Vec<S, 2>> cast(const std::vector<Point>& points) {
  std::vector<gjk::Vec<S, 2>> out;
  for (const Point& point : points) out.push_back(point.cast<S>());
  return out;
}

template <class S>
gjk::Pose<S, 2> cast(const gjk::Pose<double, 2>& pose) {
  return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
}

template <class S>
Contestant core(std::string name, std::span<const Pair> pairs) {
  struct Prepared {
    std::vector<gjk::Vec<S, 2>> x;
    std::vector<gjk::Vec<S, 2>> y;
    gjk::Pose<S, 2> x_pose;
    gjk::Pose<S, 2> y_pose;
  };
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair& pair : pairs) {
    prepared->push_back(
        {cast<S>(pair.x), cast<S>(pair.y), cast<S>(pair.x_pose), cast<S>(pair.y_pose)});
  }
  return contestant(
      std::move(name), pairs.size(),
      [prepared](std::size_t i) {
        const Prepared& pair = (*prepared)[i];
        return gjk::distance<S, 2>({{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
      },
      [](const auto& result) { return result.distance; });
}

/// What the core's time may be, as a share of a peer's.
struct Target {
  std::string peer;
  double mean;   ///< Geometric mean over the grid.
  double worst;  ///< In one cell.
};
const Target kTargets[] = {{"Box2D 2.4", 0.80, HUGE_VAL}, {"Box2D 3", 0.75, 0.90}};

void report(bool met, const std::string& claim) {
  fmt::print("{}  {}\n", met ? "pass" : "FAIL", claim);
}

std::vector<Contestant> contestants(std::span<const Pair> pairs) {
  std::vector<Contestant> out = {core<double>("double", pairs), core<float>("float", pairs)};
#ifdef GJKSCOPE_BOX2D_2
  out.push_back(box2d_2(pairs));
#endif
#ifdef GJKSCOPE_BOX2D_3
  out.push_back(box2d_3(pairs));
#endif
  return out;
}

/// Float libraries err by about 1e-7 a query; more means that they did other work.
void check_answers(const std::vector<Timing>& timings, std::size_t pairs) {
  for (const Timing& each : timings) {
    const double difference = (each.sum - timings[0].sum) / static_cast<double>(pairs);
    if (!(std::abs(difference) < 1e-6)) {
      fmt::print("      {}: mean distance differs by {:.1e}\n", each.name, difference);
    }
  }
}

/// Ratios of the first contestant's time to one peer's, cell by cell.
using Ratios = std::map<std::string, std::vector<double>>;

void time_cell(int vertices, const Spacing& spacing, std::size_t count, std::size_t repetitions,
               Ratios& ratios) {
  const std::vector<Pair> pairs = PairSource(kSeed).pairs(count, vertices, spacing);
  const std::vector<Timing> timings = interleave(contestants(pairs), count, repetitions);
  fmt::print("{} {:<9}", vertices, spacing.name);
  for (const Timing& each : timings) {
    fmt::print(" | {} {:5.1f}", each.name, quartiles(each.ns).median);
    if (&each == timings.data()) continue;
    const Quartiles share = ratio(timings[0], each);
    fmt::print(", {:.2f} ({:.2f} {:.2f})", share.median, share.low, share.high);
    ratios[each.name].push_back(share.median);
  }
  fmt::print("\n");
  check_answers(timings, count);
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

void time_grid(std::size_t pairs, std::size_t repetitions) {
  fmt::print(
      "{} pairs a cell, {} interleaved repetitions, one thread. Median ns per query; then the\n"
      "time of double as a share of the other's, with its quartiles over the repetitions.\n"
      "Box2D from a distribution's package has that package's flags (Debian: -O2).\n\n",
      pairs, repetitions);
  Ratios ratios;
  for (const int vertices : kVertices) {
    for (const Spacing& spacing : kSpacings) {
      time_cell(vertices, spacing, pairs, repetitions, ratios);
    }
  }
  fmt::print("\n");
  for (const auto& [name, shares] : ratios) {
    fmt::print("      geometric mean of double / {}: {:.3f}, from {:.3f} to {:.3f}\n", name,
               geometric_mean(shares), *std::min_element(shares.begin(), shares.end()),
               *std::max_element(shares.begin(), shares.end()));
  }
  for (const Target& target : kTargets) {
    const auto found = ratios.find(target.peer);
    if (found == ratios.end()) {
      fmt::print("none  {} was not found when this was built\n", target.peer);
      continue;
    }
    const std::vector<double>& shares = found->second;
    report(geometric_mean(shares) <= target.mean,
           fmt::format("geometric mean {:.3f} of {}'s time, wanted <= {:.2f}",
                       geometric_mean(shares), target.peer, target.mean));
    if (std::isinf(target.worst)) continue;
    const double worst = *std::max_element(shares.begin(), shares.end());
    report(worst <= target.worst,
           fmt::format("at most {:.3f} of {}'s time in any cell, wanted <= {:.2f}", worst,
                       target.peer, target.worst));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times the core beside other libraries");
  std::size_t pairs = 2048;  // too many for the branch predictor to learn
  std::size_t repetitions = 101;
  app.add_option("--pairs", pairs, "pairs a cell")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", repetitions, "repetitions a cell")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  time_grid(pairs, repetitions);
  return 0;
}
