#pragma once
// What a phase notes of how it decided. Nothing here is read by the run.

#include <vector>

#include "gjk/state.hpp"

namespace gjk {

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

}  // namespace gjk
