#pragma once
// The state between two phases of a run, and the notes of one phase while it ran: plain values, as
// in gjk/state.hpp. Here is what runs in both dimensions have; plane/polygon.hpp adds the polygon
// that expands in the plane, space/polytope.hpp the polytope in space.

#include <algorithm>
#include <vector>

#include "gjk/support.hpp"

namespace depth {

using gjk::Vec;

/// The phases of one iteration, in order. Every run ends with a stop phase.
enum class Phase : std::uint8_t {
  nearest,  ///< Take the edge or face that is nearest to O, and its outward normal n.
  support,  ///< Find the support point of Z in direction n.
  stop,     ///< Stop tests.
  expand,   ///< Make the support point a corner.
};
inline constexpr int kPhaseCount = 4;

/// Why a run ended.
enum class StopReason : std::uint8_t {
  running,           ///< It has not ended yet.
  repeated_support,  ///< The support point is a corner of the nearest edge or face: no point of Z
                     ///< lies farther along n.
  no_progress,       ///< The support point lies no farther along n than the nearest edge or face.
  iteration_cap,     ///< Gave up. The bounds still hold.
  separated,         ///< O lies outside of Z: there is no depth, and nothing expands.
  undecided,         ///< GJK could not tell whether the shapes overlap: nothing expands.
  failed,            ///< The query was refused; see gjk::Error.
};

/// One stop test. Tests after the one that holds are listed, not tried.
template <class R>
struct StopTest {
  StopReason reason = StopReason::running;
  bool tried = false;
  bool holds = false;
  R left = R(0);  ///< The two values compared; which ones, `reason` tells (see run_stop_tests).
  R right = R(0);
};

/// Notes of one phase; the members of the other phases stay empty.
template <class R>
struct Notes {
  static constexpr bool kOn = true;
  std::vector<gjk::ScanEntry<R>> scan_x;
  std::vector<gjk::ScanEntry<R>> scan_y;
  std::vector<StopTest<R>> stop_tests;
  std::vector<int> outgrown;  ///< Corners of the polygon, or faces of the polytope, that are gone.
};
/// The notes with what else is of dimension D.
template <class R, int D = 2>
struct Record;
/// Stands in for Record where nothing is to be recorded.
using gjk::NoRecord;

/// How far a run has come. Lengths are in the unit of the GJK run; see gjk::Prepared::exponent.
template <class R, int D>
struct Progress {
  Phase phase = Phase::nearest;  ///< The phase to run next; when the run has ended, the last one.
  int iteration = 1;
  Vec<R, D> n = Vec<R, D>::Zero();       ///< Outward normal of the nearest edge or face.
  gjk::SupportPoint<R, D> support = {};  ///< Farthest point of Z along n.
  StopReason stop = StopReason::running;
};
/// The progress with what expands in dimension D.
template <class R, int D = 2>
struct State;

}  // namespace depth
