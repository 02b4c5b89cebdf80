#pragma once
// Exact answers in the plane, where rounding leaves a verdict open: the last simplex of a run
// starts another run of the same loop, on expansions. That is rare, so it costs next to nothing.

#include "gjk/careful.hpp"
#include "gjk/certificate.hpp"
#include "gjk/loop.hpp"
#include "gjk/result.hpp"

namespace gjk::detail {

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
  State<R, 2> end = start(query, again, prepared);
  run(end, query, again, prepared);
  return touches(end, query, prepared);
}

/// Exact products need room for all their digits: true when no coordinate is so much smaller than
/// 2^exponent that a product of it could underflow, or so much larger that it could overflow.
/// Products are of up to two coordinates in the world, of up to four numbers when poses turn them.
inline constexpr double kLeastCoordinate = 0x1p-400;
inline constexpr double kLeastTurnedCoordinate = 0x1p-200;
template <class S>
[[nodiscard]] bool has_exact_products(const Query<S, 2>& query, bool same_frame, int exponent) {
  const double least = same_frame ? kLeastCoordinate : kLeastTurnedCoordinate;
  const auto has_room = [&](const S& value, int unit) {
    const double size = std::abs(std::ldexp(static_cast<double>(value), -unit));
    return value == S(0) || (least <= size && size <= 1.0 / least);
  };
  const auto all_have_room = [&](const Vec<S, 2>& a, int unit) {
    return has_room(a[0], unit) && has_room(a[1], unit);
  };
  for (const Shape<S, 2>* shape : {&query.x, &query.y}) {
    if (!all_have_room(shape->pose.rotation.col(0), 0)) return false;
    if (!all_have_room(shape->pose.rotation.col(1), 0)) return false;
    if (!all_have_room(shape->pose.translation, exponent)) return false;
    for (const Vec<S, 2>& vertex : shape->vertices()) {
      if (!all_have_room(vertex, exponent)) return false;
    }
  }
  return true;
}

/// The barycentric weights of P in an exact simplex, in the digits of R.
template <class R>
[[nodiscard]] std::array<R, 3> exact_weights(const Simplex<Expansion, 2>& simplex) {
  if (simplex.count == 1) return {R(1), R(0), R(0)};
  const Vec<Expansion, 2>& a = simplex.vertices[0].w;
  const Vec<Expansion, 2>& b = simplex.vertices[1].w;
  if (simplex.count == 3) return shares_of_area<R, Expansion>({a, b, simplex.vertices[2].w});
  const Vec<Expansion, 2> edge = b - a;
  const R of_a = rounded<R>(dot(b, edge));
  const R of_b = rounded<R>(-dot(a, edge));
  return {of_a / (of_a + of_b), of_b / (of_a + of_b), R(0)};
}

/// For an exact run of the query, in a unit about as large as Z, so that any power of two times the
/// same query ends the same way.
template <class R, class S>
[[nodiscard]] Prepared<Expansion, 2> prepared_exactly(const Query<S, 2>& query,
                                                      const Prepared<R, 2>& prepared) {
  int exponent = prepared.exponent;
  if (R(0) < prepared.reach) {
    constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
    exponent = std::clamp(exponent + ScalarTraits<R>::exponent(prepared.reach), -kLimit, kLimit);
  }
  const Measures<S, 2> not_asked;
  Prepared<Expansion, 2> exact;
  set_frames(Bodies<S, 2>{query, not_asked, not_asked}, exponent, exact);
  return exact;
}

/// Runs on from the best simplex of `state` in exact arithmetic, and puts what comes of it in `out`
/// and `bounds`. Leaves them as they are when exact arithmetic has no room for the query.
template <class R, class S>
[[gnu::noinline]] void settle(const State<R, 2>& state, const Query<S, 2>& query,
                              const Prepared<R, 2>& prepared, Result<R, 2>& out,
                              Bounds<R>& bounds) {
  const Prepared<Expansion, 2> exact = prepared_exactly(query, prepared);
  if (!has_exact_products(query, prepared.same_frame, exact.exponent)) return;
  Options options;
  options.start.count = state.best.count;
  for (int i = 0; i < state.best.count; ++i) {
    options.start.pairs[i] = state.best.vertices[i].pair;
  }
  State<Expansion, 2> end = start(query, options, exact);
  run(end, query, options, exact);
  if (end.stop == StopReason::iteration_cap) return;

  // float cannot square the length of a short edge.
  using Wide =
      std::conditional_t<(std::numeric_limits<double>::digits < std::numeric_limits<R>::digits), R,
                         double>;
  const std::array<Wide, 3> weights = exact_weights<Wide>(end.best);
  out.settled = true;
  out.simplex.count = end.best.count;
  for (int i = 0; i < end.best.count; ++i) {
    out.simplex.vertices[i] = support_point(query, prepared, end.best.vertices[i].pair);
    out.simplex.weights[i] = static_cast<R>(weights[i]);
  }
  bounds = {};
  if (end.best_sq == Expansion()) {
    out.verdict = touches(end, query, exact) ? Verdict::touching : Verdict::overlapping;
    return;
  }
  out.verdict = Verdict::separated;
  const Vec<Expansion, 2>& a = end.best.vertices[0].w;
  const Vec<Expansion, 2>& b = end.best.vertices[1].w;
  const R distance = static_cast<R>(
      end.best.count == 1 ? careful_distance<Wide>(a)
                          : magnitude(careful_distance<Wide>(Edge<Expansion>{a, b - a})));
  const R few = R(kCarefulRoundings) * ScalarTraits<R>::unit_roundoff();
  // A denormal quotient is off by up to half of this.
  const R least = std::numeric_limits<R>::denorm_min();
  const int exponent = exact.exponent - prepared.exponent;
  bounds.distance = ScalarTraits<R>::scaled(distance, exponent);
  bounds.lower = scaled_below(std::max(R(distance * (R(1) - few) - least), R(0)), exponent);
  bounds.upper = scaled_above(R(distance * (R(1) + few) + least), exponent);
}

}  // namespace gjk::detail
