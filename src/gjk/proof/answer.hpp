#pragma once
// The answer, from the end of a run.
//
// Rounding can mislead the loop, but its answer can be checked: P bounds the distance from above,
// the best support plane from below. When these bounds do not prove whether the shapes overlap, or
// are wider than rounding explains, the last simplex starts another run in exact arithmetic: the
// verdict is exact.

#include "gjk/proof/settle.hpp"

namespace gjk {
namespace detail {

/// The bounds of a floating-point run. Sets the verdict of `out`, and its simplex where needed.
template <class R, class S, int D>
[[nodiscard]] Bounds<R> certify(const State<R, D>& state, const Query<S, D>& query,
                                const Options& options, const Prepared<R, D>& prepared,
                                Result<R, D>& out) {
  const bool ended = state.stop != StopReason::running && state.stop != StopReason::iteration_cap;
  Bounds<R> bounds;
  bool tight = true;
  if (state.evidence.best.count == D + 1) {
    if (surely_inside(state.evidence.best, prepared)) {
      out.verdict = Verdict::overlapping;
    } else {
      bounds.upper = weights_bound<R, D>(state.evidence.best, prepared);
    }
  } else {
    const bool by_itself = ended && state.stop != StopReason::within_tolerance;
    OutsideBounds<R, S, D> outside(state, query, prepared, out.simplex);
    bounds = outside.prove(by_itself);
    if (R(0) < bounds.lower) out.verdict = Verdict::separated;
    tight = !by_itself || outside.is_tight();
  }
  if constexpr (std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits) {
    const bool is_open = out.verdict == Verdict::undecided || !tight;
    if (is_open && ended && options.proof == Proof::exact) settle(query, prepared, out, bounds);
  }
  // In a thin simplex the run's own weights may put P beside O.
  if (out.simplex.count == D + 1 && !out.settled &&
      !is_at_origin(out.simplex, out.simplex.weights, 2)) {
    out.simplex.weights = weights_of<R>(careful_simplex(out.simplex, query, prepared));
  }
  return bounds;
}

/// Sets the distance, its bounds and the verdict of an exact run.
template <class R, class S, int D>
void set_exact_answer(const State<R, D>& state, const Query<S, D>& query,
                      const Prepared<R, D>& prepared, Result<R, D>& out) {
  using Traits = ScalarTraits<R>;
  out.distance_sq = state.evidence.best_sq;
  out.distance = Traits::root(state.evidence.best_sq);
  out.lower = Traits::root_below(state.evidence.plane_distance_sq);
  out.upper = Traits::root_above(state.evidence.best_sq);
  if (state.evidence.best_sq == R(0)) {
    out.verdict = touches(state, query, prepared) ? Verdict::touching : Verdict::overlapping;
  } else if (R(0) < state.evidence.plane_distance_sq) {
    out.verdict = Verdict::separated;
  }
}

/// Sets the distance, its bounds and the verdict of a floating-point run.
template <class R, class S, int D>
void set_floating_answer(const State<R, D>& state, const Query<S, D>& query, const Options& options,
                         const Prepared<R, D>& prepared, Result<R, D>& out) {
  using Traits = ScalarTraits<R>;
  if (options.proof == Proof::none) {
    out.distance = Traits::root(state.evidence.best_sq);
    out.verdict = out.distance == R(0) ? Verdict::overlapping : Verdict::separated;
  } else {
    const Bounds<R> bounds = certify(state, query, options, prepared, out);
    out.distance = bounds.distance;
    out.lower = bounds.lower;
    out.upper = bounds.upper;
  }
  if (prepared.exponent != 0) {
    out.distance = Traits::scaled(out.distance, prepared.exponent);
    out.lower = scaled_below(out.lower, prepared.exponent);
    out.upper = scaled_above(out.upper, prepared.exponent);
  }
  out.distance_sq = out.distance * out.distance;
}

}  // namespace detail

/// The point from + beyond of a shape's frame in the world, computed with about twice the digits:
/// far from the frame's origin a rotation can round by more than the size of Z.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Vec<R, D> careful_world_point(const Pose<S, D>& pose,
                                                           const Vec<R, D>& from,
                                                           const Vec<R, D>& beyond, int exponent) {
  using Word = DoubleWord<R>;
  const R unit = ScalarTraits<R>::scaled(R(1), std::min(-exponent, 0));  // 1 if small
  Vec<Word, D> local;
  for (int k = 0; k < D; ++k) local[k] = exact_sum(R(from[k] * unit), R(beyond[k] * unit));
  const Vec<R, D> place = converted<R, S, D>(pose.translation) * unit;
  const Vec<Word, D> world = pose.template rotated<Word>(local) + converted<Word, R, D>(place);
  return scaled<R, D>(converted<R, Word, D>(world), std::max(exponent, 0));
}

