#pragma once
// The GJK distance algorithm: a loop over phases (Catto 2010, slide "GJK algorithm"; Gilbert,
// Johnson, Keerthi 1988).
//
//   pick an initial simplex S
//   loop
//     closest    compute the closest point P on S
//     cull       drop the vertices that do not contribute to P
//     direction  build d, pointing from P to O
//     support    find the support point of Z = Y - X in direction d
//     stop       decide whether the answer is found
//     add        add the support point to S
//
// `step` runs one phase, `distance` all of them, `trace` all of them while keeping every state, by
// the same functions, which decide from the state alone: recording cannot change a decision.

#include "gjk/certificate.hpp"
#include "gjk/closest_point.hpp"
#include "gjk/direction.hpp"
#include "gjk/stop.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// One phase that ran: what it left, and what it noted.
template <class R, int D>
struct Step {
  Phase phase = Phase::closest;
  int iteration = 1;
  State<R, D> after;
  Record<R, D> record;
};

/// A whole run. `steps` is complete for every outcome and empty only when the query was refused at
/// once.
template <class R, int D>
struct Trace {
  Prepared<R, D> prepared;
  State<R, D> initial;
  std::vector<Step<R, D>> steps;
  Result<R, D> result;
};

/// The state before the first phase.
template <class R, class S, int D>
[[nodiscard]] State<R, D> start(const Query<S, D>& query, const Options& options,
                                const Prepared<R, D>& prepared) {
  State<R, D> state;
  if (prepared.error != Error::none) {
    state.error = prepared.error;
    state.stop = StopReason::failed;
    state.phase = Phase::stop;
    return state;
  }
  state.simplex.count = std::max(options.start.count, 1);
  for (int i = 0; i < options.start.count; ++i) {
    state.simplex.vertices[i] = support_point(query, prepared, options.start.pairs[i]);
  }
  if (options.start.count == 0) {
    const VertexPair first = detail::farthest_pair(query, prepared, Vec<R, D>(-prepared.offset));
    state.simplex.vertices[0] = support_point(query, prepared, first);
  }
  state.region = state.simplex.all();
  return state;
}

/// Runs the phase `state.phase`. The run goes on while `state.stop` is StopReason::running.
template <class R, class S, int D, class Rec>
void step(State<R, D>& state, const Query<S, D>& query, const Options& options,
          const Prepared<R, D>& prepared, Rec& record) {
  switch (state.phase) {
    case Phase::closest:
      detail::find_closest_point(state, options, record);
      break;
    case Phase::cull:
      detail::cull(state, options, record);
      break;
    case Phase::direction:
      detail::build_direction(state, options, record);
      break;
    case Phase::support:
      detail::find_support(state, query, prepared, record);
      break;
    case Phase::stop:
      detail::run_stop_tests(state, options, prepared, record);
      break;
    case Phase::add:
      detail::add_support(state);
      break;
  }
}

