#pragma once
// What is known between two phases of a run, and what one phase noted while it ran. Both are plain
// values: going back to an earlier step is an index into a trace, not an undo.

#include <vector>

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

/// One condition of a region test: the barycentric coordinate of `vertex` in `face`, wanted
/// positive or not positive.
template <class S>
struct RegionTerm {
  Face face = 0;
  int vertex = 0;
  bool wants_positive = false;
  S numerator = S(0);
  S denominator = S(0);
  bool holds = false;
};

/// The test of one Voronoi region: it holds when all of its terms do.
template <class S>
struct RegionTest {
  Face region = 0;
  std::vector<RegionTerm<S>> terms;
  bool holds = false;
};

/// One vertex of a support scan.
template <class S>
struct ScanEntry {
  int index = 0;
  S value = S(0);         ///< dot(d, vertex), in the shape's own frame.
  bool improves = false;  ///< Larger than all before it.
};

/// One stop test. Tests after the one that holds are listed, not tried.
template <class S>
struct StopTest {
  StopReason reason = StopReason::running;
  bool enabled = false;  ///< The options ask for it, and this phase can evaluate it.
  bool tried = false;
  bool holds = false;
  S left =
      S(0);  ///< The two values compared; which ones, `reason` tells (see detail::run_stop_tests).
  S right = S(0);
};

/// How a search direction came about.
template <class S, int D>
struct DirectionNote {
  Vec<S, D> d = Vec<S, D>::Zero();
  bool from_normal = false;              ///< Normal of the simplex, not O - P.
  Vec<S, D> normal = Vec<S, D>::Zero();  ///< The normal before its sign was fixed.
  S side = S(0);                         ///< dot(normal, O - A): its sign decides the flip.
  bool flipped = false;
  bool sign_is_arbitrary = false;  ///< side = 0: O lies on the simplex's line.
};

/// What one phase noted; the members of the other phases stay empty.
template <class S, int D>
struct Record {
  static constexpr bool kOn = true;
  std::vector<RegionTest<S>> region_tests;
  bool no_region_held =
      false;  ///< Rounding left every test false, or the last one true for a simplex too thin to
              ///< believe it; the nearest candidate was taken.
  std::vector<SupportPoint<S, D>> dropped;
  DirectionNote<S, D> direction;
  std::vector<ScanEntry<S>> scan_x;
  std::vector<ScanEntry<S>> scan_y;
  std::vector<StopTest<S>> stop_tests;
};

/// Stands in for Record where nothing is to be recorded.
struct NoRecord {
  static constexpr bool kOn = false;
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