/// The weighted point of one shape, in the world. It is the vertex of the largest weight plus a
/// weighted sum of differences, so that little rounds but the last addition.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> witness_point(const Simplex<R, D>& simplex, const Shape<S, D>& shape,
                                      int VertexPair::*index, const Prepared<R, D>& prepared) {
  using W = RunScalar<Default, R>;
  int base = 0;
  for (int i = 1; i < simplex.count; ++i) {
    if (simplex.weights[base] < simplex.weights[i]) base = i;
  }
  const auto vertex = [&](int i) -> decltype(auto) {
    return converted<W, S, D>(shape.vertices()[simplex.vertices[i].pair.*index]);
  };
  const auto& from = vertex(base);
  Vec<W, D> beyond = Vec<W, D>::Zero();
  for (int i = 0; i < simplex.count; ++i) {
    if (i == base) continue;
    const W weight = ScalarTraits<W>::from(simplex.weights[i]);
    beyond = beyond + Vec<W, D>((vertex(i) - from) * weight);
  }
  if constexpr (std::is_same_v<W, R> && !ScalarTraits<R>::kExact) {
    if (shape.pose.rotation.turns() && prepared.centered) {
      return careful_world_point<R>(shape.pose, from, beyond, prepared.exponent);
    }
  }
  const Vec<W, D> from_origin = shape.pose.template rotated<W>(from + beyond);
  return converted<R, W, D>(from_origin + converted<W, S, D>(shape.pose.translation));
}

/// Sets both witness points, the points of X and Y nearest to each other, in the world (Catto 2010,
/// slide "Witness points"). When shapes meet, both are one point, and rounding must not set them
/// apart: it is their midpoint, or the one that is a vertex.
template <class R, class S, int D>
void set_witness_points(Result<R, D>& out, const Query<S, D>& query,
                        const Prepared<R, D>& prepared) {
  const Simplex<R, D>& simplex = out.simplex;
  out.x = witness_point(simplex, query.x, &VertexPair::x, prepared);
  out.y = witness_point(simplex, query.y, &VertexPair::y, prepared);
  if constexpr (!ScalarTraits<R>::kExact) {
    if (out.verdict != Verdict::overlapping && out.verdict != Verdict::touching) return;
    bool one_x = true;
    bool one_y = true;
    for (int i = 1; i < simplex.count; ++i) {
      one_x = one_x && simplex.vertices[i].pair.x == simplex.vertices[0].pair.x;
      one_y = one_y && simplex.vertices[i].pair.y == simplex.vertices[0].pair.y;
    }
    if (one_y) {
      out.x = out.y;
    } else if (!one_x) {
      out.x = out.x + Vec<R, D>((out.y - out.x) * ScalarTraits<R>::from(0.5));
    }
    out.y = out.x;
  }
}

/// The answer of a state; before the run has ended, the best answer so far.
template <class R, class S, int D>
[[nodiscard]] Result<R, D> result(const State<R, D>& state, const Query<S, D>& query,
                                  const Options& options, const Prepared<R, D>& prepared) {
  Result<R, D> out;
  out.error = state.error;
  out.stop = state.stop;
  if (state.error != Error::none || state.evidence.best.count == 0) return out;
  out.verdict = Verdict::undecided;
  out.iterations = state.iteration;
  out.simplex.take(state.evidence.best);
  if constexpr (ScalarTraits<R>::kExact) {
    detail::set_exact_answer(state, query, prepared, out);
  } else {
    detail::set_floating_answer(state, query, options, prepared, out);
  }
  set_witness_points(out, query, prepared);
  if (!ScalarTraits<typename Result<R, D>::Real>::is_finite(out.distance) || !is_finite(out.x) ||
      !is_finite(out.y)) {
    out = {};
    out.error = Error::overflow;
    out.stop = StopReason::failed;
  }
  return out;
}

/// The bounds proved so far by a state's support planes and simplices, in the run's unit.
template <class R, int D>
[[nodiscard]] Bounds<typename ScalarTraits<R>::Real> bounds_so_far(const State<R, D>& state,
                                                                   const Prepared<R, D>& prepared) {
  using Traits = ScalarTraits<R>;
  // After closest, P is known, but only drop makes its simplex the best.
  const bool found_nearer =
      state.previous == Phase::closest && state.evidence.is_nearer(state.p_sq);
  const Simplex<R, D>& nearest = found_nearer ? state.simplex : state.evidence.best;
  const R& nearest_sq = found_nearer ? state.p_sq : state.evidence.best_sq;
  if constexpr (Traits::kExact) {
    return {Traits::root_below(state.evidence.plane_distance_sq), Traits::root(nearest_sq),
            Traits::root_above(nearest_sq)};
  } else {
    const bool full = found_nearer ? state.region == (1 << (D + 1)) - 1 : nearest.count == D + 1;
    const R distance = Traits::root(nearest_sq);
    if (full && surely_inside(nearest, prepared)) return {R(0), distance, R(0)};
    // Far from a short edge |P|^2, made of a cross product, rounds by more than simplex_error.
    const R upper = larger(R(Traits::root_above(nearest_sq) + prepared.simplex_error()),
                           weights_bound<R, D>(nearest, prepared));
    return {plane_bound<R, D>(state.evidence, prepared), distance, upper};
  }
}

}  // namespace gjk
