// Penetration depth in space beside other libraries, on the same pairs: failures on all families of
// depth-sweep by the exact truth, each library in a process of its own, and time on plain overlaps.
// It reports; nothing fails when a target is missed. `--write` puts the report into a document.

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <stdexcept>

#include "depth/pairs_in_space.hpp"
#include "depths.hpp"
#include "document.hpp"
#include "study/accuracy.hpp"
#include "study/interleave.hpp"

namespace {

using namespace bench;
using namespace gjkscope::study;

constexpr std::uint64_t kSeed = 20101013;
constexpr std::array kTolerances = {1e-6L, 1e-3L};  ///< Lengths may be off so much, times scale.

/// The core comes first.
std::vector<DepthLibrary> libraries() {
  std::vector<DepthLibrary> out = core_depths();
  [[maybe_unused]] const auto add = [&](const std::vector<DepthLibrary>& peers) {
    out.insert(out.end(), peers.begin(), peers.end());
  };
#ifdef GJKSCOPE_CCD
  add(ccd_depths());
#endif
#ifdef GJKSCOPE_FCL
  add(fcl_depths());
#endif
#ifdef GJKSCOPE_BULLET
  add(bullet_depths());
#endif
  return out;
}

/// How an answer fails: the process dies, or what it says is not so.
enum class Fault : std::uint8_t { none, hung, crashed, no_answer, nan, depth, translation, kCount };
constexpr std::array kFaultNames = {"",      "hung",       "crashed", "no answer", "not a number",
                                    "depth", "translation"};

struct Reply {
  Depth depth;
  Fault died = Fault::none;
};

/// Asks a library about each pair in a child process. A pair on which it dies, or takes 0.2 s of
/// the processor's time, costs that answer alone: another child goes on with the next.
std::vector<Reply> ask(const DepthLibrary& library, std::span<const Pair<3>> pairs) {
  struct Shared {
    std::size_t at;
    Reply reply;
  };
  void* const memory = mmap(nullptr, pairs.size() * sizeof(Shared), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory to share");
  auto* const shared = static_cast<Shared*>(memory);
  for (std::size_t begin = 0; begin < pairs.size();) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
      for (shared->at = begin; shared->at < pairs.size(); ++shared->at) {
        const itimerval patience = {{0, 0}, {0, 200000}};
        setitimer(ITIMER_VIRTUAL, &patience, nullptr);
        shared[shared->at].reply = {library.prepare(pairs.subspan(shared->at, 1))(0)};
      }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (shared->at == pairs.size()) break;
    const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM;
    shared[shared->at].reply.died = hung ? Fault::hung : Fault::crashed;
    begin = shared->at + 1;
  }
  std::vector<Reply> out;
  for (std::size_t i = 0; i < pairs.size(); ++i) out.push_back(shared[i].reply);
  munmap(memory, pairs.size() * sizeof(Shared));
  return out;
}

using LongPoint = Eigen::Matrix<long double, 3, 1>;

/// The truth of a pair that meets, and its vertices as seen from one of X.
struct Known {
  long double depth = 0;
  long double scale = 0;
  std::vector<LongPoint> x;
  std::vector<LongPoint> y;

