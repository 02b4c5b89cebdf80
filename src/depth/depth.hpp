#pragma once
// How deep two convex shapes lie in each other, in the plane, with a certificate: an expanding
// polygon, from where GJK ends.
//
// To understand the algorithm, read state.hpp and loop.hpp. result.hpp says what is answered, and
// certificate.hpp keeps rounding in check.

#include "depth/certificate.hpp"
#include "gjk/gjk.hpp"

namespace depth {

/// Proved bounds of the depth at some step, in the run's unit. `upper` is no length before the
/// first support point.
template <class R>
struct Bounds {
  using Real = typename gjk::ScalarTraits<R>::Real;
  Real lower = Real(0);
  Real upper = gjk::ScalarTraits<R>::no_length();
};

/// One phase that ran: what it left, what it noted, and what is proved of the depth by then.
template <class R>
struct Step {
  Phase phase = Phase::nearest;
  int iteration = 1;
  State<R> after;
  Record<R> record;
  Bounds<R> bounds;
};

/// A whole run, and that of GJK before it. `steps` is complete for every outcome, and empty only
/// when there is nothing to expand: `result.stop` says why.
template <class R>
struct Trace {
  gjk::Trace<R, 2> gjk;
  State<R> initial;
  std::vector<Step<R>> steps;
  Result<R> result;
};

namespace detail {

/// The answer of an exact run: its last edge lies on the boundary of Z, and none is nearer.
template <class R>
void set_exact_answer(const State<R>& state, Result<R>& out) {
  using Traits = gjk::ScalarTraits<R>;
  const gjk::SupportPoint<R, 2>& a = state.polygon.corners[state.edge.from].point;
  const gjk::SupportPoint<R, 2>& b = state.polygon.corners[state.edge.to].point;
  const R n_sq = gjk::dot(state.n, state.n);
  const R share = gjk::dot(state.n, a.w) / n_sq;
  const R depth_sq = share * R(share * n_sq);
  out.verdict = depth_sq == R(0) ? gjk::Verdict::touching : gjk::Verdict::overlapping;
  out.depth = Traits::root(depth_sq);
  out.lower = Traits::root_below(depth_sq);
  out.upper = Traits::root_above(depth_sq);
  for (int i = 0; i < 2; ++i) {
    const typename Result<R>::Real size = Traits::root(state.n[i] * R(state.n[i] / n_sq));
    out.direction[i] = state.n[i] < R(0) ? -size : size;
    out.translation[i] = state.n[i] * share;
  }
  const bool is_point = state.edge.from == state.edge.to;
  out.face.count = is_point ? 1 : 2;
  out.face.vertices[0] = a;
  out.face.vertices[1] = b;
  if (!is_point) out.face.weights[1] = -gjk::dot(a.w, Vec<R, 2>(b.w - a.w)) / n_sq;
  out.face.weights[0] = R(1) - out.face.weights[1];
}

/// Those of a run that rounded.
template <class R, class S>
void set_rounded_answer(const State<R>& state, const gjk::Result<R, 2>& found,
                        const gjk::Query<S, 2>& query, const gjk::Options& options,
                        const gjk::Prepared<R, 2>& prepared, Result<R>& out) {
  using Traits = gjk::ScalarTraits<R>;
  constexpr bool kCanSettle = std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits;
  Proof<R> proof = prove(state, query, prepared);
  if constexpr (kCanSettle) {
    if (options.proof == gjk::Proof::exact && !proof.is_tight) {
      out.settled = settle(found, query, prepared, proof);
    }
  }
  out.depth = Traits::scaled(proof.depth, prepared.exponent);
  if (options.proof != gjk::Proof::none) {
    out.lower = gjk::scaled_below(proof.lower, prepared.exponent);
    out.upper = gjk::scaled_above(proof.upper, prepared.exponent);
  }
  out.direction = proof.direction + Vec<R, 2>::Zero();              // no -0
  out.translation = out.direction * out.depth + Vec<R, 2>::Zero();  // no -0
  out.face = proof.edge;
}

/// Reads the answer from the end of a run.
template <class R, class S>
[[nodiscard]] Result<R> result(const State<R>& state, const gjk::Result<R, 2>& found,
                               const gjk::Query<S, 2>& query, const gjk::Options& options,
                               const gjk::Prepared<R, 2>& prepared) {
  Result<R> out;
  out.error = found.error;
  out.stop = state.stop;
  out.verdict = found.verdict;
  if (state.polygon.count == 0) return out;
  out.iterations = state.iteration;
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    set_exact_answer(state, out);
  } else {
    set_rounded_answer(state, found, query, options, prepared, out);
  }
  out.x = gjk::witness_point(out.face, query.x, &gjk::VertexPair::x, prepared);
  out.y = gjk::witness_point(out.face, query.y, &gjk::VertexPair::y, prepared);
  if (!gjk::ScalarTraits<typename Result<R>::Real>::is_finite(out.depth) ||
      !gjk::is_finite(out.x) || !gjk::is_finite(out.y)) {
    out = {};
    out.error = gjk::Error::overflow;
    out.stop = StopReason::failed;
  }
  return out;
}

/// Improves the bounds by what the phase that ran has found: the nearest edge, or a support point.
template <class R>
void improve(Bounds<R>& bounds, Phase ran, const State<R>& state,
             const gjk::Prepared<R, 2>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  using Real = typename Traits::Real;
  if (ran == Phase::nearest) {
    Real lower = Traits::root_below(state.edge.distance_sq);
    if constexpr (!Traits::kExact) lower = lower - prepared.simplex_error();
    bounds.lower = gjk::larger(bounds.lower, lower);
  } else if (ran == Phase::support) {
    const R value = gjk::dot(state.n, state.support.w);
    Real upper = Traits::root_above(value * R(value / gjk::dot(state.n, state.n)));
    if constexpr (!Traits::kExact) {
      upper = upper + prepared.plane_error(upper, gjk::length(state.support.w));
    }
    if (!(bounds.upper <= upper)) bounds.upper = upper;
  }
}

}  // namespace detail

