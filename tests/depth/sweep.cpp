// Asks for the depth of random overlapping pairs of every family, in the plane or in space, and
// holds the answers against all edges or faces of the exact hull of Z. Exit code 1 when a claim is
// broken; then some pairs that break it are printed as cases for `gjkscope solve` (which have no
// poses).

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "in_pieces.hpp"
#include "pairs.hpp"
#include "pairs_in_space.hpp"

namespace test {
namespace {

using families::Representation;

/// A scalar of the query and one of the run.
enum class Mode { in_double, float_in_double, in_float };
constexpr std::array<const char*, 3> kModeNames = {"double", "float in double", "float"};

/// The pairs of the sweep in dimension D, and their truth. Families are numbers from 0.
template <int D>
struct Space {
  using Pair = test::Pair;
  using Family = test::DepthFamily;
  static constexpr int kFamilies = test::kDepthFamilyCount;
  static constexpr Family kDenormals = test::kDenormals;
  static std::string_view name_of(Family family) { return test::name_of(family); }
  static Pair meeting_pair(families::Source& source, Family family, Representation values) {
    return test::meeting_pair(source, family, values);
  }
  static Truth truth_of(const Pair& pair) { return test::truth_of(pair); }
  static const Judgement& bars() { return kBars; }
};
template <>
struct Space<3> {
  using Pair = space::Pair;
  using Family = space::DepthFamily;
  static constexpr int kFamilies = space::kDepthFamilyCount;
  static constexpr Family kDenormals = space::kDenormals;
  static std::string_view name_of(Family family) { return space::name_of(family); }
  static Pair meeting_pair(families::Source& source, Family family, Representation values) {
    return space::meeting_pair(source, family, values);
  }
  static space::Truth truth_of(const Pair& pair) { return space::truth_of(pair); }
  static const Judgement& bars() { return space::kBars; }
};

template <int D>
std::string json_of(const std::vector<gjk::Vec<double, D>>& points) {
  std::string out;
  for (const gjk::Vec<double, D>& p : points) {
    out += out.empty() ? "[" : ",[";
    for (int i = 0; i < D; ++i) out += fmt::format("{}\"{:a}\"", i == 0 ? "" : ",", p[i]);
    out += "]";
  }
  return "[" + out + "]";
}

struct Failure {
  long pair = 0;
  std::string text;
};

/// The outcome of the pairs of one family, one representation and one mode.
struct Row {
  static constexpr std::size_t kKept = 2;  ///< Failures to be shown.
  enum Count { pairs, broken, touching, separated, settled, repeated, kCounts };
  std::array<long, kCounts> counts = {};
  Judgement most;
  int iterations = 0;
  std::vector<Failure> failures;

  void widen(const Judgement& found) {
    for (const auto length :
         {&Judgement::error, &Judgement::width, &Judgement::touch, &Judgement::contact}) {
      most.*length = std::max(most.*length, found.*length);
    }
  }
  void add(const Row& other) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
    widen(other.most);
    iterations = std::max(iterations, other.iterations);
    failures.insert(failures.end(), other.failures.begin(), other.failures.end());
    std::sort(failures.begin(), failures.end(),
              [](const Failure& a, const Failure& b) { return a.pair < b.pair; });
    if (failures.size() > kKept) failures.resize(kKept);
  }
};
using Rows = std::array<Row, 3>;  ///< One for each mode.

template <int D>
struct Work {
  typename Space<D>::Family family = {};
  Representation representation = Representation::full_doubles;
  Piece piece;
};

template <int D>
class Worker {
 public:
  using Pair = typename Space<D>::Pair;
  explicit Worker(const Work<D>& work) : work_(work), source_(work.piece.seed) {}

  Rows run() {
    while (done_ < work_.piece.pairs) {
      const Pair pair = Space<D>::meeting_pair(source_, work_.family, work_.representation);
      check(pair);
      check(families::swapped(pair));
    }
    return std::move(rows_);
  }

 private:
  void check(const Pair& pair) {
    const auto truth = Space<D>::truth_of(pair);
    const auto result = depth::penetration<double>(pair.query());
    note(pair, truth, result, Mode::in_double);
    if (work_.representation == Representation::float_values) {
      const auto narrow = families::converted<float>(pair);
      note(pair, truth, depth::penetration<double>(narrow.query()), Mode::float_in_double);
      note(pair, truth, depth::penetration<float>(narrow.query()), Mode::in_float);
    }
    if (!keeps_bits_when_scaled(pair, result, source_.among(-90, 90))) {
      fail(rows_[0], pair, "bits of the pair times a power of two");
    }
    // Rounding may have left a pair that was to meet apart.
    if (truth.verdict != gjk::Verdict::separated) ++done_;
  }

  template <class R, class Truth>
  void note(const Pair& pair, const Truth& truth, const depth::Result<R, D>& result, Mode mode) {
    Row& row = rows_[static_cast<std::size_t>(mode)];
    ++row.counts[truth.verdict == gjk::Verdict::separated ? Row::separated : Row::pairs];
    row.counts[Row::touching] += truth.verdict == gjk::Verdict::touching;
    row.counts[Row::settled] += result.settled;
    row.counts[Row::repeated] += result.stop == depth::StopReason::repeated_support;
    row.iterations = std::max(row.iterations, result.iterations);
    // A named error is an answer to denormal numbers.
    if (result.error != gjk::Error::none && work_.family == Space<D>::kDenormals) return;
    const Judgement found = judge(result, truth);
    row.widen(found);
    const std::string broken = broken_bar(result, found, Space<D>::bars());
    if (broken.empty()) return;
    fail(row, pair,
         fmt::format("{}: depth {:.17g} in [{:.17g}, {:.17g}], off by {:.3Lg}, {:.3Lg} wide, "
                     "touch {:.3Lg}, contact {:.3Lg}",
                     broken, double{result.depth}, double{result.lower}, double{result.upper},
                     found.error, found.width, found.touch, found.contact));
  }

