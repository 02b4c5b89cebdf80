#pragma once
// Proved bounds of the depth, which include what rounding can do.
//
// From below: the polygon's corners are points of Z, up to rounding, so all that it goes around
// lies in Z, whether or not rounding has left it convex: no point of the boundary of Z is nearer to
// O than its nearest edge. From above: by how far Z reaches along one direction X can leave Y.
// If this proves too little the same loop runs in exact arithmetic, from GJK's simplex.
// tests/depth holds all of it against exact answers.

#include "depth/loop.hpp"
#include "depth/reach.hpp"
#include "depth/result.hpp"
#include "gjk/proof/careful.hpp"
#include "gjk/proof/certificate.hpp"
#include "gjk/proof/settle.hpp"

namespace depth::detail {

/// In the unit of the run.
template <class R>
struct Proof {
  bool is_tight = false;  ///< Certain, and as close as rounding lets bounds be.
  R depth = R(0);
  R lower = R(0);
  R upper = R(0);
  Vec<R, 2> direction = Vec<R, 2>::Zero();
  gjk::Simplex<R, 2> edge;
};

/// How much farther than the nearest edge Z may reach along its normal, in u times the size of Z,
/// before rounding must have kept the polygon from growing: tests/depth demands depths within 4.
inline constexpr int kAllowedGap = 2;

/// The edges go once around O, counter-clockwise: they cross the positive x-axis upwards once more
/// than downwards. False, too, where rounding leaves that open.
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
  const Vec<N, 2> exact_way = b - a;
  const Vec<R, 2> from = gjk::converted<R>(a);
  const Vec<R, 2> way = gjk::converted<R>(exact_way);
  const R length = gjk::careful_length(way);
  const R foot = length == R(0) ? R(0) : R(-gjk::dot(from, way) / length);  // from a
  const R beyond = R(8) * gjk::ScalarTraits<R>::unit_roundoff() * gjk::careful_length(from);
  if (length == R(0) || foot < -beyond || length + beyond < foot) {
    const R distance =
        foot < length ? gjk::careful_length(from) : gjk::careful_length(gjk::converted<R>(b));
    return {distance, distance - error};
  }
  const R distance = gjk::ScalarTraits<R>::from(gjk::cross(a, exact_way)) / length;
  return {distance, distance - error * (R(2) + R(2) * beyond / length)};
}

/// The edge that holds the point nearest to O, with its weights. Of two edges that are nearly one
/// line, distances alone may have chosen the one beside which the foot of the perpendicular lies:
/// then the point is as far along the other. `foot`: from the first end of `nearest`, which is
/// `length` long.
template <class Wide, class R, class S, class N>
[[nodiscard]] gjk::Simplex<R, 2> contact_edge(const Polygon<N>& polygon, const Edge<N>& nearest,
                                              const Wide& foot, const Wide& length,
                                              const gjk::Query<S, 2>& query,
                                              const gjk::Prepared<R, 2>& prepared) {
  std::array<int, 2> ends = {nearest.from, nearest.to};
  Wide from_first = foot;
  Wide way = length;
  const auto step_to = [&](int first, int second, const Wide& beyond) {
    const Vec<N, 2> edge = polygon.at(second) - polygon.at(first);
    ends = {first, second};
    from_first = beyond;
    way = gjk::careful_length(gjk::converted<Wide>(edge));
  };
  if (foot < Wide(0)) {
    step_to(nearest.from, polygon.corners[nearest.from].previous, Wide(-foot));
  } else if (length < foot) {
    step_to(nearest.to, polygon.corners[nearest.to].next, Wide(foot - length));
  }
  gjk::Simplex<R, 2> out;
  for (int i = 0; i < 2; ++i) {
    const gjk::VertexPair pair = polygon.corners[ends[i]].point.pair;
    out.vertices[i] = gjk::support_point(query, prepared, pair);
  }
  out.count = ends[0] == ends[1] ? 1 : 2;
  if (out.count == 2) out.weights[1] = from_first < way ? static_cast<R>(from_first / way) : R(1);
  out.weights[0] = R(1) - out.weights[1];
  return out;
}

