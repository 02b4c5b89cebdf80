// Runs the core on random pairs of every family and holds what it claims against the exact truth.
// Exit code 1 when a bar is broken; then some pairs that break it are printed as cases for
// `gjkscope solve`. Cases have no poses: where there are any, a_pose and b_pose tell them, rotation
// row by row, then translation.

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bars.hpp"
#include "in_pieces.hpp"
#include "study/families.hpp"

namespace gjkscope::study {
namespace {

using families::kFamilyNames;
using families::Representation;
template <int D>
using Pair = families::Pair<double, D>;

/// A scalar of the query and one of the run.
enum class Mode { in_double, float_in_double, in_float };
constexpr std::array<const char*, 3> kModeNames = {"double", "float in double", "float"};

void widen(Errors& most, const Errors& found) {
  for (const auto error :
       {&Errors::distance, &Errors::relative, &Errors::witness, &Errors::width}) {
    most.*error = std::max(most.*error, found.*error);
  }
}

Errors bars_of(families::Family family, Representation representation, Mode mode) {
  using families::Family;
  Errors bars = mode == Mode::in_float ? kFloatBars : kBars;
  if (mode == Mode::float_in_double) bars.relative = 1e-6;
  if (mode == Mode::in_double && representation == Representation::float_values &&
      family != Family::posed) {
    bars.relative = 1e-14;
  }
  if (representation == Representation::full_doubles && family == Family::gap) {
    bars.relative = 1e-12;
  }
  return bars;
}

/// One claim, and what is thought of it.
struct Found {
  Judgement judgement;
  Errors errors;
  gjk::StopReason stop = gjk::StopReason::running;
  bool settled = false;
  bool overlap = false;

  template <class R, int D>
  Found(const Truth<D>& truth, const gjk::Result<R, D>& result)
      : judgement(judge(claim_of(result), {truth, truth})),
        stop(result.stop),
        settled(result.settled),
        overlap(truth.overlap) {
    if (!judgement.failed) errors = errors_of(judgement, truth, unit_of<R>(truth));
  }
  [[nodiscard]] bool is_capped() const { return stop == gjk::StopReason::iteration_cap; }
};

struct Failure {
  std::string_view bar;  ///< The one that it breaks.
  std::string text;
  long pair = 0;
};

/// The outcome of the pairs of one family, one representation and one mode.
struct Row {
  enum Count {
    pairs,
    broken,
    wrong,
    undecided,
    failed,
    capped,
    bounds,
    overlaps,
    settled,
    kCounts
  };

  std::array<long, kCounts> counts = {};
  std::array<long, 9> stops = {};
  Errors most;
  std::vector<Failure> failures;  ///< To be shown: the first that breaks each bar.

  void add(const Found& found) {
    ++counts[pairs];
    counts[wrong] += found.judgement.wrong || found.judgement.wrong_contact;
    counts[undecided] += found.judgement.undecided;
    counts[failed] += found.judgement.failed;
    counts[capped] += found.is_capped();
    counts[bounds] += found.judgement.broken_bounds;
    counts[overlaps] += found.overlap;
    counts[settled] += found.settled;
    ++stops[static_cast<std::size_t>(found.stop)];
    widen(most, found.errors);
  }
  void add(const Row& other) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
    for (std::size_t i = 0; i < stops.size(); ++i) stops[i] += other.stops[i];
    widen(most, other.most);
    for (const Failure& failure : other.failures) {
      Failure* same = failure_of(failure.bar);
      if (same == nullptr) failures.push_back(failure);
      if (same != nullptr && failure.pair < same->pair) *same = failure;
    }
  }
  [[nodiscard]] Failure* failure_of(std::string_view bar) {
    const auto found = std::find_if(failures.begin(), failures.end(),
                                    [&](const Failure& one) { return one.bar == bar; });
    return found == failures.end() ? nullptr : &*found;
  }
};
using Rows = std::array<Row, 3>;  ///< One for each mode.

/// Numbers by their bits, separated by commas.
template <class Numbers>
std::string hex_of(const Numbers& numbers) {
  std::string out;
  for (const double value : numbers)
    out += fmt::format("{}\"{:a}\"", out.empty() ? "" : ",", value);
  return "[" + out + "]";
}
template <int D>
std::string json_of(const std::vector<gjk::Vec<double, D>>& points) {
  std::string out;
  for (const auto& p : points) out += (out.empty() ? "" : ",") + hex_of(p);
  return "[" + out + "]";
}
template <int D>
std::string json_of(const gjk::Pose<double, D>& pose) {
  std::vector<double> numbers;
  for (int row = 0; row < D; ++row) {
    for (int column = 0; column < D; ++column) numbers.push_back(pose.rotation(row, column));
  }
  numbers.insert(numbers.end(), pose.translation.begin(), pose.translation.end());
  return hex_of(numbers);
}
template <int D>
std::string json_of(const Pair<D>& pair, const std::string& name) {
  std::string poses;
  if (pair.x_pose.rotation.turns() || pair.y_pose.rotation.turns() ||
      pair.x_pose.translation != pair.y_pose.translation) {
    poses = fmt::format(R"(,"a_pose":{},"b_pose":{})", json_of<D>(pair.x_pose),
                        json_of<D>(pair.y_pose));
  }
  return fmt::format(R"({{"name":"{}","dimension":{},"a":{},"b":{}{}}})", name, D,
                     json_of<D>(pair.x), json_of<D>(pair.y), poses);
}

struct Work {
  families::Family family = families::Family::random;
  Representation representation = Representation::full_doubles;
  test::Piece piece;
};

/// Every so many pairs, one is tried in both orders of arguments and all rotations of its lists.
constexpr long kAllOrdersEvery = 16;

template <int D>
class Worker {
 public:
  explicit Worker(const Work& work) : work_(work), random_(work.piece.seed) {}

