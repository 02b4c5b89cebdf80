#pragma once
// The state of a run between two phases: a plain value, so that a trace can keep every one.

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
  repeated_support,  ///< The support point is already in the simplex: Z reaches no farther along d.
  origin_inside,     ///< O lies inside a full simplex: the shapes overlap.
  zero_direction,    ///< d = 0: O lies on the simplex.
  no_progress,       ///< The support point is no farther along d than the simplex, or P no nearer.
  within_tolerance,  ///< The certified bounds are as close as Options::tolerance asked for.
  iteration_cap,     ///< The run gave up. Its bounds hold, but may be wide.
  failed,            ///< The query was refused; see Error.
};

/// Lengths are in the run's unit, 2^Prepared::exponent: 1 for all but extreme coordinates.
template <class S, int D>
struct State {
  Phase phase = Phase::closest;  ///< The phase to run next; stop once the run has ended.
  Phase previous = Phase::add;   ///< The phase that ran last: several lead to stop.
  int iteration = 1;
  Simplex<S, D> simplex;
  Face region = 0;  ///< Between closest and cull, the face that holds P; else the whole simplex.
  Vec<S, D> p = Vec<S, D>::Zero();  ///< Closest point of the simplex to O.
  S p_sq = S(0);                    ///< |p|^2, as take_region computes it.
  Vec<S, D> d = Vec<S, D>::Zero();  ///< Search direction, in world axes.
  SupportPoint<S, D> support;       ///< Farthest point of Z along d.
  S support_value = S(0);           ///< dot(d, support.w)

  Simplex<S, D> best;  ///< The culled simplex whose P came nearest to O so far.
  S best_sq = S(0);    ///< The p_sq of `best`; meaningful once `best.count` > 0.

  /// Squared distance from O of the farthest support plane so far that separates O from Z, rounding
  /// not subtracted; 0 when no plane has separated them yet.
  S plane_distance_sq = S(0);
  S plane_reach_sq = S(0);     ///< |w|^2 of that plane's support point, to bound its rounding.
  bool touches_plane = false;  ///< Some support plane has passed through O: dot(d, w) was 0.

  StopReason stop = StopReason::running;
  Error error = Error::none;
};

}  // namespace gjk
