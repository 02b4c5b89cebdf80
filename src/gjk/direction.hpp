#pragma once
// Phase "direction": where to look for the next vertex.

#include "gjk/state.hpp"

namespace gjk::detail {

/// Derivation: a facet's normal n does not depend on P, needs no division, and is perpendicular to
/// the facet as well as one rounding allows. Its sign is fixed so that dot(n, O - A) > 0 (Catto
/// 2010, slide "Fixing the sign"). Below a facet (a vertex; in space also an edge) the normal is
/// not unique and d = O - P.
template <class S, int D>
[[nodiscard]] DirectionNote<S, D> facet_direction(const Simplex<S, D>& simplex) {
  std::array<Vec<S, D>, D - 1> edges;
  for (int i = 0; i < D - 1; ++i) edges[i] = simplex.vertices[i + 1].w - simplex.vertices[0].w;
  DirectionNote<S, D> note;
  note.from_normal = true;
  note.normal = perpendicular<S, D>(edges);
  note.side = -dot(note.normal, simplex.vertices[0].w);
  note.flipped = note.side < S(0);
  note.sign_is_arbitrary = note.side == S(0);
  return note;
}

template <class S, int D, class Rec>
void build_direction(State<S, D>& state, const Options& options, Rec& record) {
  DirectionNote<S, D> note;
  state.d = -state.p;
  if (options.direction_rule == DirectionRule::perpendicular && state.simplex.count == D) {
    note = facet_direction(state.simplex);
    // A facet whose vertices coincide to the last bit has no normal.
    if (!is_zero(note.normal)) {
      state.d = note.flipped ? Vec<S, D>(-note.normal) : note.normal;
    } else {
      note.from_normal = false;
    }
  }
  if constexpr (Rec::kOn) record.direction = note;
  state.previous = Phase::direction;
  state.phase = is_zero(state.d) ? Phase::stop : Phase::support;
}

}  // namespace gjk::detail
