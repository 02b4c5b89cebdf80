#pragma once
// How deep two convex shapes lie in each other, with a certificate: an expanding polygon, or in
// space an expanding polytope, from where GJK ends.
//
// To understand the algorithm, read state.hpp, loop.hpp, and plane/polygon.hpp or
// space/polytope.hpp (space/face_plane.hpp decides exactly). result.hpp says what is answered, and
// certificate.hpp, with one file for each dimension, keeps rounding in check.

#include "depth/certificate.hpp"
#include "depth/result.hpp"
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
template <class R, int D = 2>
struct Step {
  Phase phase = Phase::nearest;
  int iteration = 1;
  State<R, D> after;
  Record<R, D> record;
  Bounds<R> bounds;
};

/// A whole run, and that of GJK before it. `steps` is complete for every outcome, and empty only
/// when there is nothing to expand: `result.stop` says why.
template <class R, int D = 2>
struct Trace {
  gjk::Trace<R, D> gjk;
  State<R, D> initial;
  std::vector<Step<R, D>> steps;
  Result<R, D> result;
};

namespace detail {

/// The answer of an exact run: its last face lies on the boundary of Z, and none is nearer.
template <class R, int D>
void set_exact_answer(const State<R, D>& state, Result<R, D>& out) {
  using Traits = gjk::ScalarTraits<R>;
  const R n_sq = gjk::dot(state.n, state.n);
  const R share = gjk::dot(state.n, nearest_corner(state, 0).w) / n_sq;
  const R depth_sq = share * R(share * n_sq);
  out.depth = Traits::root(depth_sq);
  out.lower = Traits::root_below(depth_sq);
  out.upper = Traits::root_above(depth_sq);
  for (int i = 0; i < D; ++i) {
    const typename Traits::Real size = Traits::root(state.n[i] * R(state.n[i] / n_sq));
    out.direction[i] = state.n[i] < R(0) ? -size : size;
    out.translation[i] = state.n[i] * share;
  }
  if (has_own_contact<D>(out.verdict)) out.face = exact_contact_face(state);
}

/// The answer of a run that rounded.
template <class R, class S, int D>
void set_rounded_answer(const State<R, D>& state, const gjk::Result<R, D>& found,
                        const gjk::Query<S, D>& query, const gjk::Options& options,
                        const gjk::Prepared<R, D>& prepared, Result<R, D>& out) {
  constexpr bool kCanSettle = std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits;
  Proof<R, D> proof = prove(state, query, prepared);
  if constexpr (kCanSettle) {
    if (options.proof == gjk::Proof::exact && !proof.is_tight)
      out.settled = settle(found, query, prepared, proof);
  }
  out.depth = gjk::ScalarTraits<R>::scaled(proof.depth, prepared.exponent);
  if (options.proof != gjk::Proof::none) {
    out.lower = gjk::scaled_below(proof.lower, prepared.exponent);
    out.upper = gjk::scaled_above(proof.upper, prepared.exponent);
  }
  out.direction = proof.direction + Vec<R, D>::Zero();              // no -0
  out.translation = out.direction * out.depth + Vec<R, D>::Zero();  // no -0
  if (has_own_contact<D>(out.verdict)) out.face = proof.face;
}

/// Reads the answer from the end of a run.
template <class R, class S, int D>
[[nodiscard]] Result<R, D> result(const State<R, D>& state, const gjk::Result<R, D>& found,
                                  const gjk::Query<S, D>& query, const gjk::Options& options,
                                  const gjk::Prepared<R, D>& prepared) {
  Result<R, D> out;
  out.error = found.error;
  out.stop = state.stop;
  out.verdict = found.verdict;
  if (obstacle(found.verdict) != StopReason::running) return out;
  out.iterations = state.iteration;
  out.face = found.simplex;
  out.x = found.x;
  out.y = found.y;
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    set_exact_answer(state, out);
  } else {
    set_rounded_answer(state, found, query, options, prepared, out);
  }
  if (has_own_contact<D>(out.verdict)) {
    out.x = gjk::witness_point(out.face, query.x, &gjk::VertexPair::x, prepared);
    out.y = gjk::witness_point(out.face, query.y, &gjk::VertexPair::y, prepared);
  }
  if (!gjk::ScalarTraits<typename Result<R, D>::Real>::is_finite(out.depth) ||
      !gjk::is_finite(out.x) || !gjk::is_finite(out.y)) {
    out = {};
    out.error = gjk::Error::overflow;
    out.stop = StopReason::failed;
  }
  return out;
}

/// Improves the bounds by what the phase that ran has found: the nearest face, or a support point.
template <class R, int D>
void improve(Bounds<R>& bounds, Phase ran, const State<R, D>& state,
             const gjk::Prepared<R, D>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  if (ran == Phase::nearest) {
    bounds.lower = gjk::larger(bounds.lower, distance_below(state, prepared));
  } else if (ran == Phase::support) {
    const R value = gjk::dot(state.n, state.support.w);
    auto upper = Traits::root_above(value * R(value / gjk::dot(state.n, state.n)));
    if constexpr (!Traits::kExact) {
      upper = upper + prepared.plane_error(upper, gjk::length(state.support.w));
    }
    if (!(bounds.upper <= upper)) bounds.upper = upper;
  }
}

}  // namespace detail

/// How deep two convex shapes lie in each other, computed in R as gjk::distance does. Only
/// `options.proof` matters to what expands; the others are GJK's. Allocates.
template <class R = gjk::Default, class S, int D>
[[nodiscard]] Result<gjk::RunScalar<R, S>, D> penetration(const gjk::Query<S, D>& query,
                                                          const gjk::Options& options = {}) {
  using Run = gjk::RunScalar<R, S>;
  const gjk::Prepared<Run, D> prepared = gjk::prepare<Run>(query, options);
  gjk::State<Run, D> before = gjk::start(query, options, prepared);
  gjk::run(before, query, options, prepared);
  const gjk::Result<Run, D> found = gjk::result(before, query, options, prepared);
  State<Run, D> state = start(query, prepared, found);
  run(state, query, prepared);
  return detail::result(state, found, query, options, prepared);
}

/// The same run, every phase recorded.
template <class R = gjk::Default, class S, int D>
[[nodiscard]] Trace<gjk::RunScalar<R, S>, D> trace(const gjk::Query<S, D>& query,
                                                   const gjk::Options& options = {}) {
  using Run = gjk::RunScalar<R, S>;
  Trace<Run, D> out;
  out.gjk = gjk::trace<R>(query, options);
  const gjk::Prepared<Run, D>& prepared = out.gjk.prepared;
  State<Run, D> state = start(query, prepared, out.gjk.result);
  out.initial = state;
  Bounds<Run> bounds;
  while (state.stop == StopReason::running) {
    Step<Run, D> next;
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

namespace space {

// The names of a run in space, beside Polytope and Face.
template <class R>
using State = depth::State<R, 3>;
template <class R>
using Record = depth::Record<R, 3>;
template <class R>
using Step = depth::Step<R, 3>;
template <class R>
using Trace = depth::Trace<R, 3>;
using depth::run;
using depth::start;
using depth::trace;

}  // namespace space
}  // namespace depth
