#pragma once
// The expanding polytope between two phases of a run, and the notes of one phase while it ran:
// plain values. Phases and stop reasons are those of the plane, where an edge stands for a face.

#include <algorithm>
#include <array>
#include <vector>

#include "depth/space/plane.hpp"
#include "depth/state.hpp"

namespace depth::space {

/// A triangle, its corners counter-clockwise seen from outside. One that the polytope has outgrown
/// stays where it is, so that indices keep their meaning.
template <class R>
struct Face {
  std::array<int, 3> corners = {};
  std::array<int, 3> neighbours = {};  ///< [i] lies beyond the edge from corner i to the next one.
  R distance_sq = R(0);  ///< O from its plane, squared; negative where O lies outside of it.
  bool is_outgrown = false;
};

/// Some points of Z and their convex hull. A hull that is flat has two faces, back to back; where
/// it has no area both are one edge or point.
template <class R>
struct Polytope {
  std::vector<gjk::SupportPoint<R, 3>> corners;  ///< Also those that have come to lie inside.
  std::vector<Face<R>> faces;
  /// A heap of faces, the nearest in front. Outgrown ones stay until they come to the front.
  std::vector<int> heap;

  [[nodiscard]] const Vec<R, 3>& at(const Face<R>& face, int i) const {
    return corners[face.corners[i]].w;
  }
};

/// Notes of one phase; the members of the other phases stay empty. Faces are indices.
template <class R>
struct Record {
  static constexpr bool kOn = true;
  std::vector<int> faces;  ///< The polytope whose nearest face was looked for.
  std::vector<gjk::ScanEntry<R>> scan_x;
  std::vector<gjk::ScanEntry<R>> scan_y;
  std::vector<StopTest<R>> stop_tests;
  std::vector<int> outgrown;  ///< Faces that saw the support point, or lay in one plane with it.
  std::vector<int> added;     ///< Those from the support point to the horizon, in order.
};

/// Lengths are in the unit of the GJK run; see gjk::Prepared::exponent.
template <class R>
struct State {
  Phase phase = Phase::nearest;  ///< The phase to run next; when the run has ended, the last one.
  int iteration = 1;
  Polytope<R> polytope;
  int face = -1;                         ///< The nearest one.
  Vec<R, 3> n = Vec<R, 3>::Zero();       ///< Its outward normal, of any length.
  gjk::SupportPoint<R, 3> support = {};  ///< Farthest point of Z along n.
  StopReason stop = StopReason::running;
};

}  // namespace depth::space