namespace detail {

template <class R, class S, int D>
[[nodiscard]] State<R, D> run(const Query<S, D>& query, const Options& options,
                              const Prepared<R, D>& prepared) {
  State<R, D> state = start(query, options, prepared);
  NoRecord none;
  while (state.stop == StopReason::running) {
    find_closest_point(state, options, none);
    cull(state, options, none);
    if (state.phase == Phase::direction) build_direction(state, options, none);
    if (state.phase == Phase::support) find_support(state, query, prepared, none);
    run_stop_tests(state, options, prepared, none);
    if (state.stop == StopReason::running) add_support(state);
  }
  return state;
}
/// The same, with all of the phases in one function. Not for exact arithmetic: that would take the
/// compiler minutes and save nothing.
template <class R, class S, int D>
[[nodiscard, gnu::flatten]] State<R, D> run_inline(const Query<S, D>& query, const Options& options,
                                                   const Prepared<R, D>& prepared) {
  return run(query, options, prepared);
}

/// `state` is the end of an exact run that found P = O. True when some support plane of Z passes
/// through O.
template <class R, class S>
[[nodiscard]] bool touches(const State<R, 2>& state, const Query<S, 2>& query,
                           const Prepared<R, 2>& prepared) {
  if (state.touches_plane) return true;
  const auto looking_along = [&](const Vec<R, 2>& d) {
    State<R, 2> probe;
    probe.d = d;
    NoRecord none;
    find_support(probe, query, prepared, none);
    return probe;
  };
  const Simplex<R, 2>& simplex = state.best;
  if (simplex.count == 3) return false;
  if (simplex.count == 2) {  // O lies between two vertices: only their line can be such a plane
    const Vec<R, 2> edge = simplex.vertices[1].w - simplex.vertices[0].w;
    const Vec<R, 2> normal = perpendicular<R, 2>({edge});
    return looking_along(normal).touches_plane || looking_along(-normal).touches_plane;
  }
  // A vertex of Z at O says nothing of what lies around it: start over from another one.
  const State<R, 2> other = looking_along(Vec<R, 2>(R(1), R(0)));
  if (other.touches_plane) return true;
  Options again;
  again.start.count = 1;
  again.start.pairs[0] = other.support.pair;
  return touches(run(query, again, prepared), query, prepared);
}

/// Exact products need room for all their digits: true when no coordinate is so much smaller than
/// 2^exponent that a product of it could underflow.
template <class S>
[[nodiscard, gnu::noinline]] bool has_exact_products(const Query<S, 2>& query, bool same_frame,
                                                     int exponent) {
  // Products of up to two coordinates in the world, of up to four numbers when poses turn them.
  const double least = same_frame ? 0x1p-400 : 0x1p-200;
  const auto has_room = [&](const S& value, int unit) {
    const double size = std::abs(std::ldexp(static_cast<double>(value), -unit));
    return value == S(0) || (least <= size && size <= 1.0 / least);
  };
  for (const Shape<S, 2>* shape : {&query.x, &query.y}) {
    for (int i = 0; i < 4; ++i) {
      if (!has_room(shape->pose.rotation(i / 2, i % 2), 0)) return false;
    }
    for (int k = 0; k < 2; ++k) {
      if (!has_room(shape->pose.translation[k], exponent)) return false;
    }
    for (const Vec<S, 2>& vertex : shape->vertices) {
      if (!has_room(vertex[0], exponent) || !has_room(vertex[1], exponent)) return false;
    }
  }
  return true;
}

/// a * 2^exponent, on the wanted side where that is denormal and rounds.
template <class R>
[[nodiscard]] R scaled_below(const R& a, int exponent) {
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool above = a < ScalarTraits<R>::scaled(out, -exponent);
  return above ? R(out - std::numeric_limits<R>::denorm_min()) : out;
}
template <class R>
[[nodiscard]] R scaled_above(const R& a, int exponent) {
  const R out = ScalarTraits<R>::scaled(a, exponent);
  const bool below = ScalarTraits<R>::scaled(out, -exponent) < a;
  return below ? R(out + std::numeric_limits<R>::denorm_min()) : out;
}

/// The barycentric weights of P in an exact simplex, in the digits of R.
template <class R>
[[nodiscard]] std::array<R, 3> exact_weights(const Simplex<Expansion, 2>& simplex) {
  if (simplex.count == 1) return {R(1), R(0), R(0)};
  const Flat<Expansion> a = flat(simplex.vertices[0].w);
  const Flat<Expansion> b = flat(simplex.vertices[1].w);
  if (simplex.count == 3) return shares_of_area<R, Expansion>({a, b, flat(simplex.vertices[2].w)});
  const Flat<Expansion> edge = b - a;
  const R of_a = rounded<R>(dot(b, edge));
  const R of_b = rounded<R>(-dot(a, edge));
  return {of_a / (of_a + of_b), of_b / (of_a + of_b), R(0)};
}

/// Runs on from the best simplex of `state` in exact arithmetic, and puts what comes of it in
/// `out`. Leaves it as it is when exact arithmetic has no room for the query.
template <class R, class S>
[[gnu::noinline]] void settle(const State<R, 2>& state, const Query<S, 2>& query,
                              const Prepared<R, 2>& prepared, Result<R, 2>& out,
                              Bounds<R>& bounds) {
  using Traits = ScalarTraits<R>;
  // In a unit about as large as Z, so that any power of two times the same query ends the same way.
  Prepared<Expansion, 2> exact;
  exact.exponent = prepared.exponent;
  if (R(0) < prepared.reach) {
    constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
    exact.exponent =
        std::clamp(prepared.exponent + Traits::exponent(prepared.reach), -kLimit, kLimit);
  }
  if (!has_exact_products(query, prepared.same_frame, exact.exponent)) return;
  exact.same_frame = prepared.same_frame;
  exact.offset = exact.in_unit(converted<Expansion, S, 2>(query.y.pose.translation)) -
                 exact.in_unit(converted<Expansion, S, 2>(query.x.pose.translation));
  Options options;
  options.start.count = state.best.count;
  for (int i = 0; i < options.start.count; ++i)
    options.start.pairs[i] = state.best.vertices[i].pair;
  const State<Expansion, 2> end = run(query, options, exact);
  if (end.stop == StopReason::iteration_cap) return;

  // float cannot square the length of a short edge.
  using Wide =
      std::conditional_t<(std::numeric_limits<double>::digits < std::numeric_limits<R>::digits), R,
                         double>;
  const std::array<Wide, 3> weights = exact_weights<Wide>(end.best);
  out.settled = true;
  out.simplex.count = end.best.count;
  for (int i = 0; i < end.best.count; ++i) {
    const SupportPoint<Expansion, 2>& vertex = end.best.vertices[i];
    out.simplex.vertices[i] = support_point(query, prepared, vertex.pair);
    out.simplex.weights[i] = static_cast<R>(weights[i]);
  }
  bounds = {};
  if (end.best_sq == Expansion()) {
    out.verdict = touches(end, query, exact) ? Verdict::touching : Verdict::overlapping;
  } else {
    out.verdict = Verdict::separated;
    const auto& ends = end.best.vertices;
    const Flat<Expansion> a = flat(ends[0].w);
    const R distance = static_cast<R>(
        end.best.count == 1
            ? careful_length<Wide>(a)
            : magnitude(careful_distance<Wide>(Edge<Expansion>{a, flat(ends[1].w) - a})));
    const R few = R(kCarefulRoundings) * Traits::unit_roundoff();
    // A denormal quotient is off by up to half of this.
    const R least = std::numeric_limits<R>::denorm_min();
    const int exponent = exact.exponent - prepared.exponent;
    bounds.distance = Traits::scaled(distance, exponent);
    bounds.lower = scaled_below(std::max(R(distance * (R(1) - few) - least), R(0)), exponent);
    bounds.upper = scaled_above(R(distance * (R(1) + few) + least), exponent);
  }
}

/// The distance and the witness points are numbers of the scalar.
template <class R, int D>
[[nodiscard]] bool is_in_scalar(const Result<R, D>& out) {
  return ScalarTraits<typename Result<R, D>::Real>::is_finite(out.distance) &&
         gjk::is_finite(out.x) && gjk::is_finite(out.y);
}

}  // namespace detail