  Rows run() {
    for (long drawn = 0; done_ < work_.piece.pairs; ++drawn) {
      const Pair<D> pair = random_.pair<double, D>(work_.family, work_.representation);
      if (drawn % kAllOrdersEvery != 0) {
        check(pair);
        continue;
      }
      const std::size_t rotations = std::max(pair.x.size(), pair.y.size());
      for (std::size_t i = 0; i < rotations; ++i) {
        const Pair<D> rotated = families::rotated(pair, i, i);
        check(rotated);
        check(families::swapped(rotated));
      }
    }
    return std::move(rows_);
  }

 private:
  void check(const Pair<D>& pair) {
    if (done_ == work_.piece.pairs) return;
    const auto result = families::run<double>(pair);
    const Truth truth = truth_of(pair, result.warm());
    note(pair, truth, result, Mode::in_double);
    if (work_.representation == Representation::float_values) {
      const auto narrow = families::converted<float>(pair);
      note(pair, truth, families::run<double>(narrow), Mode::float_in_double);
      note(pair, truth, families::run<float>(narrow), Mode::in_float);
    }
    ++done_;
  }

  template <class R>
  void note(const Pair<D>& pair, const Truth<D>& truth, const gjk::Result<R, D>& result,
            Mode mode) {
    const Found found(truth, result);
    Row& row = rows_[static_cast<std::size_t>(mode)];
    row.add(found);
    // A named error is an answer to denormal numbers.
    if (result.error != gjk::Error::none && work_.family == families::Family::denormals) return;
    const Errors bars = bars_of(work_.family, work_.representation, mode);
    const std::string_view broken =
        found.is_capped() ? "iteration cap" : broken_bar(found.judgement, found.errors, bars);
    if (broken.empty()) return;
    ++row.counts[Row::broken];
    if (row.failure_of(broken) != nullptr) return;
    const std::string name =
        fmt::format("{}, seed {}, pair {}", kFamilyNames[static_cast<int>(work_.family)],
                    work_.piece.seed, done_);
    row.failures.push_back(
        {broken,
         fmt::format("{}: exact {:.17g}, found {:.17g} in [{:.17g}, {:.17g}]\n"
                     "  {}",
                     broken, truth.distance, double{result.distance}, double{result.lower},
                     double{result.upper}, json_of<D>(pair, name)),
         work_.piece.first + done_});
  }

