#pragma once
// Exact answers where rounding leaves the verdict open or the bounds wide: the last simplex of the
// run starts another run of the same loop, on expansions. That is rare, so it costs little overall.

#include "gjk/loop.hpp"
#include "gjk/proof/certificate.hpp"
#include "gjk/proof/result.hpp"

namespace gjk {

/// Runs `query` in exact arithmetic R, and returns the final state.
template <class R, class S, int D>
[[nodiscard]] State<R, D> exact_run(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                    const WarmStart& from) {
  const Options options{.start = from};
  State<R, D> state = start(query, options, prepared);
  run(state, query, options, prepared);
  return state;
}

/// `touches` in space, where O lies inside an edge of the simplex. A support plane through O holds
/// the edge. Seen along the edge, that plane is a line and Z a polygon: a question of the plane.
template <class R, class S>
[[nodiscard]] bool touches_along(const Vec<R, 3>& edge, const Query<S, 3>& query,
                                 const Prepared<R, 3>& prepared) {
  int along = 0;
  while (edge[along] == R(0)) ++along;
  const auto seen = [&](const Vec<R, 3>& vertex) {  // two coordinates of the moment fix the third
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
  return touches(exact_run(flat, flat_prepared, {{}, 1}), flat, flat_prepared);
}

/// True when some support plane of Z passes through O. `state`: the end of an exact run with P = O.
template <class R, class S, int D>
[[nodiscard]] bool touches(const State<R, D>& state, const Query<S, D>& query,
                           const Prepared<R, D>& prepared) {
  const Simplex<R, D>& simplex = state.evidence.best;
  if (state.evidence.touches_plane) return true;
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
    return looking_along(normal).evidence.touches_plane ||
           looking_along(-normal).evidence.touches_plane;
  }
  if constexpr (D == 3) {
    if (simplex.count == 2) {
      return touches_along<R>(simplex.vertices[1].w - simplex.vertices[0].w, query, prepared);
    }
  }
  // O is a vertex of the simplex, which tells nothing of Z around O: start from another vertex.
  const State<R, D> other = looking_along(Vec<R, D>::Unit(0));
  if (other.evidence.touches_plane) return true;
  return touches(exact_run(query, prepared, {{other.support.pair}, 1}), query, prepared);
}

/// True when no product of an exact run can underflow or overflow, because no coordinate is much
/// smaller or larger than 2^exponent. A product has up to two coordinates in the plane and four in
/// space, and as many entries of rotations. If long double has more exponents than double, as
/// nearly everywhere, there is room for all but products of eight of the smallest doubles.
template <class Component = long double, class S, int D>
[[nodiscard]] bool has_exact_products(const Query<S, D>& query, bool same_frame, int exponent) {
  using Limits = std::numeric_limits<Component>;
  const int factors = (D == 2 ? 2 : 4) * (same_frame ? 1 : 2);
  const int room = -Limits::min_exponent / factors - Limits::digits;
  const auto has_room = [&](const auto& a, int unit) {
    return std::all_of(a.data(), a.data() + a.size(), [&](const S& value) {
      return value == S(0) || std::abs(ScalarTraits<S>::exponent(magnitude(value)) - unit) <= room;
    });
  };
  const auto shape_has_room = [&](const Shape<S, D>& shape) {
    const auto is_near = [&](const Vec<S, D>& vertex) { return has_room(vertex, exponent); };
    return has_room(shape.pose.rotation.matrix(), 0) && is_near(shape.pose.translation) &&
           std::all_of(shape.vertices().begin(), shape.vertices().end(), is_near);
  };
  return shape_has_room(query.x) && shape_has_room(query.y);
}

/// Prepares an exact run, in a unit about as large as Z: powers of two do not change how it ends.
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
  detail::set_frames(detail::MeasuredQuery<S, D>{query, not_asked, not_asked}, exponent, exact);
  return exact;
}

/// Runs on from the simplex of `out` in exact arithmetic, and sets `out` and `bounds` by the end.
/// Changes nothing when exact arithmetic has no room for the query, or the run meets its cap.
template <class R, class S, int D>
[[gnu::noinline]] void settle(const Query<S, D>& query, const Prepared<R, D>& prepared,
                              Result<R, D>& out, Bounds<R>& bounds) {
  const Prepared<Expansion, D> exact = prepared_exactly(query, prepared);
  if (!has_exact_products(query, prepared.same_frame, exact.exponent)) return;
  const State<Expansion, D> end = exact_run(query, exact, out.warm());
  if (end.stop == StopReason::iteration_cap) return;

  using Wide = Wider<R>;  // in double the square of a short edge may underflow
  const std::array<Wide, D + 1> weights = weights_of<Wide>(end.evidence.best);
  out.settled = true;
  out.simplex.count = end.evidence.best.count;
  for (int i = 0; i < end.evidence.best.count; ++i) {
    out.simplex.vertices[i] = support_point(query, prepared, end.evidence.best.vertices[i].pair);
    out.simplex.weights[i] = static_cast<R>(weights[i]);
  }
  bounds = {};
  if (is_zero(end.p)) {
    out.verdict = touches(end, query, exact) ? Verdict::touching : Verdict::overlapping;
    return;
  }
  out.verdict = Verdict::separated;
  const R distance = static_cast<R>(foot_of<Wide>(end.evidence.best).distance);
  const R few = R(kCarefulRoundings) * ScalarTraits<R>::unit_roundoff();
  const R least = std::numeric_limits<R>::denorm_min();  // a denormal quotient errs by half
  const int exponent = exact.exponent - prepared.exponent;
  bounds.distance = ScalarTraits<R>::scaled(distance, exponent);
  bounds.lower = scaled_below(std::max(R(distance * (R(1) - few) - least), R(0)), exponent);
  bounds.upper = scaled_above(R(distance * (R(1) + few) + least), exponent);
}

}  // namespace gjk
