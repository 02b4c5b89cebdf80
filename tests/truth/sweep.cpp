// Runs the core on random pairs of every family and holds what it claims against the exact truth.
// Exit code 1 when a bar is broken; then some pairs that break it are printed as cases for
// `gjkscope solve`. Cases have no poses: where there are any, a_pose and b_pose tell them, rotation
// row by row, then translation.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <mutex>
#include <thread>

#include "claim.hpp"
#include "study/families.hpp"

namespace truth {
namespace {

using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using families::Pair;
using families::Representation;

/// A scalar of the query and one of the run.
enum class Mode { in_double, float_in_double, in_float };
constexpr std::array<const char*, 3> kModeNames = {"double", "float in double", "float"};

/// The most that a judgement may show. Errors of distance, witnesses and bounds are in u * scale.
struct Bars {
  double distance = 4;
  double relative = std::numeric_limits<double>::infinity();
  double witness = 4;
  double width = std::numeric_limits<double>::infinity();
  bool refusal = false;  ///< A named error is an answer, too.
};
Bars bars_of(Family family, Representation representation, Mode mode) {
  Bars bars;
  bars.refusal = family == Family::denormals;
  if (mode == Mode::in_float) return bars;
  bars.width = 16;
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

/// The first bar that is broken, or nullptr.
const char* broken_bar(const Judgement& found, const Bars& bars) {
  if (found.refused) return bars.refusal ? nullptr : "refused";
  if (found.not_a_number) return "not a number";
  if (found.wrong_verdict) return "wrong verdict";
  if (found.undecided) return "undecided";
  if (found.capped) return "iteration cap";
  if (found.broken_certificate) return "certificate";
  if (!(found.distance_error <= bars.distance)) return "distance";
  if (!(found.relative_error <= bars.relative)) return "relative error";
  if (!(found.outside <= bars.witness)) return "witness outside its shape";
  if (!(found.apart <= bars.witness)) return "witnesses not the distance apart";
  if (!(found.width <= bars.width)) return "width of the bounds";
  return nullptr;
}

struct Failure {
  std::string text;
  long pair = 0;
};

/// What became of the pairs of one family, one representation and one mode.
struct Row {
  static constexpr std::size_t kKept = 2;  ///< Failures to be shown.

  long pairs = 0;
  long refused = 0;
  long not_a_number = 0;
  long wrong = 0;
  long undecided = 0;
  long capped = 0;
  long certificates = 0;
  long broken = 0;
  long settled = 0;
  long overlaps = 0;
  Judgement most;  ///< The largest of each error.
  std::array<long, 8> stops = {};
  std::vector<Failure> failures;

  void add(const Judgement& found) {
    ++pairs;
    refused += found.refused;
    not_a_number += found.not_a_number;
    wrong += found.wrong_verdict;
    undecided += found.undecided;
    capped += found.capped;
    certificates += found.broken_certificate;
    widen(found);
  }
  void widen(const Judgement& other) {
    most.distance_error = std::max(most.distance_error, other.distance_error);
    most.relative_error = std::max(most.relative_error, other.relative_error);
    most.outside = std::max(most.outside, other.outside);
    most.apart = std::max(most.apart, other.apart);
    most.width = std::max(most.width, other.width);
  }
  void add(const Row& other) {
    pairs += other.pairs;
    refused += other.refused;
    not_a_number += other.not_a_number;
    wrong += other.wrong;
    undecided += other.undecided;
    capped += other.capped;
    certificates += other.certificates;
    broken += other.broken;
    settled += other.settled;
    overlaps += other.overlaps;
    widen(other.most);
    for (std::size_t i = 0; i < stops.size(); ++i) stops[i] += other.stops[i];
    failures.insert(failures.end(), other.failures.begin(), other.failures.end());
    std::sort(failures.begin(), failures.end(),
              [](const Failure& a, const Failure& b) { return a.pair < b.pair; });
    if (failures.size() > kKept) failures.resize(kKept);
  }
};
using Rows = std::array<Row, 3>;  ///< One for each mode.

std::string json_of(const std::vector<Eigen::Vector2d>& points) {
  std::string out;
  for (const Eigen::Vector2d& p : points) {
    out += fmt::format("{}[\"{:a}\",\"{:a}\"]", out.empty() ? "" : ",", p[0], p[1]);
  }
  return "[" + out + "]";
}
std::string json_of(const gjk::Pose<double, 2>& pose) {
  return fmt::format("[\"{:a}\",\"{:a}\",\"{:a}\",\"{:a}\",\"{:a}\",\"{:a}\"]", pose.rotation(0, 0),
                     pose.rotation(0, 1), pose.rotation(1, 0), pose.rotation(1, 1),
                     pose.translation[0], pose.translation[1]);
}
std::string json_of(const Pair<double>& pair, const std::string& name) {
  std::string poses;
  if (pair.x_pose.rotation.turns() || pair.y_pose.rotation.turns()) {
    poses = fmt::format(R"(,"a_pose":{},"b_pose":{})", json_of(pair.x_pose), json_of(pair.y_pose));
  }
  return fmt::format(R"({{"name":"{}","dimension":2,"a":{},"b":{}{}}})", name, json_of(pair.x),
                     json_of(pair.y), poses);
}

struct Work {
  Family family = Family::random;
  Representation representation = Representation::full_doubles;
  std::uint64_t seed = 0;
  long pairs = 0;
};

/// Every so many pairs, one is tried in both orders of arguments and all rotations of its lists.
constexpr long kAllOrdersEvery = 16;

class Worker {
 public:
  explicit Worker(const Work& work) : work_(work), random_(work.seed) {}

  Rows run() {
    while (done_ < work_.pairs) {
      const Pair<double> pair = random_.pair<double>(work_.family, work_.representation);
      if (drawn_++ % kAllOrdersEvery != 0) {
        check(pair);
        continue;
      }
      const std::size_t rotations = std::max(pair.x.size(), pair.y.size());
      for (std::size_t i = 0; i < rotations; ++i) {
        const Pair<double> rotated = families::rotated(pair, i, i);
        check(rotated);
        check(families::swapped(rotated));
      }
    }
    return std::move(rows_);
  }

 private:
  void check(const Pair<double>& pair) {
    if (done_ == work_.pairs) return;
    const auto query = pair.query();
    const ExactPair exact(query);
    const gjk::Result<double, 2> result = families::run<double>(pair);
    std::array<gjk::VertexPair, 3> guess;
    for (int i = 0; i < result.simplex.count; ++i) guess[i] = result.simplex.vertices[i].pair;
    truth_ = exact.truth(std::span(guess).first(static_cast<std::size_t>(result.simplex.count)));
    scale_ = exact.scale();
    judge(exact, pair, result, Mode::in_double);
    if (work_.representation == Representation::float_values) {
      const Pair<float> narrow = families::converted<float>(pair);
      judge(exact, pair, families::run<double>(narrow), Mode::float_in_double);
      judge(exact, pair, families::run<float>(narrow), Mode::in_float);
    }
    ++done_;
  }

  template <class R>
  void judge(const ExactPair& exact, const Pair<double>& pair, const gjk::Result<R, 2>& result,
             Mode mode) {
    const Judgement found = truth::judge(exact, truth_, scale_, claim_of(result));
    Row& row = rows_[static_cast<std::size_t>(mode)];
    row.add(found);
    row.overlaps += truth_.overlap;
    ++row.stops[static_cast<std::size_t>(result.stop)];
    if constexpr (requires { result.settled; }) row.settled += result.settled;
    const char* broken = broken_bar(found, bars_of(work_.family, work_.representation, mode));
    if (broken == nullptr) return;
    ++row.broken;
    if (row.failures.size() < Row::kKept) {
      row.failures.push_back(
          {fmt::format("{}: exact {:.17g}, found {:.17g} in [{:.17g}, {:.17g}]\n  {}", broken,
                       static_cast<double>(truth_.distance), double{result.distance},
                       double{result.lower}, double{result.upper},
                       json_of(pair, fmt::format("{}, seed {}, pair {}",
                                                 kFamilyNames[static_cast<int>(work_.family)],
                                                 work_.seed, done_))),
           done_});
    }
  }

  Work work_;
  families::Source random_;
  long drawn_ = 0;
  long done_ = 0;
  Truth truth_;
  long double scale_ = 0;
  Rows rows_;
};

struct Job {
  Family family;
  Representation representation;
  Rows rows = {};
};

void print_rows(const std::vector<Job>& jobs) {
  fmt::print(
      "{:<15}{:<8}{:<16}{:>9}{:>8}{:>6}{:>6}{:>6}{:>6}{:>8}{:>8} {:>8}{:>9}{:>8}{:>8}{:>9}\n",
      "family", "values", "run", "pairs", "broken", "wrong", "undec", "nan", "cap", "refused",
      "bounds", "error", "relative", "outside", "apart", "width");
  const auto each = [&](auto print) {
    for (const Job& job : jobs) {
      for (std::size_t mode = 0; mode < job.rows.size(); ++mode) {
        const Row& row = job.rows[mode];
        if (row.pairs == 0) continue;
        fmt::print("{:<15}{:<8}{:<16}{:>9}", kFamilyNames[static_cast<int>(job.family)],
                   job.representation == Representation::float_values ? "float" : "double",
                   kModeNames[mode], row.pairs);
        print(row);
      }
    }
  };
  each([](const Row& row) {
    fmt::print("{:>8}{:>6}{:>6}{:>6}{:>6}{:>8}{:>8} {:>8.3g}{:>9.1e}{:>8.3g}{:>8.3g}{:>9.3g}\n",
               row.broken, row.wrong, row.undecided, row.not_a_number, row.capped, row.refused,
               row.certificates, row.most.distance_error, row.most.relative_error, row.most.outside,
               row.most.apart, row.most.width);
  });
  fmt::print("\n{:<15}{:<8}{:<16}{:>9}{:>9}{:>9}{:>10}{:>8}{:>8}{:>8}   shares in %\n", "family",
             "values", "run", "pairs", "overlap", "settled", "repeated", "inside", "zero d",
             "no prog");
  each([](const Row& row) {
    const auto share = [&](long count) {
      return 100 * static_cast<double>(count) / static_cast<double>(row.pairs);
    };
    const auto stop = [&](gjk::StopReason reason) {
      return share(row.stops[static_cast<std::size_t>(reason)]);
    };
    using gjk::StopReason;
    fmt::print("{:>9.2f}{:>9.2f}{:>10.2f}{:>8.2f}{:>8.2f}{:>8.2f}\n", share(row.overlaps),
               share(row.settled), stop(StopReason::repeated_support),
               stop(StopReason::origin_inside), stop(StopReason::zero_direction),
               stop(StopReason::no_progress));
  });
}

int main_of(int argc, char** argv) {
  long pairs = 200000;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t seed = 1;
  std::vector<std::string> names;
  CLI::App app("Holds what the core claims about random pairs against the exact truth");
  app.add_option("--pairs", pairs, "Pairs over all families")->check(CLI::PositiveNumber);
  app.add_option("--threads", threads, "Threads; they do not change the answer")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "Seed");
  app.add_option("--families", names, "Families; all if none is named")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<std::string>(kFamilyNames.begin(), kFamilyNames.end())));
  CLI11_PARSE(app, argc, argv);