/// Reads the answer from a state; before the run has ended, the best answer so far.
///
/// The loop rounds, and rounding can fool it. But its answer can be checked: P bounds the distance
/// from above, the best support plane from below. Where these bounds do not prove whether the
/// shapes overlap, or are wider than rounding explains, the last simplex starts another run in
/// exact arithmetic. That is rare, so it costs next to nothing, and makes the verdict exact.
template <class R, class S, int D>
[[nodiscard]] Result<R, D> result(const State<R, D>& state, const Query<S, D>& query,
                                  const Options& options, const Prepared<R, D>& prepared) {
  using Traits = ScalarTraits<R>;
  Result<R, D> out;
  out.error = state.error;
  out.stop = state.stop;
  if (state.error != Error::none || state.best.count == 0) return out;
  out.iterations = state.iteration;
  out.simplex.count = state.best.count;
  for (int i = 0; i < state.best.count; ++i) {
    out.simplex.vertices[i] = state.best.vertices[i];
    out.simplex.weights[i] = state.best.weights[i];
  }
  if constexpr (Traits::kExact) {
    const bool at_origin = state.best_sq == R(0);
    out.distance_sq = state.best_sq;
    out.distance = Traits::root(state.best_sq);
    out.lower = Traits::root_below(state.plane_distance_sq);
    out.upper = Traits::root_above(state.best_sq);
    out.verdict = at_origin                        ? Verdict::overlapping
                  : R(0) < state.plane_distance_sq ? Verdict::separated
                                                   : Verdict::undecided;
    if constexpr (D == 2) {
      if (at_origin && detail::touches(state, query, prepared)) out.verdict = Verdict::touching;
    }
  } else {
    detail::Bounds<R> bounds = detail::bounds(state, query, prepared);
    if (R(0) < bounds.lower) {
      out.verdict = Verdict::separated;
    } else {
      const bool inside = bounds.upper == R(0) && state.best.count == D + 1;
      out.verdict = inside ? Verdict::overlapping : Verdict::undecided;
    }
    if constexpr (D == 2 && std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits) {
      const bool proved = out.verdict != Verdict::undecided;
      const bool wide = !bounds.tight && Traits::from(options.tolerance) * bounds.upper <
                                             bounds.upper - bounds.lower;
      const bool ended =
          state.stop != StopReason::running && state.stop != StopReason::iteration_cap;
      if (options.proof == Proof::exact && ended && (!proved || wide)) {
        detail::settle(state, query, prepared, out, bounds);
      }
      if (out.simplex.count == 3 && !out.settled && !detail::is_at_origin(out.simplex)) {
        detail::set_careful_weights(out.simplex, query, prepared);
      }
    }
    out.distance = bounds.distance;
    out.lower = bounds.lower;
    out.upper = bounds.upper;
    if (prepared.exponent != 0) {
      out.distance = Traits::scaled(bounds.distance, prepared.exponent);
      out.lower = detail::scaled_below(bounds.lower, prepared.exponent);
      out.upper = detail::scaled_above(bounds.upper, prepared.exponent);
    }
    out.distance_sq = out.distance * out.distance;
  }
  detail::set_witness_points(out, query, prepared);
  if (!detail::is_in_scalar(out)) {
    out = {};
    out.error = Error::overflow;
    out.stop = StopReason::failed;
  }
  return out;
}

