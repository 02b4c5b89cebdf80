// The batch against the scalar code, on the same float pairs: nanoseconds a pair, how many times
// faster, and the share of pairs that the lanes handed over. One thread; the two take turns, and
// medians over the turns are printed.
//
//   batch-bench [turns] [pairs]

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "gjk/batch.hpp"
#include "random_pairs.hpp"

namespace {

using gjk::Vec;
using random_pairs::Pair;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class S>
gjk::Pose<S, 2> pose(double angle, double x, double y) {
  gjk::Pose<S, 2> out;
  out.rotation << static_cast<S>(std::cos(angle)), static_cast<S>(-std::sin(angle)),
      static_cast<S>(std::sin(angle)), static_cast<S>(std::cos(angle));
  out.translation = Vec<S, 2>(static_cast<S>(x), static_cast<S>(y));
  return out;
}

/// Polygons of `count` vertices and size 1, X at rest, Y turned by its pose and moved to `gap` from
/// X; below 0 they overlap, centre distance -gap.
std::vector<Pair<float>> at_gap(int count, int pairs, double gap, std::uint64_t seed) {
  random_pairs::Source random(seed);
  std::vector<Pair<float>> out;
  while (static_cast<int>(out.size()) < pairs) {
    Pair<float> pair;
    pair.x = random.polygon<float>(count, 1.0, 0, 0);
    pair.y = random.polygon<float>(count, 1.0, 0, 0);
    const double angle = random.between(0, 6.283185307179586);
    const double towards = random.between(0, 6.283185307179586);
    const double reach = gap < 0 ? -gap : 4;
    Vec<double, 2> at(reach * std::cos(towards), reach * std::sin(towards));
    if (gap >= 0) {
      std::vector<Vec<double, 2>> x;
      std::vector<Vec<double, 2>> y;
      for (const Vec<float, 2>& v : pair.x) x.push_back(v.cast<double>());
      for (const Vec<float, 2>& v : pair.y) y.push_back(v.cast<double>());
      const auto far =
          gjk::distance(gjk::Query<double, 2>{{x}, {y, pose<double>(angle, at[0], at[1])}});
      at -= (far.y - far.x) * ((far.distance - gap) / far.distance);
    }
    pair.y_pose = pose<float>(angle, at[0], at[1]);
    out.push_back(std::move(pair));
  }
  return out;
}

std::vector<Pair<float>> of_family(random_pairs::Family family, int pairs, std::uint64_t seed) {
  random_pairs::Source random(seed);
  std::vector<Pair<float>> out;
  while (static_cast<int>(out.size()) < pairs) out.push_back(random.pair<float>(family));
  return out;
}

struct Timing {
  std::string name;
  std::vector<double> turns;
  [[nodiscard]] double median() {
    std::sort(turns.begin(), turns.end());
    return turns[turns.size() / 2];
  }
};

double compare(const std::string& name, const std::vector<Pair<float>>& pairs, int turns) {
  gjk::Batch batch;
  std::vector<gjk::Query<float, 2>> queries;
  for (const Pair<float>& pair : pairs) {
    queries.push_back(pair.query());
    batch.add(queries.back());
  }
  std::vector<gjk::BatchResult> results(pairs.size());
  const double count = static_cast<double>(pairs.size());
  Timing lanes{"lanes", {}};
  Timing scalar{"scalar", {}};
  int handed_over = 0;
  float sum = 0;
  for (int turn = 0; turn < turns; ++turn) {
    double start = seconds();
    for (const gjk::Query<float, 2>& query : queries) sum += gjk::distance(query).distance;
    scalar.turns.push_back((seconds() - start) / count * 1e9);
    start = seconds();
    for (int i = 0; i < 4; ++i) handed_over = batch.distance(results);
    lanes.turns.push_back((seconds() - start) / count * 1e9 / 4);
  }
  int apart = 0;
  for (const gjk::BatchResult& result : results) {
    apart += result.verdict == gjk::Verdict::separated ? 1 : 0;
  }
  const double ratio = scalar.median() / lanes.median();
  std::printf("%-20s %8.1f %8.1f %7.2f %9.3f %% %8.1f %%%s\n", name.c_str(), scalar.median(),
              lanes.median(), ratio, 100.0 * handed_over / count, 100.0 * apart / count,
              sum > -1 ? "" : " ");
  return ratio;
}

}  // namespace

int main(int argc, char** argv) {
  const int turns = argc > 1 ? std::atoi(argv[1]) : 31;
  const int pairs = argc > 2 ? std::atoi(argv[2]) : 2000;
  std::printf("%-20s %8s %8s %7s %11s %10s\n", "", "scalar", "batch", "times", "handed over",
              "separated");
  double product = 1;
  int sets = 0;
  for (const int count : {3, 4, 8}) {
    const auto run = [&](const char* name, double gap) {
      product *= compare(std::to_string(count) + " " + name,
                         at_gap(count, pairs, gap, static_cast<std::uint64_t>(count)), turns);
      ++sets;
    };
    run("separated", 1.0);
    run("gap 1e-3", 1e-3);
    run("gap 1e-6", 1e-6);
    run("overlap", -0.3);
  }
  std::printf("geometric mean %.2f\n", std::pow(product, 1.0 / sets));
  for (int i = 0; i < random_pairs::kFamilyCount; ++i) {
    compare(std::string(random_pairs::kFamilyNames[i]),
            of_family(static_cast<random_pairs::Family>(i), pairs, 1), turns);
  }
  return 0;
}
