#pragma once
// How deep two convex shapes lie in each other, in space, with a certificate: an expanding
// polytope, from where GJK ends.
//
// To understand the algorithm, read state.hpp and loop.hpp. ../depth/result.hpp says what is
// answered; plane.hpp decides exactly, and certificate.hpp keeps rounding in check.

#include "depth/depth.hpp"
#include "depth/space/certificate.hpp"

namespace depth::space {

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
  gjk::Trace<R, 3> gjk;
  State<R> initial;
  std::vector<Step<R>> steps;
  Result<R, 3> result;
};

namespace detail {

/// The answer of an exact run: its last face lies on the boundary of Z, and none is nearer.
template <class R>
void set_exact_answer(const State<R>& state, Result<R, 3>& out) {
  using Traits = gjk::ScalarTraits<R>;
  const Polytope<R>& polytope = state.polytope;
  const Face<R>& nearest = polytope.faces[state.face];
  const R n_sq = gjk::dot(state.n, state.n);
  const R share = gjk::dot(state.n, polytope.at(nearest, 0)) / n_sq;
  out.depth = Traits::root(nearest.distance_sq);
  out.lower = Traits::root_below(nearest.distance_sq);
  out.upper = Traits::root_above(nearest.distance_sq);
  for (int i = 0; i < 3; ++i) {
    const typename Traits::Real size = Traits::root(state.n[i] * R(state.n[i] / n_sq));
    out.direction[i] = state.n[i] < R(0) ? -size : size;
    out.translation[i] = state.n[i] * share;
  }
  if (out.verdict == gjk::Verdict::touching) return;
  for (const Face<R>& face : polytope.faces) {
    if (face.is_outgrown || !(face.distance_sq == nearest.distance_sq)) continue;
    gjk::Simplex<R, 3> simplex = simplex_of(polytope, face);
    bool holds = true;
    for (int i = 0; i < 3; ++i) {
      holds = holds && gjk::dot(state.n, polytope.at(face, i)) == share * n_sq;
    }
    const auto coordinates = gjk::triangle_coordinates(simplex, 0, 1, 2);
    for (int i = 0; i < 3; ++i) holds = holds && !(coordinates.numerator[i] < R(0));
    if (!holds) continue;
    gjk::set_weights<R, 3>(simplex.weights, simplex.all(), coordinates);
    out.face = simplex;
    return;
  }
}

/// Those of a run that rounded.
template <class R, class S>
void set_rounded_answer(const State<R>& state, const gjk::Result<R, 3>& found,
                        const gjk::Query<S, 3>& query, const gjk::Options& options,
                        const gjk::Prepared<R, 3>& prepared, Result<R, 3>& out) {
  using Traits = gjk::ScalarTraits<R>;
  constexpr bool kCanSettle = std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits;
  Proof<R> proof = prove(state, query, prepared);
  if constexpr (kCanSettle) {
    if (options.proof == gjk::Proof::exact && !proof.is_tight) {
      out.settled = settle(found, query, prepared, proof);
    }
  }
  if (!out.settled) {
    const Vec<R, 3> t = proof.direction * proof.depth;
    proof.face = contact_face(state.polytope, t, query, prepared);
  }
  out.depth = Traits::scaled(proof.depth, prepared.exponent);
  if (options.proof != gjk::Proof::none) {
    out.lower = gjk::scaled_below(proof.lower, prepared.exponent);
    out.upper = gjk::scaled_above(proof.upper, prepared.exponent);
  }
  out.direction = proof.direction + Vec<R, 3>::Zero();              // no -0
  out.translation = out.direction * out.depth + Vec<R, 3>::Zero();  // no -0
  if (out.verdict != gjk::Verdict::touching) out.face = proof.face;
}

/// Reads the answer from the end of a run.
template <class R, class S>
[[nodiscard]] Result<R, 3> result(const State<R>& state, const gjk::Result<R, 3>& found,
                                  const gjk::Query<S, 3>& query, const gjk::Options& options,
                                  const gjk::Prepared<R, 3>& prepared) {
  Result<R, 3> out;
  out.error = found.error;
  out.stop = state.stop;
  out.verdict = found.verdict;
  if (state.polytope.faces.empty()) return out;
  out.iterations = state.iteration;
  out.face = found.simplex;  // where the shapes touch O lies in it
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    set_exact_answer(state, out);
  } else {
    set_rounded_answer(state, found, query, options, prepared, out);
  }
  if (out.verdict == gjk::Verdict::touching) {
    out.x = found.x;
    out.y = found.y;
  } else {
    out.x = gjk::witness_point(out.face, query.x, &gjk::VertexPair::x, prepared);
    out.y = gjk::witness_point(out.face, query.y, &gjk::VertexPair::y, prepared);
  }
  if (!gjk::ScalarTraits<typename Result<R, 3>::Real>::is_finite(out.depth) ||
      !gjk::is_finite(out.x) || !gjk::is_finite(out.y)) {
    out = {};
    out.error = gjk::Error::overflow;
    out.stop = StopReason::failed;
  }
  return out;
}

/// Improves the bounds by what the phase that ran has found: the nearest face, or a support point.
template <class R>
void improve(Bounds<R>& bounds, Phase ran, const State<R>& state,
             const gjk::Prepared<R, 3>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  using Real = typename Traits::Real;
  if (ran == Phase::nearest) {
    const Face<R>& face = state.polytope.faces[state.face];
    Real lower(0);
    if constexpr (Traits::kExact) {
      if (R(0) < face.distance_sq) lower = Traits::root_below(face.distance_sq);
    } else {
      lower = boundary_below(face, size_of(state.polytope), prepared);
    }
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

/// The same run as `penetration` below, every phase recorded.
template <class R = gjk::Default, class S>
[[nodiscard]] Trace<gjk::RunScalar<R, S>> trace(const gjk::Query<S, 3>& query,
                                                const gjk::Options& options = {}) {
  using Run = gjk::RunScalar<R, S>;
  Trace<Run> out;
  out.gjk = gjk::trace<R>(query, options);
  const gjk::Prepared<Run, 3>& prepared = out.gjk.prepared;
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

}  // namespace depth::space

namespace depth {

/// How deep two convex shapes in space lie in each other, computed in R as gjk::distance does. Only
/// `options.proof` matters to the polytope; the others are GJK's. Allocates.
template <class R = gjk::Default, class S>
[[nodiscard]] Result<gjk::RunScalar<R, S>, 3> penetration(const gjk::Query<S, 3>& query,
                                                          const gjk::Options& options = {}) {
  using Run = gjk::RunScalar<R, S>;
  const gjk::Prepared<Run, 3> prepared = gjk::prepare<Run>(query, options);
  gjk::State<Run, 3> before = gjk::start(query, options, prepared);
  gjk::run(before, query, options, prepared);
  const gjk::Result<Run, 3> found = gjk::result(before, query, options, prepared);
  space::State<Run> state = space::start(query, prepared, found);
  space::run(state, query, prepared);
  return space::detail::result(state, found, query, options, prepared);
}

}  // namespace depth
