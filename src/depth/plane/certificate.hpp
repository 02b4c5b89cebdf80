#pragma once
// The certificate's part in the plane. The polygon encloses a part of Z whether or not rounding has
// left it convex, if it winds around O; edges that rounding could confuse with the nearest are
// computed anew with about twice the digits.

#include "depth/loop.hpp"
#include "depth/proof.hpp"
#include "gjk/proof/certificate.hpp"

namespace depth::detail {

/// True when the edges go once around O, counter-clockwise: they cross the positive x-axis upwards
/// once more than downwards. False when rounding leaves that open.
template <class R>
[[nodiscard]] bool winds_once(const Polygon<R>& polygon) {
  int turns = 0;
  bool is_certain = true;
  for_each_edge(polygon, [&](int from, int to) {
    const Vec<R, 2>& a = polygon.at(from);
    const Vec<R, 2>& b = polygon.at(to);
    const bool ends_above = R(0) < b[1];
    if ((R(0) < a[1]) == ends_above) return;
    const R left = a[0] * b[1];
    const R right = a[1] * b[0];
    const R rounding = R(4) * gjk::ScalarTraits<R>::unit_roundoff() *
                       (gjk::magnitude(left) + gjk::magnitude(right));
    is_certain = is_certain && rounding < gjk::magnitude(R(left - right));
    if ((right < left) == ends_above) turns += ends_above ? 1 : -1;
  });
  return is_certain && turns == 1;
}

/// Distance of O from the segment ab: as computed, and with what the digits of a and b leave open
/// subtracted.
template <class R>
struct Distance {
  R value = R(0);
  R lower = R(0);

