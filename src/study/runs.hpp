#pragma once
// Runs in every arithmetic. One source file for each group of them, since each takes the compiler
// its time.

#include <memory>

#include "gjk/gjk.hpp"
#include "study/answer.hpp"

namespace gjkscope::study {

[[nodiscard]] Asked ask_half(const Configuration& configuration, const Family& family);
[[nodiscard]] Asked ask_float(const Configuration& configuration, const Family& family);
[[nodiscard]] Asked ask_double(const Configuration& configuration, const Family& family);
[[nodiscard]] Asked ask_wide(const Configuration& configuration, const Family& family);
[[nodiscard]] Asked ask_exact(const Configuration& configuration, const Family& family);

namespace detail {

/// The same pairs in S, wrapped once.
template <class S>
struct Kept {
  std::vector<families::Pair<S>> pairs;
  std::vector<gjk::Query<S, 2>> queries;

  explicit Kept(const std::vector<DoublePair>& given) {
    for (const DoublePair& pair : given) pairs.push_back(families::converted<S>(pair));
    for (const families::Pair<S>& pair : pairs) queries.push_back(pair.query());
  }
};

template <class S>
[[nodiscard]] Quad widened(const S& value) {
  if constexpr (std::is_same_v<S, Eigen::half>) {
    return Quad(static_cast<float>(value));
  } else if constexpr (std::is_same_v<S, Quad>) {
    return value;
  } else {
    return Quad(value);
  }
}

/// Of a result with bounds, in a scalar that rounds.
template <class Result>
[[nodiscard]] Answer answer_of(const Result& result) {
  Answer out;
  out.refused = result.error != gjk::Error::none;
  out.verdict = result.verdict;
  out.has_bounds = result.lower <= result.upper;  // not without proof: both are NaNs
  out.distance = widened(result.distance);
  out.lower = widened(result.lower);
  out.upper = widened(result.upper);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    out.x[i] = widened(result.x[k]);
    out.y[i] = widened(result.y[k]);
  }
  out.iterations = result.iterations;
  return out;
}

/// `run(query, options)` for all of the queries, the start of each as the configuration has it.
template <class S, class Run>
[[nodiscard]] Asked asked(const Configuration& configuration, const Family& family, Run run) {
  const auto kept = std::make_shared<const Kept<S>>(family.pairs);
  gjk::Options options = configuration.options;
  options.proof = configuration.effort == Effort::loop     ? gjk::Proof::none
                  : configuration.effort == Effort::bounds ? gjk::Proof::bounds
                                                           : gjk::Proof::exact;
  options.start.count = configuration.start == Start::first_vertices ? 1 : 0;
  const auto next = std::make_shared<gjk::Options>(options);
  const auto query = [=, warm = configuration.start == Start::warm](std::size_t i) {
    if (!warm) return run(kept->queries[i], *next);
    if (i == 0) next->start.count = 0;
    auto result = run(kept->queries[i], *next);
    next->start = result.warm();
    return result;
  };
  Asked out;
  for (std::size_t i = 0; i < kept->pairs.size(); ++i) {
    if constexpr (!std::is_same_v<S, double>) {
      out.kept.push_back(families::converted<double>(kept->pairs[i]));
    }
    out.answers.push_back(answer_of(query(i)));
  }
  if constexpr (std::is_same_v<S, double>) out.kept = family.pairs;
  out.contestant = contestant(kept->pairs.size(), query, [](const auto& result) {
    return static_cast<double>(result.distance);
  });
  return out;
}

/// R: the scalar of the run. S: that of the coordinates.
template <class R, class S>
[[nodiscard]] Asked ask_in(const Configuration& configuration, const Family& family) {
  return asked<S>(configuration, family, [](const auto& query, const auto& options) {
    return gjk::distance<R>(query, options);
  });
}

}  // namespace detail
}  // namespace gjkscope::study