  std::vector<Job> jobs;
  for (int family = 0; family < kFamilyCount; ++family) {
    if (!names.empty() &&
        std::find(names.begin(), names.end(), kFamilyNames[family]) == names.end())
      continue;
    for (const Representation representation :
         {Representation::float_values, Representation::full_doubles}) {
      jobs.push_back({static_cast<Family>(family), representation});
    }
  }

  // Jobs are cut into pieces with a seed each, so that the threads' number changes nothing.
  constexpr long kPiece = 2000;
  const long job_count = static_cast<long>(jobs.size());
  const long each = (pairs + job_count - 1) / job_count;
  const long pieces = (each + kPiece - 1) / kPiece;
  std::atomic<long> next = 0;
  std::mutex merging;
  const auto work = [&] {
    for (long i = next++; i < pieces * job_count; i = next++) {
      Job& job = jobs[static_cast<std::size_t>(i % job_count)];
      const long piece = i / job_count;
      Work part{job.family, job.representation, seed * 1000003 + static_cast<std::uint64_t>(i),
                std::min(kPiece, each - piece * kPiece)};
      Rows rows = Worker(part).run();
      const std::scoped_lock lock(merging);
      for (std::size_t mode = 0; mode < rows.size(); ++mode) {
        for (Failure& failure : rows[mode].failures) failure.pair += piece * kPiece;
        job.rows[mode].add(rows[mode]);
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();

  print_rows(jobs);
  long broken = 0;
  for (const Job& job : jobs) {
    for (std::size_t mode = 0; mode < job.rows.size(); ++mode) {
      broken += job.rows[mode].broken;
      for (const Failure& failure : job.rows[mode].failures) {
        fmt::print("\n{} in {}: {}\n", kFamilyNames[static_cast<int>(job.family)], kModeNames[mode],
                   failure.text);
      }
    }
  }
  fmt::print("\n{} of the claims break a bar\n", broken);
  return broken == 0 ? 0 : 1;
}

}  // namespace
}  // namespace truth

int main(int argc, char** argv) { return truth::main_of(argc, argv); }