  void fail(Row& row, const Pair& pair, const std::string& what) {
    if (++row.counts[Row::broken] > static_cast<long>(Row::kKept)) return;
    const bool posed = pair.x_pose.rotation.turns() || pair.y_pose.rotation.turns();
    row.failures.push_back(
        {work_.piece.first + done_,
         fmt::format("{}\n  {{\"name\":\"{}, seed {}{}\",\"a\":{},\"b\":{}}}", what,
                     Space<D>::name_of(work_.family), work_.piece.seed, posed ? ", posed" : "",
                     json_of<D>(pair.x), json_of<D>(pair.y))});
  }

  Work<D> work_;
  families::Source source_;
  long done_ = 0;
  Rows rows_;
};

template <int D>
struct Job {
  typename Space<D>::Family family;
  Representation representation;
  Rows rows = {};
};

template <int D>
void run(std::vector<Job<D>>& jobs, long pairs, unsigned threads, std::uint64_t seed) {
  in_pieces(jobs, pairs, threads, seed, [](const Job<D>& job, const Piece& piece) {
    return Worker<D>({job.family, job.representation, piece}).run();
  });
}

/// Prints a row for each family, representation and mode; returns how many claims are broken.
template <int D>
long print(const std::vector<Job<D>>& jobs) {
  fmt::print("{:<15}{:<8}{:<16}{:>9}{:>8}{:>9}{:>10}{:>9}{:>10}{:>6}{:>8}{:>8}{:>8}{:>9}\n",
             "family", "values", "run", "pairs", "broken", "touching", "separated", "settled",
             "repeated", "most", "error", "width", "touch", "contact");
  long broken = 0;
  long pairs = 0;
  std::string failures;
  for (const Job<D>& job : jobs) {
    for (std::size_t mode = 0; mode < job.rows.size(); ++mode) {
      const Row& row = job.rows[mode];
      if (row.counts[Row::pairs] == 0) continue;
      const std::string_view family = Space<D>::name_of(job.family);
      fmt::print(
          "{:<15}{:<8}{:<16}{:>9}{:>8}{:>9}{:>10}{:>9}{:>10}{:>6}{:>8.3Lg}{:>8.3Lg}"
          "{:>8.3Lg}{:>9.3Lg}\n",
          family, job.representation == Representation::float_values ? "float" : "double",
          kModeNames[mode], row.counts[Row::pairs], row.counts[Row::broken],
          row.counts[Row::touching], row.counts[Row::separated], row.counts[Row::settled],
          row.counts[Row::repeated], row.iterations, row.most.error, row.most.width, row.most.touch,
          row.most.contact);
      broken += row.counts[Row::broken];
      if (mode == 0) pairs += row.counts[Row::pairs];
      for (const Failure& failure : row.failures) {
        failures += fmt::format("\n{} in {}: {}\n", family, kModeNames[mode], failure.text);
      }
    }
  }
  fmt::print("{}\n{} overlapping or touching pairs, {} claims broken\n", failures, pairs, broken);
  return broken;
}

struct Asked {
  long pairs = 50000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t seed = 1;
  std::vector<std::string> families;  ///< All if none is named.
};

template <int D>
int sweep(const Asked& asked) {
  using Family = typename Space<D>::Family;
  std::vector<std::string> unknown = asked.families;
  std::vector<Job<D>> jobs;
  for (int i = 0; i < Space<D>::kFamilies; ++i) {
    const auto family = static_cast<Family>(i);
    const std::string name(Space<D>::name_of(family));
    std::erase(unknown, name);
    if (!asked.families.empty() &&
        std::find(asked.families.begin(), asked.families.end(), name) == asked.families.end())
      continue;
    for (const auto representation : {Representation::float_values, Representation::full_doubles}) {
      // No float is as large, or as small.
      if (family == Family::extreme && representation == Representation::float_values) continue;
      jobs.push_back({family, representation});
    }
  }
  if (!unknown.empty()) {
    fmt::print(stderr, "depth-sweep: no family {} in dimension {}\n", unknown.front(), D);
    return 2;
  }
  run<D>(jobs, asked.pairs, asked.threads, asked.seed);
  return print<D>(jobs) == 0 ? 0 : 1;
}

int main_of(int argc, char** argv) {
  Asked asked;
  int dimension = 2;
  CLI::App app("Holds penetration depths of random pairs against the exact truth");
  app.add_option("--pairs", asked.pairs, "Overlapping pairs over all families")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", asked.threads, "Threads; they do not change the answer")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", asked.seed, "Seed");
  app.add_option("--dimension", dimension, "2: the plane, 3: space")->check(CLI::Range(2, 3));
  app.add_option("--families", asked.families, "Families; all if none is named")->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  return dimension == 3 ? sweep<3>(asked) : sweep<2>(asked);
}

}  // namespace
}  // namespace test

int main(int argc, char** argv) { return test::main_of(argc, argv); }
