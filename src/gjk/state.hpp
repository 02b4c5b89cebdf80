#pragma once
// The state of a run between two phases: a plain value, so that a trace can keep every one.

#include "gjk/proof/evidence.hpp"

namespace gjk {

/// The phases of one iteration, in order. Every run ends with a stop phase.
enum class Phase : std::uint8_t {
  closest,    ///< Closest point P of the simplex to O, by region tests.
  drop,       ///< Drop the vertices that have no weight in P.
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
  not_nearer,        ///< P came no nearer to O than before, so that no direction is asked for.
  no_progress,       ///< The support point is no farther along d than the simplex.
  within_tolerance,  ///< The certified bounds are as close as Options::tolerance asked for.
  iteration_cap,     ///< The run gave up. Its bounds hold, but may be wide.
  failed,            ///< The query was refused; see Error.
};

/// The place of a walk. Lengths are in the run's unit, 2^Frames::exponent: 1 for all but extreme
/// coordinates.
template <class R, int D>
struct State {
  Phase phase = Phase::closest;  ///< The phase to run next; stop once the run has ended.
  Phase previous = Phase::add;   ///< The phase that ran last; more than one can lead to stop.
  int iteration = 1;
  Simplex<R, D> simplex;
  Face region = 0;  ///< Between closest and drop, the face that holds P; else the whole simplex.
  Vec<R, D> p = Vec<R, D>::Zero();  ///< Closest point of the simplex to O.
  R p_sq = R(0);                    ///< |p|^2, as take_region computes it.
  Vec<R, D> d = Vec<R, D>::Zero();  ///< Search direction, in world axes.
  SupportPoint<R, D> support;       ///< Farthest point of Z along d.
  R support_value = R(0);           ///< dot(d, support.w)

  Evidence<R, D> evidence;  ///< Read by the certificate; the walk asks it whether P came nearer.
  StopReason stop = StopReason::running;
  Error error = Error::none;
};

}  // namespace gjk
