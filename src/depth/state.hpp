#pragma once
// The state between two phases of a run, and the notes of one phase while it ran: plain values, as
// in gjk/state.hpp.

#include <algorithm>
#include <vector>

#include "gjk/support.hpp"

namespace depth {

using gjk::Vec;

/// The phases of one iteration, in order. Every run ends with a stop phase.
enum class Phase : std::uint8_t {
  nearest,  ///< Take the edge of the polygon that is nearest to O, and its outward normal n.
  support,  ///< Find the support point of Z in direction n.
  stop,     ///< Stop tests.
  expand,   ///< Put the support point between the ends of the edge.
};
inline constexpr int kPhaseCount = 4;

/// Why a run ended.
enum class StopReason : std::uint8_t {
  running,           ///< It has not ended yet.
  repeated_support,  ///< The support point is an end of the nearest edge: no point of Z lies
                     ///< farther along n.
  no_progress,       ///< The support point lies no farther along n than the nearest edge.
  iteration_cap,     ///< Gave up. The bounds still hold.
  separated,         ///< O lies outside of Z: there is no depth, and no polygon.
  undecided,         ///< GJK could not tell whether the shapes overlap: there is no polygon.
  failed,            ///< The query was refused; see gjk::Error.
};

/// A corner of the polygon, linked to its neighbours. One that the polygon has outgrown stays where
/// it is, so that indices keep their meaning.
template <class R>
struct Corner {
  static constexpr int kOutgrown = -1;
  gjk::SupportPoint<R, 2> point;
  int previous = kOutgrown;
  int next = kOutgrown;
};

/// From one corner to the next.
template <class R>
struct Edge {
  int from = 0;
  int to = 0;
  R distance_sq = R(0);  ///< The squared distance of O from the segment.
};

/// Points of Z, counter-clockwise around O. A point is a polygon, too, with an edge from itself to
/// itself, and a segment is one of two edges.
template <class R>
struct Polygon {
  std::vector<Corner<R>> corners;
  int count = 0;  ///< Corners that are not outgrown.
  int first = 0;  ///< One of them: the latest.
  /// A heap, the nearest edge in front. Edges that are gone stay until they come to the front.
  std::vector<Edge<R>> edges;

  [[nodiscard]] const Vec<R, 2>& at(int corner) const { return corners[corner].point.w; }
};

/// Squared distance of O from the segment ab. Its nearest point is the foot of the perpendicular,
/// where that lies between a and b:
///
///   |cross(a, b - a)|^2 / |b - a|^2
template <class R>
[[nodiscard]] R segment_distance_sq(const Vec<R, 2>& a, const Vec<R, 2>& b) {
  const Vec<R, 2> way = b - a;
  if (!(gjk::dot(a, way) < R(0))) return gjk::dot(a, a);
  if (!(R(0) < gjk::dot(b, way))) return gjk::dot(b, b);
  const R area = gjk::cross(a, way);
  return area * R(area / gjk::dot(way, way));
}

/// `use(from, to)` of every edge, counter-clockwise.
template <class R, class Use>
void for_each_edge(const Polygon<R>& polygon, const Use& use) {
  int corner = polygon.first;
  do {
    use(corner, polygon.corners[corner].next);
    corner = polygon.corners[corner].next;
  } while (corner != polygon.first);
}

/// Every edge, counter-clockwise: for pictures.
template <class R>
[[nodiscard]] std::vector<Edge<R>> edges_in_order(const Polygon<R>& polygon) {
  std::vector<Edge<R>> edges;
  for_each_edge(polygon, [&](int from, int to) {
    edges.push_back({from, to, segment_distance_sq<R>(polygon.at(from), polygon.at(to))});
  });
  return edges;
}

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
struct Record {
  static constexpr bool kOn = true;
  std::vector<Edge<R>> edges;  ///< The polygon whose nearest edge was looked for.
  std::vector<gjk::ScanEntry<R>> scan_x;
  std::vector<gjk::ScanEntry<R>> scan_y;
  std::vector<StopTest<R>> stop_tests;
  std::vector<int> outgrown;  ///< Corners that the polygon has outgrown.
};

/// Stands in for Record where nothing is to be recorded.
using gjk::NoRecord;

/// Lengths are in the unit of the GJK run; see gjk::Prepared::exponent.
template <class R>
struct State {
  Phase phase = Phase::nearest;  ///< The phase to run next; when the run has ended, the last one.
  int iteration = 1;
  Polygon<R> polygon;
  Edge<R> edge;                          ///< The nearest one.
  Vec<R, 2> n = Vec<R, 2>::Zero();       ///< Its outward normal, as long as the edge.
  gjk::SupportPoint<R, 2> support = {};  ///< Farthest point of Z along n.
  StopReason stop = StopReason::running;
};

}  // namespace depth