  explicit Known(const test::space::Truth& truth) : scale(truth.scale) {
    // The root of twice the digits has all those of a long double.
    const mpz_class square = (truth.depth_sq.get_num() << 256) / truth.depth_sq.get_den();
    depth = truth.from_grid(mpq_class(sqrt(square), mpz_class(1) << 128));
    const auto seen = [&](const test::space::ExactPoint& p) {
      const test::space::ExactPoint from_x = test::space::minus(p, truth.x.points[0]);
      return LongPoint(truth.from_grid(from_x[0]), truth.from_grid(from_x[1]),
                       truth.from_grid(from_x[2]));
    };
    for (const auto& p : truth.x.points) x.push_back(seen(p));
    for (const auto& p : truth.y.points) y.push_back(seen(p));
  }
  /// How far X must go along d, of length 1, to be parted from Y.
  [[nodiscard]] long double overlap_along(const LongPoint& d) const {
    long double most_x = -INFINITY;
    long double least_y = INFINITY;
    for (const LongPoint& p : x) most_x = std::max(most_x, -d.dot(p));
    for (const LongPoint& p : y) least_y = std::min(least_y, -d.dot(p));
    return most_x - least_y;
  }
};

/// An answer that there is no depth, or none to give, moves nothing: it is right where the depth
/// is within the tolerance.
Fault judge(const Reply& reply, const Known& known, long double tolerance) {
  if (reply.died != Fault::none) return reply.died;
  const long double room =
      std::max<long double>(tolerance * known.scale, 4 * std::numeric_limits<double>::denorm_min());
  const Depth& found = reply.depth;
  if (!found.overlaps) return known.depth <= room ? Fault::none : Fault::no_answer;
  if (std::isnan(found.depth) || found.translation.hasNaN()) return Fault::nan;
  if (!(std::abs(found.depth - known.depth) <= room)) return Fault::depth;
  const LongPoint t = found.translation.cast<long double>();
  const long double length = t.norm();
  long double rest = known.depth + length;  // whichever way it went
  if (length > 0) rest = std::min(rest, known.overlap_along(t / length) - length);
  return rest <= room ? Fault::none : Fault::translation;
}

using Counts = std::array<int, static_cast<std::size_t>(Fault::kCount)>;

/// Asks all libraries about `count` pairs of each family, half of them of floats.
void report_failures(Report& report, int count, const std::vector<DepthLibrary>& all) {
  using families::Representation;
  using test::space::DepthFamily;
  std::vector<std::array<Counts, kTolerances.size()>> totals(all.size());
  int pairs_in_all = 0;
  report.print("### In space: depths that are wrong by more than 1e-6 scale, by family\n\n");
  report.print("| family | pairs | touching |");
  for (const DepthLibrary& library : all) report.print(" {} |", library.name);
  report.print("\n| --- | --- | --- |");
  for (std::size_t i = 0; i < all.size(); ++i) report.print(" --- |");
  report.print("\n");
  for (int number = 0; number < test::space::kDepthFamilyCount; ++number) {
    const auto family = static_cast<DepthFamily>(number);
    families::Source source(kSeed + static_cast<std::uint64_t>(number));
    std::vector<Pair<3>> pairs;
    std::vector<Known> known;
    int touching = 0;
    while (static_cast<int>(pairs.size()) < count) {
      const bool floats = pairs.size() % 2 == 0 && family != DepthFamily::extreme;
      const Pair<3> pair = test::space::meeting_pair(
          source, family, floats ? Representation::float_values : Representation::full_doubles);
      const test::space::Truth truth = test::space::truth_of(pair);
      if (truth.verdict == gjk::Verdict::separated) continue;
      touching += truth.verdict == gjk::Verdict::touching;
      pairs.push_back(pair);
      known.emplace_back(truth);
    }
    pairs_in_all += count;
    report.print("| {} | {} | {} |", test::space::name_of(family), count, touching);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<Reply> replies = ask(all[i], pairs);
      int failed = 0;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        for (std::size_t t = 0; t < kTolerances.size(); ++t) {
          const Fault fault = judge(replies[k], known[k], kTolerances[t]);
          ++totals[i][t][static_cast<std::size_t>(fault)];
          failed += t == 0 && fault != Fault::none;
        }
      }
      report.print(" {} |", failed == 0 ? "." : std::to_string(failed));
    }
    report.print("\n");
  }
  report.print("\nOf {} pairs in all:\n\n| library | scalar | tolerance |", pairs_in_all);
  for (std::size_t f = 1; f < kFaultNames.size(); ++f) report.print(" {} |", kFaultNames[f]);
  report.print(" failures |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t t = 0; t < kTolerances.size(); ++t) {
      const Counts& counts = totals[i][t];
      report.print("| {} | {} | {:.0e} |", all[i].name, all[i].in_double ? "double" : "float",
                   static_cast<double>(kTolerances[t]));
      for (std::size_t f = 1; f < counts.size(); ++f) report.print(" {} |", counts[f]);
      report.print(" {} |\n", pairs_in_all - counts[0]);
    }
  }
  report.print("\n");
}

