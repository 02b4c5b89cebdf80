#pragma once
// The distance between two convex shapes, by GJK, with a certificate.
//
// To understand the algorithm, read in this order: query.hpp, vector.hpp, simplex.hpp, state.hpp,
// regions.hpp, direction.hpp, support.hpp, stop.hpp, loop.hpp; record.hpp holds what each phase
// notes, trace.hpp a whole run. The folder proof keeps rounding in check; its answer.hpp makes the
// answer (result.hpp).

#include "gjk/proof/answer.hpp"
#include "gjk/trace.hpp"

namespace gjk {

namespace detail {
template <class R, class S, int D>
[[nodiscard]] Result<R, D> distance_in(const Query<S, D>& query, const Options& options) {
  const Prepared<R, D> prepared = prepare<R>(query, options);
  State<R, D> state = start(query, options, prepared);
  run(state, query, options, prepared);
  return result(state, query, options, prepared);
}
/// `distance_in` with all phases inlined. Only for numbers that processors have: with others,
/// compilers would take minutes.
template <class R, class S, int D>
[[nodiscard, gnu::flatten]] Result<R, D> distance_in_one(const Query<S, D>& query,
                                                         const Options& options) {
  return distance_in<R>(query, options);
}
}  // namespace detail

/// Distance between two convex shapes, computed in R: distance<float>(query) stays in float. A bad
/// query sets Result::error. Allocates only where exact arithmetic has to settle the answer.
template <class R = Default, class S, int D>
[[nodiscard]] Result<RunScalar<R, S>, D> distance(const Query<S, D>& query,
                                                  const Options& options = {}) {
  if constexpr (std::is_floating_point_v<RunScalar<R, S>>)
    return detail::distance_in_one<RunScalar<R, S>>(query, options);
  else
    return detail::distance_in<RunScalar<R, S>>(query, options);
}

/// The distance between two shapes, each a range of points, a Shape or a MeasuredShape.
template <class R = Default, class X, class Y>
[[nodiscard]] auto distance(const X& x, const Y& y, const Options& options = {})
    -> decltype(distance<R>(Query{Shape(x), Shape(y)}, options)) {
  return distance<R>(Query{Shape(x), Shape(y)}, options);
}

/// The run of `distance`, with every phase recorded. `before_phase` is called before each; it may
/// throw, to give up a run that takes too long.
template <class R = Default, class S, int D, class BeforePhase = void (*)()>
[[nodiscard]] Trace<RunScalar<R, S>, D> trace(
    const Query<S, D>& query, const Options& options = {},
    const BeforePhase& before_phase = [] {}) {
  Trace<RunScalar<R, S>, D> out;
  out.prepared = prepare<RunScalar<R, S>>(query, options);
  State<RunScalar<R, S>, D> state = start(query, options, out.prepared);
  out.initial = state;
  while (state.stop == StopReason::running) {
    before_phase();
    Step<RunScalar<R, S>, D> next;
    next.phase = state.phase;
    next.iteration = state.iteration;
    step(state, query, options, out.prepared, next.record);
    next.after = state;
    next.bounds = bounds_so_far(state, out.prepared);
    out.steps.push_back(std::move(next));
  }
  out.result = result(state, query, options, out.prepared);
  return out;
}

}  // namespace gjk
