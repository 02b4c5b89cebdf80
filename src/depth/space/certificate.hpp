#pragma once
// The certificate's part in space. The polytope is exactly the convex hull of its corners as they
// are kept, so all that can put its nearest face outside of Z is what rounding moved them by.

#include "depth/loop.hpp"
#include "depth/proof.hpp"
#include "gjk/proof/answer.hpp"

namespace depth::detail {

/// Bounds that are farther apart, in u times the size of Z, are not believed: tests/depth demands
/// 24. But for poses they are closer where the gap is: reach and root_below round 8 times each, a
/// corner twice.
inline constexpr int kAllowedWidthInSpace = 23;

/// Length of the longest corner.
template <class R>
[[nodiscard]] auto size_of(const space::Polytope<R>& polytope) {
  R size_sq(0);
  for (const gjk::SupportPoint<R, 3>& corner : polytope.corners)
    size_sq = gjk::larger(size_sq, gjk::dot(corner.w, corner.w));
  return gjk::ScalarTraits<R>::root(size_sq);
}

/// Distance of O from the polytope, squared, or 0 where it does not lie inside. Faces that rounding
/// could confuse with the nearest are measured with all digits.
template <class R>
[[nodiscard]] auto inner_distance_sq(const State<R, 3>& state) {
  using N = space::Plain<R>;
  const space::Polytope<R>& polytope = state.polytope;
  const auto measured = [&](int face) {
    return space::careful_plane(polytope.triangle(polytope.faces[face].corners)).distance_sq;
  };
  N least = measured(state.face);
  N as_near = least;
  if constexpr (space::kPlaneRounds<R>) {
    const N u = gjk::ScalarTraits<N>::unit_roundoff();
    const N farther = gjk::ScalarTraits<N>::root(gjk::larger(least, N(0))) +
                      N(space::kPlaneRoundings) * u * N(size_of(polytope));
    as_near = farther * farther;
  }
  for (const int face : polytope.hull) {
    if (face != state.face && polytope.faces[face].distance_sq < as_near)
      least = gjk::smaller(least, measured(face));
  }
  return gjk::larger(least, N(0));
}
template <class Wide, class R>
[[nodiscard]] Wide exact_distance(const State<R, 3>& end) {
  return std::sqrt(Wide(inner_distance_sq(end)));
}

/// How near the boundary of Z can be, if that of the polytope is as near as this, rounded: a corner
/// is off by its error and twice the rounding of its length.
template <class R>
[[nodiscard]] R distance_below(const R& distance, const State<R, 3>& state,
                               const gjk::Prepared<R, 3>& prepared) {
  const R u = gjk::ScalarTraits<R>::unit_roundoff();
  const R error = prepared.vertex_error + R(2) * u * size_of(state.polytope);
  return gjk::larger(R(distance - R(8) * u * distance - error), R(0));
}
template <class R>
[[nodiscard]] auto distance_below(const State<R, 3>& state, const gjk::Prepared<R, 3>& prepared) {
  using Traits = gjk::ScalarTraits<R>;
  if constexpr (Traits::kExact)
    return Traits::root_below(inner_distance_sq(state));
  else
    return distance_below<R>(Traits::root(inner_distance_sq(state)), state, prepared);
}

/// A face with its corners as they are kept.
template <class R, class N>
[[nodiscard]] gjk::Simplex<R, 3> simplex_of(const space::Polytope<N>& polytope, int face) {
  gjk::Simplex<R, 3> out;
  out.count = 3;
  for (int i = 0; i < 3; ++i) {
    const gjk::SupportPoint<N, 3>& corner = polytope.corners[polytope.faces[face].corners[i]];
    out.vertices[i] = {gjk::converted<R, N, 3>(corner.w), corner.pair};
  }
  return out;
}

/// The face that holds the nearest point, with its weights: of all faces in the plane of the
/// nearest one that in which no weight is negative.
template <class R>
[[nodiscard]] gjk::Simplex<R, 3> exact_contact_face(const State<R, 3>& state) {
  const R reach = gjk::dot(state.n, nearest_corner(state, 0).w);
  const R& nearest_sq = state.polytope.faces[state.face].distance_sq;
  for (const int face : state.polytope.hull) {
    if (!(state.polytope.faces[face].distance_sq == nearest_sq)) continue;
    gjk::Simplex<R, 3> out = simplex_of<R>(state.polytope, face);
    const auto coordinates = gjk::triangle_coordinates(out, 0, 1, 2);
    bool holds = true;
    for (int i = 0; i < 3; ++i) {
      holds = holds && gjk::dot(state.n, out.vertices[i].w) == reach &&
              !(coordinates.numerator[i] < R(0));
    }
    if (!holds) continue;
    gjk::set_weights<R, 3>(out.weights, out.all(), coordinates);
    return out;
  }
  return {};
}

/// The face that holds the point t of the boundary, with its weights there: of all faces that are
/// about as near as t the one that comes closest to t. Triangles of one plane are many faces, and
/// the nearest of them need not be the one that has the foot of the perpendicular from O: if it is,
/// no other one is looked at.
/// `exponent`: of the unit of the polytope, in that of the run; `known`: the nearest face with
/// about twice the digits, where that is known.
template <class R, class S, class N, class Word = gjk::DoubleWord<R>>
[[nodiscard]] gjk::Simplex<R, 3> contact_face(const State<N, 3>& state, const Vec<R, 3>& t,
                                              const gjk::Query<S, 3>& query,
                                              const gjk::Prepared<R, 3>& prepared, int exponent = 0,
                                              const gjk::Simplex<Word, 3>* known = nullptr) {
  const R u = gjk::ScalarTraits<R>::unit_roundoff();
  const R slack = R(8) * R(prepared.vertex_error + R(2) * u * prepared.reach);
  const R as_far = gjk::ScalarTraits<R>::scaled(R(gjk::careful_length(t) + slack), -exponent);
  const Vec<Word, 3> from = gjk::converted<Word, R, 3>(t);
  gjk::Simplex<R, 3> best;
  R least = std::numeric_limits<R>::infinity();
  const std::vector<int>& hull = state.polytope.hull;
  for (int k = -1; k < static_cast<int>(hull.size()); ++k) {
    const int face = k < 0 ? state.face : hull[k];
    const R distance_sq = static_cast<R>(state.polytope.faces[face].distance_sq);
    if (as_far < gjk::ScalarTraits<R>::root(gjk::larger(distance_sq, R(0)))) continue;
    gjk::Simplex<R, 3> out = simplex_of<R>(state.polytope, face);
    gjk::Simplex<Word, 3> careful =
        k < 0 && known != nullptr ? *known : gjk::careful_simplex(out, query, prepared);
    for (int i = 0; i < 3; ++i) {
      careful.vertices[i].w = careful.vertices[i].w - from;
      out.vertices[i].w = gjk::converted<R, Word, 3>(careful.vertices[i].w);
    }
    out.weights = gjk::weights_in_plane(careful);
    if (!std::all_of(out.weights.begin(), out.weights.end(), gjk::ScalarTraits<R>::is_finite)) {
      const gjk::Face nearest = gjk::nearest_face(out);  // its area is lost in rounding
      gjk::set_weights<R, 3>(out.weights, nearest, gjk::barycentric(out, nearest));
    }
    const R distance = gjk::careful_length(gjk::weighted_point(out, out.all(), out.weights));
    if (!(distance < least)) continue;
    least = distance;
    best = out;
    if (k < 0 && std::count(out.weights.begin(), out.weights.end(), R(0)) == 1) break;
  }
  for (int i = 0; i < best.count; ++i)
    best.vertices[i] = gjk::support_point(query, prepared, best.vertices[i].pair);
  return best;
}

/// Bounds of a run that rounded, and the face of contact.
template <class R, class S>
[[nodiscard]] Proof<R, 3> prove(const State<R, 3>& state, const gjk::Query<S, 3>& query,
                                const gjk::Prepared<R, 3>& prepared) {
  using Word = gjk::DoubleWord<R>;
  const R u = gjk::ScalarTraits<R>::unit_roundoff();
  const R unit = u * size_of(state.polytope);
  const R nearest = gjk::ScalarTraits<R>::root(inner_distance_sq(state));
  Proof<R, 3> out;
  out.lower = distance_below<R>(nearest, state, prepared);
  // The normal of the corners as they are, and if that turns too much as they are kept.
  const gjk::Simplex<Word, 3> careful =
      gjk::careful_simplex(simplex_of<R>(state.polytope, state.face), query, prepared);
  R reach(0);
  const auto look_along = [&](const Vec<R, 3>& n) {
    const R length = gjk::careful_length(n);
    if (!(R(0) < length)) return;
    const Vec<R, 3> direction = n / length;
    const R found = careful_reach(direction, careful, query, prepared);
    if (!gjk::is_zero(out.direction) && !(found < reach)) return;
    out.direction = direction;
    reach = found;
  };
  look_along(gjk::converted<R, Word, 3>(gjk::normal_of(careful, careful.all())));
  const auto is_close = [&] { return reach - nearest <= R(kAllowedGap) * unit; };
  if (gjk::is_zero(out.direction) || !is_close()) look_along(state.n);

  const R rounding = R(kReachRoundings<3>) * u * gjk::magnitude(reach) + prepared.careful_error();
  out.upper = gjk::larger(R(reach + rounding), out.lower);
  out.depth = gjk::smaller(gjk::larger(reach, out.lower), out.upper);
  out.is_tight =
      R(0) < out.lower && is_close() && out.upper - out.lower <= R(kAllowedWidthInSpace) * unit;
  const Vec<R, 3> t = out.direction * out.depth;
  out.face = contact_face(state, t, query, prepared, 0, &careful);
  return out;
}

}  // namespace depth::detail
