#pragma once
// Phase "direction": where to look for the next vertex.

#include "gjk/state.hpp"

namespace gjk {

/// The direction that `rule` builds from a culled simplex and its closest point.
///
/// perpendicular: a facet's normal does not depend on P, needs no division, and is as perpendicular
/// to the facet as one rounding allows. Its sign is fixed so that dot(d, O - A) > 0 (Catto 2010,
/// slide "Fixing the sign"). Below a facet (a vertex; in space also an edge) the normal is not
/// unique, and a facet of coinciding points has none: then d = O - P.
template <class S, int D>
[[nodiscard]] DirectionNote<S, D> search_direction(const Simplex<S, D>& simplex, const Vec<S, D>& p,
                                                   DirectionRule rule) {
  DirectionNote<S, D> note;
  note.d = -p;
  if (rule != DirectionRule::perpendicular || simplex.count != D) return note;
  std::array<Vec<S, D>, D> facet;
  for (int i = 0; i < D; ++i) facet[i] = simplex.vertices[i].w;
  const Vec<S, D> normal = perpendicular<S, D>(edges_of(facet));
  if (is_zero(normal)) return note;
  note.from_normal = true;
  note.normal = normal;
  note.side = -dot(normal, simplex.vertices[0].w);
  note.flipped = note.side < S(0);
  note.sign_is_arbitrary = note.side == S(0);
  note.d = note.flipped ? Vec<S, D>(-normal) : normal;
  return note;
}

namespace detail {

template <class S, int D, class Rec>
void build_direction(State<S, D>& state, const Options& options, Rec& record) {
  const DirectionNote<S, D> note = search_direction(state.simplex, state.p, options.direction_rule);
  state.d = note.d;
  if constexpr (Rec::kOn) record.direction = note;
  state.previous = Phase::direction;
  state.phase = is_zero(state.d) ? Phase::stop : Phase::support;
}

}  // namespace detail
}  // namespace gjk