/// The share of overlaps on which a library is right, and the core's time as a share of its.
void time_cell(Report& report, int vertices, const Spacing& spacing, std::size_t count,
               std::size_t repetitions, const std::vector<DepthLibrary>& all) {
  const std::vector<Pair<3>> pairs = PairSource<3>(kSeed).pairs(count, vertices, spacing);
  // The truth takes time in the fourth power of vertices.
  const std::size_t judged = std::min(count, 512 / static_cast<std::size_t>(vertices));
  std::vector<Known> known;
  for (std::size_t k = 0; k < judged; ++k) known.emplace_back(test::space::truth_of(pairs[k]));
  std::vector<std::size_t> right;
  std::vector<bool> lives;
  std::vector<Contestant> contestants;
  for (const DepthLibrary& library : all) {
    const std::vector<Reply> replies = ask(library, pairs);
    lives.push_back(std::all_of(replies.begin(), replies.end(),
                                [](const Reply& reply) { return reply.died == Fault::none; }));
    right.push_back(0);
    for (std::size_t k = 0; k < judged; ++k) {
      const long double tolerance = kTolerances[library.in_double ? 0 : 1];
      right.back() += judge(replies[k], known[k], tolerance) == Fault::none;
    }
    contestants.push_back(contestant(lives.back() ? count : 0, library.prepare(pairs),
                                     [](const Depth& depth) { return depth.depth; }));
  }
  const std::vector<Timing> timings = interleave(contestants, count, repetitions);
  const auto least = [](const Timing& timing) { return *std::ranges::min_element(timing.ns); };
  report.print("| {} | {} |", vertices, spacing.name);
  double of_fastest = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!lives[i]) {
      report.print(" died |");
      continue;
    }
    const double share = least(timings[0]) / least(timings[i]);
    report.print(" {:.1f}: {:.2f}, {}/{} |", least(timings[i]) / 1e3, share, right[i], judged);
    const bool is_peer = !all[i].name.starts_with("gjkscope");
    if (is_peer && right[i] == judged) of_fastest = std::max(of_fastest, share);
  }
  if (of_fastest > 0.0) {
    report.print(" {:.2f}: {} |\n", of_fastest, of_fastest <= 1.2 ? "ok" : "FAIL");
  } else {
    report.print(" none is right |\n");
  }
}

struct Asked {
  int pairs = 300;
  std::size_t timed = 256;
  std::size_t repetitions = 21;
  std::string document;
};

void run(const Asked& asked) {
  Report report;
  const std::vector<DepthLibrary> all = libraries();
  const Machine machine = this_machine();
  report.print(
      "\nMade by `depth-compare --pairs {} --timed {} --repetitions {} --write docs/numerics.md`, "
      "one thread, {},\n`{}`. A library from a distribution is as that compiled it (Debian: -O2)."
      "\n\n",
      asked.pairs, asked.timed, asked.repetitions, machine.compiler, machine.flags);
  for (const DepthLibrary& library : all) {
    report.print("- {}, in {}: {}\n", library.name, library.in_double ? "double" : "float",
                 library.how);
  }
  report.print("\n");
  report_failures(report, asked.pairs, all);
  report.print(
      "### In space: time of depths\n\nA cell has the least time of a query in µs, gjkscope's time "
      "as a share of it, and how many answers are right of those that were judged.\n\n"
      "| vertices | overlap |");
  for (const DepthLibrary& library : all) report.print(" {} |", library.name);
  report.print(" {} / the fastest that is right |\n| --- | --- | --- |", all[0].name);
  for (std::size_t i = 0; i < all.size(); ++i) report.print(" --- |");
  report.print("\n");
  for (const int vertices : {8, 32, 128}) {
    for (const Spacing& spacing : {Spacing{"deep", -0.2}, Spacing{"shallow", -1.2}}) {
      time_cell(report, vertices, spacing, asked.timed, asked.repetitions, all);
    }
  }
  report.print("\n");
  if (!asked.document.empty()) write_section(asked.document, "depth-compare", report.text());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares penetration depth in space with other libraries");
  Asked asked;
  app.add_option("--pairs", asked.pairs, "pairs of a family")->check(CLI::PositiveNumber);
  app.add_option("--timed", asked.timed, "pairs that are timed")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", asked.repetitions, "repetitions of a time")
      ->check(CLI::PositiveNumber);
  app.add_option("--write", asked.document, "document whose marked section gets the report");
  CLI11_PARSE(app, argc, argv);
  try {
    run(asked);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "depth-compare: {}\n", problem.what());
    return 1;
  }
  return 0;
}
