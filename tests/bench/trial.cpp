#include "trial.hpp"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "study/truth.hpp"

namespace bench {
namespace {

using gjkscope::Quad;

/// Memory that child processes write to and their parent reads.
struct Shared {
  static constexpr std::size_t kMost = 1 << 20;
  std::size_t next;
  double answers[kMost];
};

/// The answer of a process that did not live to give it.
constexpr double kCrashed = -2.0;

/// Another process asks all queries. One that crashes, or runs for ever, costs the answer to its
/// query only: the next process goes on after it.
std::vector<double> ask(const Contestant& contestant, std::size_t count) {
  void* memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED || count > Shared::kMost) throw std::runtime_error("too many pairs");
  auto& shared = *static_cast<Shared*>(memory);
  std::fill_n(shared.answers, count, kCrashed);
  while (shared.next < count) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start another process");
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
      while (shared.next < count) {
        const itimerval limit = {{0, 0}, {kSecondsPerQuery, 0}};
        setitimer(ITIMER_VIRTUAL, &limit, nullptr);
        const std::size_t i = shared.next++;
        shared.answers[i] = contestant.answer(i);
      }
      _exit(0);
    }
    waitpid(child, nullptr, 0);
  }
  const std::vector<double> out(shared.answers, shared.answers + count);
  munmap(memory, sizeof(Shared));
  return out;
}

template <int D>
void count(const Library<D>& library, const Case<D>& one, double answer, Tally& tally) {
  const bool in_double = library.in_double;
  const double unit_roundoff = in_double ? 0x1p-53 : 0x1p-24;
  const double smallest = in_double ? std::numeric_limits<double>::denorm_min()
                                    : std::numeric_limits<float>::denorm_min();
  const double limit = in_double ? kDoubleLimit : kFloatLimit;
  const double error = std::abs(difference(Quad(answer), one.truth));
  const auto is_neighbour = [&] {  // `error` is rounded, which matters among denormal numbers
    const Quad off = Quad(answer) - Quad(one.truth.distance) - one.truth.rest;
    return -Quad(smallest) < off && off < Quad(smallest);
  };
  ++tally.asked;
  if (answer == kCrashed) {
    ++tally.crashed;
  } else if (answer == kGaveUp) {
    ++tally.gave_up;
  } else if (!std::isfinite(answer)) {
    ++tally.not_finite;
  } else if (one.truth.overlap) {
    const bool close =
        library.measures ? answer <= 4 * unit_roundoff * one.truth.scale : one.truth.touching;
    if (answer > 0.0 && !close) ++tally.missed;
  } else if (is_neighbour()) {
    // Its numbers are not spaced more closely.
  } else if (answer == 0.0) {
    ++tally.invented;
  } else if (library.measures) {
    const double relative = error / one.truth.distance;
    if (relative > limit) ++tally.inaccurate;
    tally.worst = std::max(tally.worst, relative);
  }
}

}  // namespace

template <int D>
std::vector<Case<D>> cases_of(families::Family family, families::Representation representation,
                              std::size_t count, std::uint64_t seed) {
  families::Source source(seed + static_cast<std::uint64_t>(family));
  std::vector<Case<D>> out(count);
  for (Case<D>& one : out) {
    one.pair = source.pair<double, D>(family, representation);
    one.truth = truth_of(one.pair);
  }
  return out;
}

template <int D>
Tally tally(const Library<D>& library, const std::vector<Case<D>>& cases) {
  std::vector<Pair<D>> pairs;
  std::vector<const Case<D>*> asked;
  for (const Case<D>& one : cases) {
    if (!fits(library, one.pair)) continue;
    asked.push_back(&one);
    pairs.push_back(one.pair);
  }
  const std::vector<double> answers = ask(library.prepare(pairs), pairs.size());
  Tally out;
  for (std::size_t i = 0; i < asked.size(); ++i) count(library, *asked[i], answers[i], out);
  return out;
}

template std::vector<Case<2>> cases_of(families::Family, families::Representation, std::size_t,
                                       std::uint64_t);
template std::vector<Case<3>> cases_of(families::Family, families::Representation, std::size_t,
                                       std::uint64_t);
template Tally tally(const Library<2>&, const std::vector<Case<2>>&);
template Tally tally(const Library<3>&, const std::vector<Case<3>>&);

}  // namespace bench
