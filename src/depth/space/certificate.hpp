#pragma once
// Proved bounds of the depth in space, which include what rounding can do.
//
// From below: the polytope is exactly the convex hull of its corners as they are kept, and each of
// them is a point of Z, up to rounding: no point of the boundary of Z is nearer to O than the
// nearest face, less that rounding. From above: by how far Z reaches along one direction X can
// leave Y. If this proves too little the same loop runs in exact arithmetic, from GJK's simplex.
// tests/depth holds all of it against exact answers.

#include "depth/reach.hpp"
#include "depth/result.hpp"
#include "depth/space/loop.hpp"
#include "gjk/proof/answer.hpp"

namespace depth::space::detail {

/// In the unit of the run.
template <class R>
struct Proof {
  bool is_tight = false;  ///< Certain, and as close as rounding lets bounds be.
  R depth = R(0);
  R lower = R(0);
  R upper = R(0);
  Vec<R, 3> direction = Vec<R, 3>::Zero();
  gjk::Simplex<R, 3> face;
};

/// How much farther than the nearest face Z may reach along its normal, in u times the size of Z,
/// before rounding must have kept the polytope from growing: tests/depth demands depths within 4.
inline constexpr int kAllowedGap = 2;

/// Bounds that are farther apart, in u times the size of Z, are not believed: tests/depth demands
/// 24. But for poses they are closer where the gap is: reach and root_below round 8 times each, a
/// corner twice.
inline constexpr int kAllowedWidth = 23;

/// Distance of O from a face of the polytope: 0 where it does not lie inside.
template <class R>
[[nodiscard]] auto inner_distance(const R& distance_sq) {
  using Traits = gjk::ScalarTraits<R>;
  return Traits::root(R(0) < distance_sq ? distance_sq : R(0));
}

/// How near the boundary of Z can be, if that of the polytope is as near as this face, and no
/// corner is farther from O than `size`.
template <class R>
[[nodiscard]] R boundary_below(const Face<R>& face, const R& size,
                               const gjk::Prepared<R, 3>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  if (!(R(0) < face.distance_sq)) return R(0);
  const R error = prepared.vertex_error + R(2) * Traits::unit_roundoff() * size;
  return gjk::larger(R(Traits::root_below(face.distance_sq) - error), R(0));
}

/// Length of the longest corner.
template <class R>
[[nodiscard]] R size_of(const Polytope<R>& polytope) {
  R size_sq(0);
  for (const gjk::SupportPoint<R, 3>& corner : polytope.corners)
    size_sq = gjk::larger(size_sq, gjk::dot(corner.w, corner.w));
  return gjk::ScalarTraits<R>::root(size_sq);
}

template <class N>
[[nodiscard]] gjk::Simplex<N, 3> simplex_of(const Polytope<N>& polytope, const Face<N>& face) {
  gjk::Simplex<N, 3> out;
  out.count = 3;
  for (int i = 0; i < 3; ++i) out.vertices[i] = polytope.corners[face.corners[i]];
  return out;
}

/// The pairs of a face, for functions that compute its corners anew.
template <class R, class N>
[[nodiscard]] gjk::Simplex<R, 3> pairs_of(const Polytope<N>& polytope, const Face<N>& face) {
  gjk::Simplex<R, 3> out;
  out.count = 3;
  for (int i = 0; i < 3; ++i) {
    out.vertices[i].pair = polytope.corners[face.corners[i]].pair;
  }
  return out;
}

/// Weights of the point of a triangle's edges that is nearest to O: those of the whole triangle
/// where it is so thin that its area is lost in rounding.
template <class R>
void weigh_edges(const std::array<Vec<R, 3>, 3>& corners, gjk::Simplex<R, 3>& out) {
  R least = std::numeric_limits<R>::infinity();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const auto from = static_cast<std::size_t>(i);
    const auto to = static_cast<std::size_t>(j);
    const Vec<R, 3> edge = corners[to] - corners[from];
    const R square = gjk::dot(edge, edge);
    const R along = R(0) < square ? R(-gjk::dot(corners[from], edge) / square) : R(0);
    const R share = std::clamp(along, R(0), R(1));
    const R distance = gjk::careful_length(Vec<R, 3>(corners[from] + share * edge));
    if (!(distance < least)) continue;
    least = distance;
    out.weights = {};
    out.weights[from] = R(1) - share;
    out.weights[to] = share;
  }
}

/// The face that holds the point t of the boundary, with its weights there: of all faces that are
/// about as near as t the one that comes closest to t. Triangles of one plane are many faces, and
/// the nearest of them need not be the one that has the foot of the perpendicular from O.
/// `exponent`: of the unit of the polytope, in that of the run.
template <class R, class S, class N>
[[nodiscard]] gjk::Simplex<R, 3> contact_face(const Polytope<N>& polytope, const Vec<R, 3>& t,
                                              const gjk::Query<S, 3>& query,
                                              const gjk::Prepared<R, 3>& prepared,
                                              int exponent = 0) {
  using Word = gjk::DoubleWord<R>;
  const R u = gjk::ScalarTraits<R>::unit_roundoff();
  const R slack = R(8) * R(prepared.vertex_error + R(2) * u * prepared.reach);
  const R as_far = gjk::ScalarTraits<R>::scaled(R(gjk::careful_length(t) + slack), -exponent);
  const Vec<Word, 3> from = gjk::converted<Word, R, 3>(t);
  gjk::Simplex<R, 3> best;
  R least = std::numeric_limits<R>::infinity();
  for (const Face<N>& face : polytope.faces) {
    if (face.is_outgrown || as_far < static_cast<R>(inner_distance(face.distance_sq))) continue;
    gjk::Simplex<R, 3> out = pairs_of<R>(polytope, face);
    gjk::Simplex<Word, 3> seen = gjk::careful_simplex(out, query, prepared);
    for (int i = 0; i < 3; ++i) seen.vertices[i].w = seen.vertices[i].w - from;
    std::array<Vec<R, 3>, 3> corners;
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(i)] = gjk::converted<R, Word, 3>(seen.vertices[i].w);
    out.weights = gjk::weights_of<R>(seen);
    if (!std::all_of(out.weights.begin(), out.weights.end(), gjk::ScalarTraits<R>::is_finite))
      weigh_edges(corners, out);
    Vec<R, 3> off = Vec<R, 3>::Zero();
    for (std::size_t i = 0; i < 3; ++i) off = off + Vec<R, 3>(corners[i] * out.weights[i]);
    const R distance = gjk::careful_length(off);
    if (!(distance < least)) continue;
    least = distance;
    best = out;
  }
  for (int i = 0; i < best.count; ++i) {
    best.vertices[i] = gjk::support_point(query, prepared, best.vertices[i].pair);
  }
  return best;
}