  void narrow(const Distance& other) {
    value = gjk::smaller(value, other.value);
    lower = gjk::smaller(lower, other.lower);
  }
};

/// How often such a distance rounds at worst, and the bound made of it: both coordinates of the way
/// from a to b, the product, three times in the length, the quotient, and the bound.
inline constexpr int kDistanceRoundings = 6;

/// N: R with more digits. `error`: of a and b. Where the foot of the perpendicular may lie between
/// them, the distance is that of their line.
template <class R, class N>
[[nodiscard]] Distance<R> segment_distance(const Vec<N, 2>& a, const Vec<N, 2>& b, const R& error) {
  const Vec<N, 2> exact_edge = b - a;
  const Vec<R, 2> from = gjk::converted<R>(a);
  const Vec<R, 2> edge = gjk::converted<R>(exact_edge);
  const R length = gjk::careful_length(edge);
  const R foot = length == R(0) ? R(0) : R(-gjk::dot(from, edge) / length);  // from a
  const R beyond = R(8) * gjk::ScalarTraits<R>::unit_roundoff() * gjk::careful_length(from);
  if (length == R(0) || foot < -beyond || length + beyond < foot) {
    const R distance =
        foot < length ? gjk::careful_length(from) : gjk::careful_length(gjk::converted<R>(b));
    return {distance, distance - error};
  }
  const R distance = gjk::ScalarTraits<R>::from(gjk::cross(a, exact_edge)) / length;
  return {distance, distance - error * (R(2) + R(2) * beyond / length)};
}

/// The edge that holds the point nearest to O, with its weights. Of two edges that are nearly one
/// line, distances alone may have chosen the one beside which the foot of the perpendicular lies:
/// then the point is as far along the other. The place of the point t, and the unit of the polygon,
/// are not asked for.
template <class R, class S, class N>
[[nodiscard]] gjk::Simplex<R, 2> contact_face(const State<N, 2>& state, const Vec<R, 2>& /*t*/,
                                              const gjk::Query<S, 2>& query,
                                              const gjk::Prepared<R, 2>& prepared,
                                              int /*exponent*/ = 0) {
  using Known = std::conditional_t<std::is_same_v<N, R>, gjk::DoubleWord<R>, N>;
  using Wide = std::conditional_t<std::is_same_v<N, R>, R, gjk::Wider<R>>;
  const Polygon<N>& polygon = state.polygon;
  const auto known = [&](int corner) -> Vec<Known, 2> {
    if constexpr (std::is_same_v<N, R>) {
      return careful_vertex(query, prepared, polygon.corners[corner].point.pair);
    } else {
      return polygon.at(corner);
    }
  };
  std::array<int, 2> ends = {state.edge.from, state.edge.to};
  const Vec<Known, 2> a = known(ends[0]);
  const Vec<Wide, 2> edge = gjk::converted<Wide, Known, 2>(Vec<Known, 2>(known(ends[1]) - a));
  Wide length = gjk::careful_length(edge);
  Wide foot(0);  // from the first end
  if (Wide(0) < length)
    foot = -gjk::dot(Vec<Wide, 2>(gjk::converted<Wide, Known, 2>(a)), edge) / length;
  const auto step_to = [&](int first, int second, const Wide& beyond) {
    const Vec<N, 2> other = polygon.at(second) - polygon.at(first);
    ends = {first, second};
    foot = beyond;
    length = gjk::careful_length(Vec<Wide, 2>(gjk::converted<Wide, N, 2>(other)));
  };
  if (foot < Wide(0)) {
    step_to(ends[0], polygon.corners[ends[0]].previous, Wide(-foot));
  } else if (length < foot) {
    step_to(ends[1], polygon.corners[ends[1]].next, Wide(foot - length));
  }
  gjk::Simplex<R, 2> out;
  for (int i = 0; i < 2; ++i)
    out.vertices[i] = gjk::support_point(query, prepared, polygon.corners[ends[i]].point.pair);
  out.count = ends[0] == ends[1] ? 1 : 2;
  if (out.count == 2) out.weights[1] = foot < length ? static_cast<R>(foot / length) : R(1);
  out.weights[0] = R(1) - out.weights[1];
  return out;
}

/// The same of an exact run.
template <class R>
[[nodiscard]] gjk::Simplex<R, 2> exact_contact_face(const State<R, 2>& state) {
  const gjk::SupportPoint<R, 2>& a = nearest_corner(state, 0);
  const gjk::SupportPoint<R, 2>& b = nearest_corner(state, 1);
  gjk::Simplex<R, 2> out;
  out.count = state.edge.from == state.edge.to ? 1 : 2;
  out.vertices[0] = a;
  out.vertices[1] = b;
  if (out.count == 2)
    out.weights[1] = -gjk::dot(a.w, Vec<R, 2>(b.w - a.w)) / gjk::dot(state.n, state.n);
  out.weights[0] = R(1) - out.weights[1];
  return out;
}

/// How near the boundary of Z can be, if that of the polygon is as near as its nearest edge.
template <class R>
[[nodiscard]] auto distance_below(const State<R, 2>& state, const gjk::Prepared<R, 2>& prepared) {
  auto distance = gjk::ScalarTraits<R>::root_below(state.edge.distance_sq);
  if constexpr (!gjk::ScalarTraits<R>::kExact) distance = distance - prepared.simplex_error();
  return distance;
}

/// Distance of O from the polygon at the end of a run in expansions. Edges compare by rounded
/// distances: those that may be as near are measured once more.
template <class Wide, class R>
[[nodiscard]] Wide exact_distance(const State<R, 2>& end) {
  const Polygon<R>& polygon = end.polygon;
  const auto measured = [&](int from, int to) {
    return segment_distance(polygon.at(from), polygon.at(to), Wide(0)).value;
  };
  Wide nearest = measured(end.edge.from, end.edge.to);
  for_each_edge(polygon, [&](int from, int to) {
    const R distance_sq = segment_distance_sq(polygon.at(from), polygon.at(to));
    const Wide distance(gjk::ScalarTraits<R>::root(distance_sq));
    if (distance * Wide(1.0 - 0x1p-44) <= nearest)
      nearest = gjk::smaller(nearest, measured(from, to));
  });
  return nearest;
}

/// Bounds of a run that rounded, and the edge of contact.
template <class R, class S>
[[nodiscard]] Proof<R, 2> prove(const State<R, 2>& state, const gjk::Query<S, 2>& query,
                                const gjk::Prepared<R, 2>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  using Word = gjk::DoubleWord<R>;
  const R u = Traits::unit_roundoff();
  const Polygon<R>& polygon = state.polygon;
  const auto careful_corner = [&](int corner) {
    return careful_vertex(query, prepared, polygon.corners[corner].point.pair);
  };
  const Vec<Word, 2> a = careful_corner(state.edge.from);
  const Vec<Word, 2> b = careful_corner(state.edge.to);

  Proof<R, 2> out;
  Vec<R, 2> n = gjk::perpendicular<R, 2>({gjk::converted<R, Word, 2>(Vec<Word, 2>(b - a))});
  if (gjk::is_zero(n)) n = state.n;
  out.direction = n / gjk::careful_length(n);

  const R careful = prepared.careful_error();
  const R rough = prepared.simplex_error();
  Distance<R> nearest = segment_distance(a, b, careful);
  R size(0);
  for_each_edge(polygon, [&](int from, int to) {
    size = gjk::larger(size, gjk::dot(polygon.at(from), polygon.at(from)));
    const R distance_sq = segment_distance_sq<R>(polygon.at(from), polygon.at(to));
    if (from == state.edge.from || nearest.value < Traits::root(distance_sq) - rough) return;
    nearest.narrow(segment_distance(careful_corner(from), careful_corner(to), careful));
  });
  const R few = R(kDistanceRoundings) * u;
  const bool is_certain = R(4) * rough < nearest.lower && winds_once(polygon);
  if (is_certain) out.lower = nearest.lower - few * nearest.value;

  const R reach = careful_reach(out.direction, {}, query, prepared);
  out.upper = gjk::larger(R(reach + R(kReachRoundings<2>) * u * gjk::magnitude(reach) + careful),
                          out.lower);
  out.depth = gjk::smaller(gjk::larger(nearest.value, out.lower), out.upper);
  const R unit = u * Traits::root(size);
  out.is_tight = is_certain && reach - nearest.value <= R(kAllowedGap) * unit &&
                 out.upper - out.lower <= Traits::from(gjk::kAllowedWidth) * unit;
  out.face = contact_face(state, Vec<R, 2>(out.direction * out.depth), query, prepared);
  return out;
}

}  // namespace depth::detail
