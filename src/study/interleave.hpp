#pragma once
// Times several ways of doing the same work against each other. Repetitions are interleaved, so
// that whatever else the machine does slows all contestants alike, and ratios are taken within a
// repetition, before any median.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

namespace gjkscope::study {

/// Makes the compiler believe that all of `value` is read.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// One way of doing the work, on data that were prepared beforehand.
struct Contestant {
  /// Answers every query once. Returns the sum of the answers, by which a contestant that does
  /// other work than the rest is found out.
  std::function<double()> sweep;
  std::function<double(std::size_t)> answer;  ///< To one query.
};

/// A contestant that calls `query(0)` ... `query(count - 1)`; `read` makes a number of what they
/// return.
template <class Query, class Read>
[[nodiscard]] Contestant contestant(std::size_t count, Query query, Read read) {
  const auto answer = [=](std::size_t i) { return static_cast<double>(read(query(i))); };
  const auto sweep = [=] {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto result = query(i);
      keep(result);
      sum += static_cast<double>(read(result));
    }
    return sum;
  };
  return {sweep, answer};
}

struct Quartiles {
  double low = 0.0;
  double median = 0.0;
  double high = 0.0;
};
/// Needs at least one value.
[[nodiscard]] inline Quartiles quartiles(std::vector<double> values) {
  const auto rank = [&](double share) {
    const auto at = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return {rank(0.25), rank(0.5), rank(0.75)};
}

struct Timing {
  double sum = 0.0;        ///< The sum of the distances.
  std::vector<double> ns;  ///< Per query; one value a repetition.
};
/// How long `a` took as a share of `b`, repetition by repetition.
[[nodiscard]] inline Quartiles ratio(const Timing& a, const Timing& b) {
  std::vector<double> ratios(a.ns.size());
  std::transform(a.ns.begin(), a.ns.end(), b.ns.begin(), ratios.begin(), std::divides<>());
  return quartiles(std::move(ratios));
}

/// Runs all contestants `repetitions` times, in another order each time: caches and branch
/// predictors remember the contestant before, so none should always follow one that did the same
/// work. With `least_seconds`, a contestant repeats its sweep in a turn until these are over, after
/// one sweep that is not timed. When `go_on` says no before a turn, only complete repetitions are
/// returned.
[[nodiscard]] inline std::vector<Timing> interleave(
    const std::vector<Contestant>& contestants, std::size_t queries, std::size_t repetitions,
    const std::function<bool()>& go_on = [] { return true; }, double least_seconds = 0.0) {
  using Clock = std::chrono::steady_clock;
  std::vector<Timing> timings;
  std::vector<int> sweeps;
  for (const Contestant& each : contestants) {
    timings.push_back({go_on() ? each.sweep() : 0.0, {}});
    sweeps.push_back(1);
    if (least_seconds <= 0.0 || !go_on()) continue;
    constexpr int kMostSweeps = 10000;
    const Clock::time_point begin = Clock::now();
    keep(each.sweep());
    const std::chrono::duration<double> once = Clock::now() - begin;
    while (sweeps.back() < kMostSweeps && sweeps.back() * once.count() < least_seconds) {
      sweeps.back() *= 2;
    }
  }
  std::vector<std::size_t> order(contestants.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 chance;
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), chance);
    for (const std::size_t i : order) {
      if (!go_on()) {
        for (Timing& timing : timings) timing.ns.resize(repetition);
        return timings;
      }
      const int count = sweeps[i];
      if (least_seconds > 0.0) keep(contestants[i].sweep());
      const Clock::time_point begin = Clock::now();
      for (int sweep = 0; sweep < count; ++sweep) keep(contestants[i].sweep());
      const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
      timings[i].ns.push_back(taken.count() / static_cast<double>(queries) / count);
    }
  }
  return timings;
}

}  // namespace gjkscope::study
