#pragma once
// Exact answers where rounding leaves a verdict open: the last simplex of a run starts another run
// of the same loop, on expansions. That is rare, so it costs next to nothing.

#include "gjk/careful.hpp"
#include "gjk/certificate.hpp"
#include "gjk/loop.hpp"
#include "gjk/result.hpp"

namespace gjk {

/// The run of `query` in exact arithmetic, from a start or from any vertex.
template <class R, class S, int D>
[[nodiscard]] State<R, D> exact_run(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                    const WarmStart& from = {}) {
  Options options;
  options.start = from;
  State<R, D> state = start(query, options, prepared);
  run(state, query, options, prepared);
  return state;
}

/// `state` is the end of an exact run that found P = O. True when some support plane of Z passes
/// through O.
template <class R, class S, int D>
[[nodiscard]] bool touches(const State<R, D>& state, const Query<S, D>& query,
                           const Prepared<R, D>& prepared);

/// The same where O lies inside an edge of the simplex in space. A support plane holds that edge,
/// so it is seen along the edge as a line: what is left to ask is a question of the plane.
template <class R, class S>
[[nodiscard]] bool touches_along(const Vec<R, 3>& edge, const Query<S, 3>& query,
                                 const Prepared<R, 3>& prepared) {
  int along = 0;
  while (edge[along] == R(0)) ++along;
  const auto seen = [&](const Vec<R, 3>& vertex) {  // two coordinates of the moment tell the third
    const Vec<R, 3> moment = cross(edge, vertex);
    return Vec<R, 2>(moment[(along + 1) % 3], moment[(along + 2) % 3]);
  };
  const auto all_seen = [&](const Shape<S, 3>& shape, const Body<R, 3>& body, const Vec<R, 3>& at) {
    std::vector<Vec<R, 2>> out;
    for (int i = 0; i < static_cast<int>(shape.vertices().size()); ++i) {
      out.push_back(seen(turned_vertex(shape, prepared, body, i) + at));
    }
    return out;
  };
  const auto x = all_seen(query.x, prepared.x, Vec<R, 3>::Zero());
  const auto y = all_seen(query.y, prepared.y, prepared.offset);
  const Query<R, 2> flat{{x}, {y}};
  const Prepared<R, 2> flat_prepared = prepare<R>(flat, {});
  return touches(exact_run(flat, flat_prepared), flat, flat_prepared);
}

template <class R, class S, int D>
[[nodiscard]] bool touches(const State<R, D>& state, const Query<S, D>& query,
                           const Prepared<R, D>& prepared) {
  const Simplex<R, D>& simplex = state.best;
  if (state.touches_plane) return true;
  if (simplex.count == D + 1) return false;
  const auto looking_along = [&](const Vec<R, D>& d) {
    State<R, D> probe;
    probe.d = d;
    NoRecord none;
    find_support(probe, query, prepared, none);
    return probe;
  };
  if (simplex.count == D) {  // O lies inside a facet: only its plane can be such a plane
    const Vec<R, D> normal = normal_of(simplex, simplex.all());
    return looking_along(normal).touches_plane || looking_along(-normal).touches_plane;
  }
  if constexpr (D == 3) {
    if (simplex.count == 2) {
      return touches_along<R>(simplex.vertices[1].w - simplex.vertices[0].w, query, prepared);
    }
  }
  // A vertex of Z at O says nothing of what lies around it: start over from another one.
  const State<R, D> other = looking_along(Vec<R, D>::Unit(0));
  if (other.touches_plane) return true;
  WarmStart from;
  from.count = 1;
  from.pairs[0] = other.support.pair;
  return touches(exact_run(query, prepared, from), query, prepared);
}

/// Exact products need room for all their digits: true when no coordinate is so much smaller than
/// 2^exponent that a product could underflow, or so much larger that it could overflow. Products
/// are of up to two coordinates in the plane and four in space, and of as many entries of
/// rotations. Where long double has more exponents than double, as nearly everywhere, there is room
/// for all but products of eight of the smallest doubles.
template <class Component = long double, class S, int D>
[[nodiscard]] bool has_exact_products(const Query<S, D>& query, bool same_frame, int exponent) {
  using Limits = std::numeric_limits<Component>;
  const int factors = (D == 2 ? 2 : 4) * (same_frame ? 1 : 2);
  const int room = -Limits::min_exponent / factors - Limits::digits;
  const auto has_room = [&](const Vec<S, D>& a, int unit) {
    return std::all_of(a.data(), a.data() + D, [&](const S& value) {
      return value == S(0) || std::abs(ScalarTraits<S>::exponent(magnitude(value)) - unit) <= room;
    });
  };
  const auto shape_has_room = [&](const Shape<S, D>& shape) {
    for (int i = 0; i < D; ++i) {
      if (!has_room(shape.pose.rotation.col(i), 0)) return false;
    }
    return has_room(shape.pose.translation, exponent) &&
           std::all_of(shape.vertices().begin(), shape.vertices().end(),
                       [&](const Vec<S, D>& vertex) { return has_room(vertex, exponent); });
  };
  return shape_has_room(query.x) && shape_has_room(query.y);
}

/// For an exact run of the query, in a unit about as large as Z, so that any power of two times the
/// same query ends the same way.
template <class R, class S, int D>
[[nodiscard]] Prepared<Expansion, D> prepared_exactly(const Query<S, D>& query,
                                                      const Prepared<R, D>& prepared) {
  int exponent = prepared.exponent;
  if (R(0) < prepared.reach) {
    constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
    exponent = std::clamp(exponent + ScalarTraits<R>::exponent(prepared.reach), -kLimit, kLimit);
  }
  const Measures<S, D> not_asked;
  Prepared<Expansion, D> exact;
  detail::set_frames(detail::Bodies<S, D>{query, not_asked, not_asked}, exponent, exact);
  return exact;
}

/// Runs on from the simplex of `out` in exact arithmetic, and puts what comes of it there and
/// in `bounds`. Leaves them as they are when exact arithmetic has no room for the query.
template <class R, class S, int D>
[[gnu::noinline]] void settle(const Query<S, D>& query, const Prepared<R, D>& prepared,
                              Result<R, D>& out, Bounds<R>& bounds) {
  const Prepared<Expansion, D> exact = prepared_exactly(query, prepared);
  if (!has_exact_products(query, prepared.same_frame, exact.exponent)) return;
  const State<Expansion, D> end = exact_run(query, exact, out.warm());
  if (end.stop == StopReason::iteration_cap) return;

  using Wide = Wider<R>;  // even double cannot square the length of a short edge
  const std::array<Wide, D + 1> weights = weights_of<Wide>(end.best);
  out.settled = true;
  out.simplex.count = end.best.count;
  for (int i = 0; i < end.best.count; ++i) {
    out.simplex.vertices[i] = support_point(query, prepared, end.best.vertices[i].pair);
    out.simplex.weights[i] = static_cast<R>(weights[i]);
  }
  bounds = {};
  if (is_zero(end.p)) {
    out.verdict = touches(end, query, exact) ? Verdict::touching : Verdict::overlapping;
    return;
  }
  out.verdict = Verdict::separated;
  const R distance = static_cast<R>(foot_of<Wide>(end.best).distance);
  const R few = R(kCarefulRoundings) * ScalarTraits<R>::unit_roundoff();
  // A denormal quotient is off by up to half of this.
  const R least = std::numeric_limits<R>::denorm_min();
  const int exponent = exact.exponent - prepared.exponent;
  bounds.distance = ScalarTraits<R>::scaled(distance, exponent);
  bounds.lower = scaled_below(std::max(R(distance * (R(1) - few) - least), R(0)), exponent);
  bounds.upper = scaled_above(R(distance * (R(1) + few) + least), exponent);
}

}  // namespace gjk
