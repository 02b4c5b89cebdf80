#pragma once
// The record of how each phase decided. No phase reads it.

#include <vector>

#include "gjk/state.hpp"

namespace gjk {

/// One condition of a region test: O's coordinate `vertex` in `face` is positive, or is not.
template <class S>
struct RegionTerm {
  Face face = 0;
  int vertex = 0;
  bool wants_positive = false;
  S numerator = S(0);
  S denominator = S(0);
  bool holds = false;
};

/// The test of one Voronoi region, which holds when all of its terms hold.
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
  bool improves = false;  ///< It became the farthest so far; of equal ones the first counts.
};

/// One stop test. Tests after the first that holds are listed, but not tried.
template <class S>
struct StopTest {
  StopReason reason = StopReason::running;
  bool enabled = false;  ///< The options ask for it, and the phases that ran make it possible.
  bool tried = false;
  bool holds = false;
  S left = S(0);  ///< The compared values; run_stop_tests lists them for each reason.
  S right = S(0);
};

/// A search direction, and how it came about.
template <class S, int D>
struct DirectionNote {
  Vec<S, D> d = Vec<S, D>::Zero();
  bool from_normal = false;              ///< d is `normal`, or its opposite when `flipped`.
  Vec<S, D> normal = Vec<S, D>::Zero();  ///< The normal before its sign was fixed.
  S side = S(0);                         ///< dot(normal, O - A): its sign decides the flip.
  bool flipped = false;
  bool sign_is_arbitrary = false;  ///< side = 0: O lies on the simplex's line or plane.
};

/// The record of one phase; the members of the other phases stay empty.
template <class S, int D>
struct Record {
  static constexpr bool kOn = true;
  std::vector<RegionTest<S>> region_tests;
  /// Rounding left every test false, or only the last one true for a full simplex too thin to be
  /// believed, so a face was chosen by distance: see nearest_face.
  bool no_region_held = false;
  std::vector<SupportPoint<S, D>> dropped;
  DirectionNote<S, D> direction;
  std::vector<ScanEntry<S>> scan_x;
  std::vector<ScanEntry<S>> scan_y;
  std::vector<StopTest<S>> stop_tests;
};

/// Takes the place of Record when nothing is recorded.
struct NoRecord {
  static constexpr bool kOn = false;
};

}  // namespace gjk