namespace detail {
inline constexpr Options kDefaultOptions;

template <class R, class S, int D>
[[gnu::noinline]] void run_by_phases(const Query<S, D>& query, const Options& options,
                                     Result<R, D>& out) {
  const Prepared<R, D> prepared = prepare<R>(query, options);
  out = result(run_inline(query, options, prepared), query, options, prepared);
}
}  // namespace detail

/// Distance between two convex shapes, computed in R: distance<float>(query) stays in float.
/// Allocates only where exact arithmetic has to settle the answer.
template <class R = Default, class S, int D>
[[nodiscard, gnu::flatten]] Result<RunScalar<R, S>, D> distance(const Query<S, D>& query,
                                                                const Options& options) {
  Result<RunScalar<R, S>, D> out;
  detail::run_by_phases(query, options, out);
  return out;
}

/// With the default options, which the compiler knows.
template <class R = Default, class S, int D>
[[nodiscard, gnu::flatten]] Result<RunScalar<R, S>, D> distance(const Query<S, D>& query) {
  return distance<R>(query, detail::kDefaultOptions);
}

/// The same run, every phase recorded.
template <class R = Default, class S, int D>
[[nodiscard]] Trace<RunScalar<R, S>, D> trace(const Query<S, D>& query,
                                              const Options& options = {}) {
  Trace<RunScalar<R, S>, D> out;
  out.prepared = prepare<RunScalar<R, S>>(query, options);
  State<RunScalar<R, S>, D> state = start(query, options, out.prepared);
  out.initial = state;
  while (state.stop == StopReason::running) {
    Step<RunScalar<R, S>, D> next;
    next.phase = state.phase;
    next.iteration = state.iteration;
    step(state, query, options, out.prepared, next.record);
    next.after = state;
    out.steps.push_back(std::move(next));
  }
  out.result = result(state, query, options, out.prepared);
  return out;
}

}  // namespace gjk