/// How deep two convex shapes lie in each other, computed in R as gjk::distance does. Only
/// `options.proof` matters to the polygon; the others are GJK's. Allocates.
template <class R = gjk::Default, class S>
[[nodiscard]] Result<gjk::RunScalar<R, S>> penetration(const gjk::Query<S, 2>& query,
                                                       const gjk::Options& options = {}) {
  using Run = gjk::RunScalar<R, S>;
  const gjk::Prepared<Run, 2> prepared = gjk::prepare<Run>(query, options);
  gjk::State<Run, 2> before = gjk::start(query, options, prepared);
  gjk::run(before, query, options, prepared);
  const gjk::Result<Run, 2> found = gjk::result(before, query, options, prepared);
  State<Run> state = start(query, prepared, found);
  run(state, query, prepared);
  return detail::result(state, found, query, options, prepared);
}

/// The same run, every phase recorded.
template <class R = gjk::Default, class S>
[[nodiscard]] Trace<gjk::RunScalar<R, S>> trace(const gjk::Query<S, 2>& query,
                                                const gjk::Options& options = {}) {
  using Run = gjk::RunScalar<R, S>;
  Trace<Run> out;
  out.gjk = gjk::trace<R>(query, options);
  const gjk::Prepared<Run, 2>& prepared = out.gjk.prepared;
  State<Run> state = start(query, prepared, out.gjk.result);
  out.initial = state;
  Bounds<Run> bounds;
  while (state.stop == StopReason::running) {
    Step<Run> next;
    next.phase = state.phase;
    next.iteration = state.iteration;
    step(state, query, prepared, next.record);
    next.after = state;
    detail::improve(bounds, next.phase, state, prepared);
    next.bounds = bounds;
    out.steps.push_back(std::move(next));
  }
  out.result = detail::result(state, out.gjk.result, query, options, prepared);
  return out;
}

}  // namespace depth
