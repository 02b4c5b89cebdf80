#pragma once
// Models as convex pieces (Larsen 1998, "Methods for General Models"): outlines with holes are cut
// into triangles, ear by ear (Meisters 1975), holes joined to what is around them by bridges; then
// diagonals that no corner needs are taken away (Hertel and Mehlhorn 1983, "Fast triangulation of
// simple polygons"): of one outline that leaves at most four times as many pieces as there must be.
// The distance is the least over all pairs of pieces. All decisions are exact.

#include <array>

#include "outlines/nearest.hpp"

namespace models {

struct Bridge {
  int from = 0;  ///< A point of the hole, and one of what is around it.
  int to = 0;
};
/// Whether a diagonal between two triangles or pieces was taken away.
struct Merge {
  int from = 0;
  int to = 0;
  bool merged = false;  ///< Else one of its ends would be a corner that turns in.
};

/// Points count within `points`, which are those of all outlines, one after the other.
struct Pieces {
  std::vector<Point> points;
  std::vector<Bridge> bridges;
  std::vector<std::array<int, 3>> triangles;  ///< In the order in which ears were cut.
  std::vector<Merge> merges;                  ///< Each diagonal, in the order asked.
  std::vector<std::vector<int>> pieces;       ///< Convex, counter-clockwise.
};
/// For a model whose outlines check(Needs::simple) takes. O(n^2).
[[nodiscard]] Pieces pieces_of(const Model& model);

/// The fewest convex pieces that diagonals cut a simple outline into, of all ways to cut it:
/// without holes that is O(n^5), with holes and for solids it is NP-hard (Lingas 1982, Chazelle
/// 1984). Corners count within the outline's points.
[[nodiscard]] std::vector<std::vector<int>> fewest_pieces(const Outline& outline);
/// The corners of a simple outline that turn in: a diagonal mends two of them at most, so there are
/// at least 1 + half as many pieces.
[[nodiscard]] std::vector<int> corners_turning_in(const Outline& outline);

/// Whether the middle of three corners in a row of a ring can be cut off: it turns out, and no
/// other corner lies in their triangle. Corners count within `points`. Exact.
[[nodiscard]] bool is_ear(const std::vector<Point>& points, const std::array<int, 3>& ear,
                          const std::vector<int>& ring);

/// A pair of pieces: run through GJK, or skipped because its boxes are farther apart than the least
/// distance by then.
struct PieceRun {
  int a = 0;
  int b = 0;
  double bound = 0.0;  ///< Not more than the distance of the boxes.
  double least = 0.0;  ///< The least upper bound before; infinite where there is none.
  bool skipped = false;
  double distance = 0.0;  ///< The answer of GJK when it ran, with its bounds.
  double lower = 0.0;
  double upper = 0.0;
  int iterations = 0;
  Point x = Point::Zero();  ///< Its closest points.
  Point y = Point::Zero();
};
struct PiecesAnswer {
  Answer answer;
  long visits = 0;  ///< Runs of GJK.
  std::vector<PieceRun> runs;
};
/// The pairs that GJK cannot tell from the closest are compared exactly, segment by segment.
[[nodiscard]] PiecesAnswer pieces_distance(const Model& a, const Model& b, const Pieces& pieces_a,
                                           const Pieces& pieces_b);

}  // namespace models