/// Bounds of a run that rounded, but for the face of contact.
template <class R, class S>
[[nodiscard]] Proof<R> prove(const State<R>& state, const gjk::Query<S, 3>& query,
                             const gjk::Prepared<R, 3>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  using Word = gjk::DoubleWord<R>;
  const R u = Traits::unit_roundoff();
  const Polytope<R>& polytope = state.polytope;
  const Face<R>& face = polytope.faces[state.face];
  const R size = size_of(polytope);
  Proof<R> out;
  out.lower = boundary_below(face, size, prepared);
  R reach(0);
  const auto look_along = [&](const Vec<R, 3>& n) {
    const R length = gjk::careful_length(n);
    if (!(R(0) < length)) return;
    const Vec<R, 3> direction = n / length;
    const R found = depth::detail::careful_reach(direction, query, prepared);
    if (!gjk::is_zero(out.direction) && !(found < reach)) return;
    out.direction = direction;
    reach = found;
  };
  // The normal of the corners as they are, and if that turns too much as they are kept.
  const gjk::Simplex<Word, 3> careful =
      gjk::careful_simplex(pairs_of<R>(polytope, face), query, prepared);
  look_along(gjk::converted<R, Word, 3>(gjk::normal_of(careful, careful.all())));
  const R nearest = inner_distance(face.distance_sq);
  const auto is_close = [&] { return reach - nearest <= R(kAllowedGap) * u * size; };
  if (gjk::is_zero(out.direction) || !is_close()) look_along(state.n);

  const R rounding =
      R(depth::detail::kReachRoundings<3>) * u * gjk::magnitude(reach) + prepared.careful_error();
  out.upper = gjk::larger(R(reach + rounding), out.lower);
  out.depth = gjk::smaller(gjk::larger(reach, out.lower), out.upper);
  out.is_tight =
      R(0) < out.lower && is_close() && out.upper - out.lower <= R(kAllowedWidth) * u * size;
  return out;
}

/// The same run in exact arithmetic, from GJK's simplex. False, with `out` as it was, when there is
/// no room for exact products.
template <class R, class S>
[[nodiscard, gnu::noinline]] bool settle(const gjk::Result<R, 3>& found,
                                         const gjk::Query<S, 3>& query,
                                         const gjk::Prepared<R, 3>& prepared, Proof<R>& out) {
  using Wide = gjk::Wider<R>;
  const auto exact = gjk::prepared_exactly(query, prepared);
  if (!gjk::has_exact_products(query, prepared.same_frame, exact.exponent)) return false;
  State<Expansion> end = start(query, exact, found);
  run(end, query, exact);
  const Face<Expansion>& face = end.polytope.faces[end.face];

  const Vec<Wide, 3> n = gjk::converted<Wide, Expansion, 3>(end.n);
  const Wide n_length = gjk::careful_length(n);
  for (int i = 0; i < 3; ++i) out.direction[i] = static_cast<R>(n[i] / n_length);
  out.is_tight = true;
  out.depth = out.lower = out.upper = R(0);
  if (found.verdict == gjk::Verdict::touching) return true;

  const Vec<Expansion, 3> along_it = gjk::converted<Expansion, R, 3>(out.direction);
  const auto farthest =
      gjk::support_point(query, exact, gjk::farthest_pair(query, exact, along_it));
  const Wide direction_length = gjk::length(gjk::converted<Wide, Expansion, 3>(along_it));
  const Wide reach =
      gjk::ScalarTraits<Wide>::from(gjk::dot(along_it, farthest.w)) / direction_length;
  const Wide nearest = std::sqrt(gjk::ScalarTraits<Wide>::from(face.distance_sq));

  constexpr int kRoundings = 6;  // of a few in Wide, and those below
  const R few = R(kRoundings) * gjk::ScalarTraits<R>::unit_roundoff();
  const R least = std::numeric_limits<R>::denorm_min();
  const int exponent = exact.exponent - prepared.exponent;
  const R lower = static_cast<R>(nearest);
  const R upper = static_cast<R>(reach);
  out.depth = gjk::ScalarTraits<R>::scaled(upper, exponent);
  out.lower = gjk::scaled_below(std::max(R(lower - few * lower - least), R(0)), exponent);
  out.upper = gjk::scaled_above(R(upper + few * upper + least), exponent);
  out.depth = std::clamp(out.depth, out.lower, out.upper);
  const Vec<R, 3> t = out.direction * out.depth;
  out.face = contact_face(end.polytope, t, query, prepared, exponent);
  return true;
}

}  // namespace depth::space::detail
