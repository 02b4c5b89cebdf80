#pragma once
// Runs in every arithmetic: all of them are gjk::distance and nothing else. One source file for
// each group of them, since each takes the compiler its time.

#include <algorithm>
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

/// The same pairs in S, and queries about them. Shapes are measured here: not where runs are timed.
template <class S>
struct Kept {
  std::vector<families::Pair<S>> pairs;
  std::vector<gjk::MeasuredShape<S, 2>> shapes;  ///< X and Y of each pair.
  std::vector<gjk::Query<S, 2>> queries;

  explicit Kept(const std::vector<DoublePair>& given) {
    shapes.reserve(2 * given.size());
    for (const DoublePair& pair : given) {
      pairs.push_back(families::converted<S>(pair));
      const gjk::MeasuredShape<S, 2>& x = shapes.emplace_back(pairs.back().x);
      const gjk::MeasuredShape<S, 2>& y = shapes.emplace_back(pairs.back().y);
      queries.push_back({{x, pairs.back().x_pose}, {y, pairs.back().y_pose}});
    }
  }
  Kept(const Kept&) = delete;  // the queries borrow the shapes
  Kept& operator=(const Kept&) = delete;
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

/// How often a run looked for a support point, counted from above: the start between the centers is
/// one search, and each iteration has one unless the run is known to have ended before it.
template <class Result>
[[nodiscard]] int support_queries(const Result& result, const gjk::Options& options) {
  const bool ended_before = result.stop == gjk::StopReason::origin_inside ||
                            result.stop == gjk::StopReason::zero_direction;
  return result.iterations - (ended_before ? 1 : 0) + (options.start.count == 0 ? 1 : 0);
}

/// For a result in a scalar that rounds.
template <class Result>
[[nodiscard]] Answer answer_of(const Result& result, const gjk::Options& options) {
  Answer out;
  out.refused = result.error != gjk::Error::none;
  out.verdict = result.verdict;
  out.has_bounds = options.proof != gjk::Proof::none;
  out.distance = widened(result.distance);
  if (out.has_bounds) {
    out.lower = widened(result.lower);
    out.upper = widened(result.upper);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    out.x[i] = widened(result.x[k]);
    out.y[i] = widened(result.y[k]);
  }
  out.near = result.warm();
  out.iterations = result.iterations;
  out.support_queries = support_queries(result, options);
  out.start_vertices = std::max(options.start.count, 1);
  out.settled = result.settled;
  return out;
}

/// `run(query, options)` for all of the queries, the start of each as the configuration has it.
template <class S, class Run>
[[nodiscard]] Asked asked(const Configuration& configuration, const Family& family, Run run) {
  const auto kept = std::make_shared<const Kept<S>>(family.pairs);
  const auto options = std::make_shared<gjk::Options>(configuration.options);
  options->start.count = configuration.start == Start::first_vertices ? 1 : 0;
  const bool is_warm = configuration.start == Start::warm;
  const auto query = [=](std::size_t i) {
    if (!is_warm) return run(kept->queries[i], *options);
    if (i == 0) options->start.count = 0;
    auto result = run(kept->queries[i], *options);
    options->start = result.warm();
    return result;
  };
  Asked out;
  for (std::size_t i = 0; i < kept->pairs.size(); ++i) {
    if constexpr (!std::is_same_v<S, double>) {
      out.kept.push_back(families::converted<double>(kept->pairs[i]));
    }
    gjk::Options before = *options;
    if (is_warm && i == 0) before.start.count = 0;
    out.answers.push_back(answer_of(query(i), before));
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