  Work work_;
  families::Source random_;
  long done_ = 0;
  Rows rows_;
};

struct Job {
  families::Family family;
  Representation representation;
  Rows rows = {};
};

void print_rows(const std::vector<Job>& jobs) {
  const auto each = [&](auto print) {
    for (const Job& job : jobs) {
      for (std::size_t mode = 0; mode < job.rows.size(); ++mode) {
        const Row& row = job.rows[mode];
        if (row.counts[Row::pairs] == 0) continue;
        fmt::print("{:<15}{:<8}{:<16}{:>9}", kFamilyNames[static_cast<int>(job.family)],
                   job.representation == Representation::float_values ? "float" : "double",
                   kModeNames[mode], row.counts[Row::pairs]);
        print(row);
      }
    }
  };
  fmt::print("{:<15}{:<8}{:<16}{:>9}{:>8}{:>6}{:>6}{:>8}{:>6}{:>8} {:>8}{:>9}{:>9}{:>9}\n",
             "family", "values", "run", "pairs", "broken", "wrong", "undec", "failed", "cap",
             "bounds", "error", "relative", "witness", "width");
  each([](const Row& row) {
    fmt::print("{:>8}{:>6}{:>6}{:>8}{:>6}{:>8} {:>8.3g}{:>9.1e}{:>9.3g}{:>9.3g}\n",
               row.counts[Row::broken], row.counts[Row::wrong], row.counts[Row::undecided],
               row.counts[Row::failed], row.counts[Row::capped], row.counts[Row::bounds],
               row.most.distance, row.most.relative, row.most.witness, row.most.width);
  });
  fmt::print("\n{:<15}{:<8}{:<16}{:>9}{:>9}{:>9}{:>10}{:>8}{:>8}{:>8}   shares in %\n", "family",
             "values", "run", "pairs", "overlap", "settled", "repeated", "inside", "zero d",
             "no prog");
  each([](const Row& row) {
    const auto share = [&](long count) {
      return 100 * static_cast<double>(count) / static_cast<double>(row.counts[Row::pairs]);
    };
    const auto stop = [&](gjk::StopReason reason) {
      return share(row.stops[static_cast<std::size_t>(reason)]);
    };
    using gjk::StopReason;
    fmt::print("{:>9.2f}{:>9.2f}{:>10.2f}{:>8.2f}{:>8.2f}{:>8.2f}\n",
               share(row.counts[Row::overlaps]), share(row.counts[Row::settled]),
               stop(StopReason::repeated_support), stop(StopReason::origin_inside),
               stop(StopReason::zero_direction),
               stop(StopReason::not_nearer) + stop(StopReason::no_progress));
  });
}

/// Prints the failures that were kept; returns how many claims break a bar.
long print_failures(const std::vector<Job>& jobs) {
  long broken = 0;
  for (const Job& job : jobs) {
    for (std::size_t mode = 0; mode < job.rows.size(); ++mode) {
      broken += job.rows[mode].counts[Row::broken];
      for (const Failure& failure : job.rows[mode].failures) {
        fmt::print("\n{} in {}: {}\n", kFamilyNames[static_cast<int>(job.family)], kModeNames[mode],
                   failure.text);
      }
    }
  }
  fmt::print("\n{} of the claims break a bar\n", broken);
  return broken;
}

std::vector<Job> jobs_of(int dimension, const std::vector<std::string>& names) {
  std::vector<Job> jobs;
  const int count = dimension == 2 ? families::kFamilyCount : families::kSpaceFamilyCount;
  for (int family = 0; family < count; ++family) {
    const std::string_view name = kFamilyNames[static_cast<std::size_t>(family)];
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    for (const auto representation : {Representation::float_values, Representation::full_doubles}) {
      jobs.push_back({static_cast<families::Family>(family), representation});
    }
  }
  return jobs;
}

template <int D>
void run(std::vector<Job>& jobs, long pairs, unsigned threads, std::uint64_t seed) {
  test::in_pieces(jobs, pairs, threads, seed, [](const Job& job, const test::Piece& piece) {
    return Worker<D>({job.family, job.representation, piece}).run();
  });
}

int main_of(int argc, char** argv) {
  int dimension = 2;
  long pairs = 200000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t seed = 1;
  std::vector<std::string> names;
  CLI::App app("Holds what the core claims about random pairs against the exact truth");
  app.add_option("--dimension", dimension, "2: in the plane, 3: in space")->check(CLI::Range(2, 3));
  app.add_option("--pairs", pairs, "Pairs over all families")->check(CLI::PositiveNumber);
  app.add_option("--threads", threads, "Threads; they do not change the answer")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "Seed");
  app.add_option("--families", names, "Families; all if none is named")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>(kFamilyNames.begin(), kFamilyNames.end())));
  CLI11_PARSE(app, argc, argv);

  std::vector<Job> jobs = jobs_of(dimension, names);
  if (jobs.empty()) {
    fmt::print(stderr, "truth-sweep: no family of these is in the plane\n");
    return 2;
  }
  (dimension == 2 ? run<2> : run<3>)(jobs, pairs, threads, seed);
  print_rows(jobs);
  return print_failures(jobs) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace gjkscope::study

int main(int argc, char** argv) { return gjkscope::study::main_of(argc, argv); }