/// Bounds of a run that rounded.
template <class R, class S>
[[nodiscard]] Proof<R> prove(const State<R>& state, const gjk::Query<S, 2>& query,
                             const gjk::Prepared<R, 2>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  const R u = Traits::unit_roundoff();
  const Polygon<R>& polygon = state.polygon;
  const auto careful_corner = [&](int corner) {
    return careful_vertex(query, prepared, polygon.corners[corner].point.pair);
  };
  const Vec<gjk::DoubleWord<R>, 2> a = careful_corner(state.edge.from);
  const Vec<gjk::DoubleWord<R>, 2> b = careful_corner(state.edge.to);

  Proof<R> out;
  Vec<R, 2> way = gjk::converted<R>(Vec<gjk::DoubleWord<R>, 2>(b - a));
  if (gjk::is_zero(way)) way = {-state.n[1], state.n[0]};
  const R length = gjk::careful_length(way);
  out.direction = gjk::perpendicular<R, 2>({way}) / length;
  const R foot = -gjk::dot(gjk::converted<R>(a), way) / length;
  out.edge = contact_edge(polygon, state.edge, foot, length, query, prepared);

  const R careful = prepared.careful_error();
  const R rough = prepared.simplex_error();
  Distance<R> nearest = segment_distance(a, b, careful);
  R size(0);
  for_each_edge(polygon, [&](int from, int to) {
    size = gjk::larger(size, gjk::dot(polygon.at(from), polygon.at(from)));
    const R distance_sq = segment_distance_sq<R>(polygon.at(from), polygon.at(to));
    if (nearest.value < Traits::root(distance_sq) - rough) return;
    nearest.narrow(segment_distance(careful_corner(from), careful_corner(to), careful));
  });
  const R few = R(kDistanceRoundings) * u;
  const bool is_certain = R(4) * rough < nearest.lower && winds_once(polygon);
  if (is_certain) out.lower = nearest.lower - few * nearest.value;

  const R reach = careful_reach(out.direction, query, prepared);
  out.upper = gjk::larger(R(reach + R(kReachRoundings<2>) * u * gjk::magnitude(reach) + careful),
                          out.lower);
  out.depth = gjk::smaller(gjk::larger(nearest.value, out.lower), out.upper);
  const R unit = u * Traits::root(size);
  out.is_tight = is_certain && reach - nearest.value <= R(kAllowedGap) * unit &&
                 out.upper - out.lower <= Traits::from(gjk::kAllowedWidth) * unit;
  return out;
}

/// The same run in exact arithmetic, from GJK's simplex. False, with `out` as it was, when there is
/// no room for exact products.
template <class R, class S>
[[nodiscard, gnu::noinline]] bool settle(const gjk::Result<R, 2>& found,
                                         const gjk::Query<S, 2>& query,
                                         const gjk::Prepared<R, 2>& prepared, Proof<R>& out) {
  using gjk::Expansion;
  using Wide = gjk::Wider<R>;
  const auto exact = gjk::prepared_exactly(query, prepared);
  if (!gjk::has_exact_products(query, prepared.same_frame, exact.exponent)) return false;
  State<Expansion> end = start(query, exact, found);
  run(end, query, exact);
  const Polygon<Expansion>& polygon = end.polygon;
  const Vec<Expansion, 2>& a = polygon.at(end.edge.from);
  const Vec<Expansion, 2>& b = polygon.at(end.edge.to);
  const auto narrow = [](const Wide& value) { return static_cast<R>(value); };

  const Vec<Wide, 2> n = gjk::converted<Wide>(end.n);
  const Wide n_length = gjk::careful_length(n);
  const Vec<Wide, 2> from = gjk::converted<Wide>(a);
  out.direction = {narrow(n[0] / n_length), narrow(n[1] / n_length)};
  const Wide foot = Wide(n[1] * from[0] - n[0] * from[1]) / n_length;
  out.edge = contact_edge(polygon, end.edge, foot, n_length, query, prepared);
  out.is_tight = true;
  out.depth = out.lower = out.upper = R(0);
  if (gjk::dot(end.n, a) == Expansion()) return true;

  // Edges compare by rounded distances: look at those that may be as near once more.
  Distance<Wide> nearest = segment_distance(a, b, Wide(0));
  for_each_edge(polygon, [&](int from_corner, int to_corner) {
    const Vec<Expansion, 2>& c = polygon.at(from_corner);
    const Vec<Expansion, 2>& d = polygon.at(to_corner);
    const Wide distance(gjk::ScalarTraits<Expansion>::root(segment_distance_sq(c, d)));
    if (distance * Wide(1.0 - 0x1p-44) <= nearest.value) {
      nearest.narrow(segment_distance(c, d, Wide(0)));
    }
  });
  const Vec<Expansion, 2> along_it = gjk::converted<Expansion, R, 2>(out.direction);
  const auto farthest =
      gjk::support_point(query, exact, gjk::farthest_pair(query, exact, along_it));
  const Wide direction_length = gjk::length(gjk::converted<Wide>(along_it));
  const Wide reach =
      gjk::ScalarTraits<Wide>::from(gjk::dot(along_it, farthest.w)) / direction_length;

  const R u = gjk::ScalarTraits<R>::unit_roundoff();
  const R few = R(kDistanceRoundings) * u;
  const R least = std::numeric_limits<R>::denorm_min();
  const int exponent = exact.exponent - prepared.exponent;
  const R depth = narrow(nearest.value);
  const R upper = narrow(reach);
  out.depth = gjk::ScalarTraits<R>::scaled(depth, exponent);
  out.lower = gjk::scaled_below(std::max(R(depth - few * depth - least), R(0)), exponent);
  out.upper = gjk::scaled_above(R(upper + few * upper + least), exponent);
  out.depth = std::clamp(out.depth, out.lower, out.upper);
  return true;
}

}  // namespace depth::detail
