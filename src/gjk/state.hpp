#pragma once
// What is known between two phases of a run: a plain value. Going back to an earlier step is an
// index into a trace, not an undo.

#include "gjk/simplex.hpp"

namespace gjk {

/// The phases of one iteration, in order. Every run ends with a stop phase.
enum class Phase : std::uint8_t {
  closest,    ///< Closest point P of the simplex to O, by region tests.
  cull,       ///< Drop the vertices that have no weight in P.
  direction,  ///< Build the search direction d.
  support,    ///< Find the support point of Z in direction d.
  stop,       ///< Stop tests.
  add,        ///< Add the support point to the simplex.
};
inline constexpr int kPhaseCount = 6;

/// Why a run ended.
enum class StopReason : std::uint8_t {
  running,           ///< It has not ended yet.
  repeated_support,  ///< The support point is already in the simplex: no point of Z lies farther
                     ///< along d.
  origin_inside,     ///< O lies inside a full simplex: the shapes overlap.
  zero_direction,    ///< d = 0: O lies on the simplex.
  no_progress,       ///< The support point lies no farther along d than the simplex, or P came no
                     ///< nearer.
  within_tolerance,  ///< The certified bounds are as close as Options::tolerance asked for.
  iteration_cap,     ///< Gave up. The bounds still hold; the distance between them is not decided.
  failed,            ///< The query was refused; see Error.
};

/// Lengths are in units of 2^Prepared::exponent, which is 1 for all but extreme coordinates.
template <class S, int D>
struct State {
  Phase phase = Phase::closest;  ///< The phase to run next; when the run has ended, the last one.
  Phase previous =
      Phase::add;  ///< The phase that led here: cull and direction may lead to stop, too.
  int iteration = 1;
  Simplex<S, D> simplex;
  Face region = 0;                  ///< The face of `simplex` that holds P, from closest to cull.
  Vec<S, D> p = Vec<S, D>::Zero();  ///< Closest point of the simplex to O.
  S p_sq = S(0);                    ///< |p|^2; see detail::facet_distance_sq.
  Vec<S, D> d = Vec<S, D>::Zero();  ///< Search direction, in world axes.
  SupportPoint<S, D> support;       ///< Farthest point of Z along d.
  S support_value = S(0);           ///< dot(d, support.w)

  Simplex<S, D> best;  ///< The simplex, culled, whose P came nearest so far.
  S best_sq = S(0);    ///< Its |p|^2; meaningful once `best.count` > 0.

  /// Squared distance of the farthest support plane so far that has O on one side and all of Z on
  /// the other, as computed: rounding is not subtracted. 0: no plane has separated the shapes yet.
  S plane_distance_sq = S(0);
  S plane_reach_sq = S(0);     ///< |w|^2 of its support point: what rounding is relative to.
  bool touches_plane = false;  ///< Some support plane passes exactly through O.

  StopReason stop = StopReason::running;
  Error error = Error::none;
};

}  // namespace gjk
