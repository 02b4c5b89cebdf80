#pragma once
// Phase "direction": the direction in which to look for the next vertex.

#include "gjk/record.hpp"

namespace gjk {

/// The direction that `rule` builds from the 1 to D vertices of P's face and its closest point.
///
/// towards_origin: d = O - P. perpendicular: from the simplex alone, without a division:
///   vertex A            -A
///   edge in space       e x (e x A) with e = B - A: the normal of the edge that points to O
///   edge in the plane,  its normal, with the sign that makes dot(d, O - A) > 0 (Catto 2010, slide
///   triangle in space   "Fixing the sign")
/// If that is 0 (coinciding or collinear points, O on an edge's line), d = O - P.
template <class R, int D>
[[nodiscard]] DirectionNote<R, D> search_direction(const Simplex<R, D>& simplex, const Vec<R, D>& p,
                                                   DirectionRule rule) {
  DirectionNote<R, D> note;
  note.d = -p;
  if (rule != DirectionRule::perpendicular || simplex.count == 1) return note;
  const Vec<R, D>& a = simplex.vertices[0].w;
  if constexpr (D == 3) {
    if (simplex.count == 2) {
      const Vec<R, D> edge = simplex.vertices[1].w - a;
      const Vec<R, D> towards_origin = cross(edge, cross(edge, a));
      if (!is_zero(towards_origin)) note.d = towards_origin;
      return note;
    }
  }
  const Vec<R, D> normal = normal_of(simplex, simplex.all());
  if (is_zero(normal)) return note;
  note.from_normal = true;
  note.normal = normal;
  note.side = -dot(normal, a);
  note.flipped = note.side < R(0);
  note.sign_is_arbitrary = note.side == R(0);
  note.d = note.flipped ? Vec<R, D>(-normal) : normal;
  return note;
}

template <class R, int D, class Rec>
void build_direction(State<R, D>& state, const Options& options, Rec& record) {
  const DirectionNote<R, D> note = search_direction(state.simplex, state.p, options.direction_rule);
  state.d = note.d;
  if constexpr (Rec::kOn) record.direction = note;
  state.previous = Phase::direction;
  state.phase = is_zero(state.d) ? Phase::stop : Phase::support;
}

}  // namespace gjk
