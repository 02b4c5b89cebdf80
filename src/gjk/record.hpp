#pragma once
// The record of how each phase decided. No phase reads it.

#include <vector>

#include "gjk/state.hpp"

namespace gjk {

/// One condition of a region test: O's coordinate `vertex` in `face` is positive, or is not.
template <class R>
struct RegionTerm {
  Face face = 0;
  int vertex = 0;
  bool wants_positive = false;
  R numerator = R(0);
  R denominator = R(0);
  bool holds = false;
};

/// The test of one Voronoi region, which holds when all of its terms hold.
template <class R>
struct RegionTest {
  Face region = 0;
  std::vector<RegionTerm<R>> terms;
  bool holds = false;
};

/// One vertex of a support scan.
template <class R>
struct ScanEntry {
  int index = 0;
  R value = R(0);         ///< dot(d, vertex), in the shape's own frame.
  bool improves = false;  ///< It became the farthest so far; of equal ones the first counts.
};

/// One stop test. Tests after the first that holds are listed, but not tried.
template <class R>
struct StopTest {
  StopReason reason = StopReason::running;
  bool enabled = false;  ///< The options ask for it, and the phases that ran make it possible.
  bool tried = false;
  bool holds = false;
  R left = R(0);  ///< The compared values; run_stop_tests lists them for each reason.
  R right = R(0);
};

/// A search direction, and how it came about.
template <class R, int D>
struct DirectionNote {
  Vec<R, D> d = Vec<R, D>::Zero();
  bool from_normal = false;              ///< d is `normal`, or its opposite when `flipped`.
  Vec<R, D> normal = Vec<R, D>::Zero();  ///< The normal before its sign was fixed.
  R side = R(0);                         ///< dot(normal, O - A): its sign decides the flip.
  bool flipped = false;
  bool sign_is_arbitrary = false;  ///< side = 0: O lies on the simplex's line or plane.
};

/// The record of one phase; the members of the other phases stay empty.
template <class R, int D>
struct Record {
  static constexpr bool kOn = true;
  std::vector<RegionTest<R>> region_tests;
  /// Rounding left every test false, or only the last one true for a full simplex too thin to be
  /// believed, so a face was chosen by distance: see nearest_face.
  bool no_region_held = false;
  std::vector<SupportPoint<R, D>> dropped;
  DirectionNote<R, D> direction;
  std::vector<ScanEntry<R>> scan_x;
  std::vector<ScanEntry<R>> scan_y;
  std::vector<StopTest<R>> stop_tests;
};

/// Takes the place of Record when nothing is recorded.
struct NoRecord {
  static constexpr bool kOn = false;
};

}  // namespace gjk
