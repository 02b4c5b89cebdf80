#pragma once
// The walk on features in space (Lin and Canny 1991, "A fast algorithm for incremental distance
// calculation"; Mirtich 1998, "V-Clip: fast and robust polyhedral collision detection").
//
//   start with any feature of each body: a vertex, an edge or a face
//   loop
//     closest  the closest points of the two features; where one lies on the boundary of its
//              feature, that part of the boundary is next
//     regions  look for a border of one feature's Voronoi region that the other's closest point
//              lies beyond; the feature beyond that border is next
//     swap     take what is next
//
// The distance falls with each swap that crosses a border, and else does not rise while a feature
// becomes smaller. So no pair comes twice, and there are finitely many. A pair without a swap is
// proved: the plane through each closest point, normal to the way between them, supports its body.
// All decisions are exact.
//
// Lin and Canny left open how overlap is detected; these rules are Mirtich's:
//
//   clip         an edge against a face: of the part of the edge over the face the end at which
//                the distance stops falling, by the sign of its derivative, is next
//   penetration  where that part has ends on both sides of the face, the bodies overlap
//   local        a vertex behind a face is in a local minimum: it lies behind all faces, and then
//   minimum      the bodies overlap, or another face is next. Mirtich takes the one whose plane is
//                farthest; here it is the one through which the way to the first face leads, for
//                there the distance falls
//
// A step costs O(log k) decisions at a vertex of k edges, or a face of k sides. Two are dearer: a
// vertex behind a face asks all faces, and who leaves a face over a side walks along its sides to
// the nearest one.

#include <compare>
#include <optional>

#include "outlines/polyhedron.hpp"

namespace v_clip {

enum class Kind : std::uint8_t { vertex, edge, face };
/// A vertex is named by the index of its point; edges and faces by those of `Body`.
struct Feature {
  Kind kind = Kind::vertex;
  int index = 0;
  friend auto operator<=>(const Feature&, const Feature&) = default;
};

/// The hull of points, and what lies beside what on it.
struct Body {
  struct Face {
    std::vector<int> vertices;  ///< Counter-clockwise seen from outside.
    std::vector<int> edges;     ///< [i] leads from vertex i to the next.
  };
  std::vector<Eigen::Vector3d> points;
  std::vector<int> vertices;  ///< Those on the hull.
  /// Faces beside them are -1 where all points are on a line.
  std::vector<gjkscope::Polyhedron::Edge> edges;
  std::vector<Face> faces;               ///< A flat body has two, back to back.
  std::vector<std::vector<int>> spokes;  ///< For each point the edges that end there, in order.
};
/// The body of at least one finite point: a point, a segment, a polygon or a polyhedron. Exact.
/// Takes O(n log n) time, and so is made once for shapes that move without turning: `points` may be
/// moved as long as that does not round.
[[nodiscard]] Body body_of(std::vector<Eigen::Vector3d> points);

struct Query {
  const Body& x;
  const Body& y;
};

enum class Phase : std::uint8_t { closest, regions, swap };

enum class Reason : std::uint8_t {
  none,
  edge_end,       ///< An edge's closest point is its end.
  face_side,      ///< The vertex is not over the inside of the face: its nearest side or corner.
  clip_side,      ///< Clip: the edge comes nearer until it leaves the face over this side.
  clip_end,       ///< Clip: the edge comes nearer until its end, which is over the face.
  clip_empty,     ///< Clip: no part of the edge is over the face. At the start alone.
  two_faces,      ///< At the start alone: a vertex stands for a face.
  vertex_border,  ///< Beyond the border between a vertex and its edge.
  edge_border,    ///< Beyond the border between an edge and its face.
  behind_face,    ///< Local minimum: the vertex lies behind the face, but not behind all.
  meet,           ///< Overlap: the two features meet.
  penetration,    ///< Overlap: the edge passes through the face.
  inside,         ///< Overlap: the vertex lies behind all faces.
};

enum class Stop : std::uint8_t {
  running,
  closest,   ///< Each closest point lies in the Voronoi region of the other's feature.
  overlap,   ///< The bodies have a point in common; `State::next` has the reason.
  pair_cap,  ///< More swaps than pairs: that would be a defect.
};

/// The pair to be taken, and why.
struct Move {
  Reason reason = Reason::none;
  Feature x;
  Feature y;
};

struct State {
  Phase phase = Phase::closest;  ///< The phase to run next; when the walk has ended, the last one.
  Feature x;
  Feature y;
  Move next;
  int swaps = 0;
  Stop stop = Stop::running;
};

/// One look whether a point lies beyond a border of a feature.
struct Test {
  Reason border = Reason::none;  ///< The reason of a swap over it.
  bool of_x = true;              ///< The border is of X's feature, the point Y's.
  Feature beyond;                ///< The feature beyond it; for `behind_face` the face itself.
  int side = 0;                  ///< 1 beyond the border, 0 on it, -1 within.
};

/// The part of an edge over a face, and on which side of the face its ends are.
struct Clip {
  double from = 0.0;  ///< A share of the edge.
  double to = 1.0;
  int side_from = 0;  ///< 1 outside, 0 in its plane, -1 behind.
  int side_to = 0;
};

struct Record {
  std::vector<Test>
      tests;  ///< In order. Large vertices and faces are searched, so not all borders.
  std::optional<Clip> clip;
  int faces_asked = 0;  ///< By a vertex behind a face.
};

/// The closest points of two features, in double.
struct Points {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Vector3d y = Eigen::Vector3d::Zero();
  double distance = 0.0;
};

/// One phase that ran. `points` are those of the pair after it; of an edge and a face that it is
/// over those of the pair that the clip leads to, and of an overlap a common point.
struct Step {
  Phase phase = Phase::closest;
  State after;
  Record record;
  Points points;
};

struct Result {
  Stop stop = Stop::running;
  Reason reason = Reason::none;  ///< The reason of an overlap.
  Feature x;                     ///< The start for the next time.
  Feature y;
  Points points;
  int pairs = 0;  ///< Pairs of features that were looked at.
};

struct Trace {
  State start;
  std::vector<Step> steps;
  Result result;
};

/// The state before the first phase. Without features the first vertex of each hull.
[[nodiscard]] State start(const Query& query);
[[nodiscard]] State start(const Query& query, Feature x, Feature y);
/// Runs the phase `state.phase`, and notes what it looks at.
void step(State& state, const Query& query, Record& record);

/// The walk from `state`: O(1) pairs where its features are near the last ones.
[[nodiscard]] Result walk(const Query& query, State state);
/// The same, every phase recorded.
[[nodiscard]] Trace trace(const Query& query, const State& from);

/// The closest points of two features, whatever the rest of the bodies does.
[[nodiscard]] Points closest_points(const Query& query, Feature x, Feature y);

}  // namespace v_clip
