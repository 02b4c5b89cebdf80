#pragma once
// Times several ways of doing the same work against each other. Repetitions are interleaved, so
// that whatever else the machine does slows all contestants alike, and ratios are taken within a
// repetition, before any median.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Makes the compiler believe that all of `value` is read.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// One way of doing the work: `sweep` does all of it once and returns the sum of the distances, by
/// which contestants that did something else are found out.
struct Contestant {
  std::string name;
  std::function<double()> sweep;
};

/// A contestant that calls `query(0)` ... `query(count - 1)`; `length` reads the distance from what
/// they return.
template <class Query, class Length>
[[nodiscard]] Contestant contestant(std::string name, std::size_t count, Query query,
                                    Length length) {
  return {std::move(name), [=]() mutable {
            double sum = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
              const auto answer = query(i);
              keep(answer);
              sum += static_cast<double>(length(answer));
            }
            return sum;
          }};
}

struct Quartiles {
  double low = 0.0;
  double median = 0.0;
  double high = 0.0;
};
/// Of at least one value.
[[nodiscard]] inline Quartiles quartiles(std::vector<double> values) {
  const auto rank = [&](double share) {
    const auto at = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return {rank(0.25), rank(0.5), rank(0.75)};
}

struct Timing {
  std::string name;
  double sum = 0.0;        ///< Of the distances.
  std::vector<double> ns;  ///< Per query; one value a repetition.
};
/// How long `a` took as a share of `b`, repetition by repetition.
[[nodiscard]] inline Quartiles ratio(const Timing& a, const Timing& b) {
  std::vector<double> ratios(a.ns.size());
  std::transform(a.ns.begin(), a.ns.end(), b.ns.begin(), ratios.begin(), std::divides<>());
  return quartiles(std::move(ratios));
}

/// Runs all contestants `repetitions` times, beginning with another one each time.
[[nodiscard]] inline std::vector<Timing> interleave(const std::vector<Contestant>& contestants,
                                                    std::size_t queries, std::size_t repetitions) {
  using Clock = std::chrono::steady_clock;
  std::vector<Timing> timings;
  for (const Contestant& each : contestants) timings.push_back({each.name, each.sweep(), {}});
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t turn = 0; turn < contestants.size(); ++turn) {
      const std::size_t i = (repetition + turn) % contestants.size();
      const Clock::time_point begin = Clock::now();
      keep(contestants[i].sweep());
      const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
      timings[i].ns.push_back(taken.count() / static_cast<double>(queries));
    }
  }
  return timings;
}

}  // namespace bench
