#pragma once
// Changes of a lesson's shapes, as a hand makes them on the stage. Plain functions from values to
// values; the session (session.hpp) keeps what was before. `body` is an index into Lesson::bodies.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lesson/case.hpp"
#include "run/run.hpp"

namespace gjkscope::edit {

/// Polygons with more vertices are drawn, but vertices are neither added nor taken one by one.
inline constexpr std::size_t kMostEditable = 256;

/// From the world to the frame of a shape that stands at `placement`.
[[nodiscard]] Eigen::Vector3d to_local(const Placement& placement, const Eigen::Vector3d& world);

/// Puts vertex `index` of the shape, which stands at `placement`, where `world` is.
void put_vertex(Lesson& lesson, std::size_t body, int index, const Placement& placement,
                const Eigen::Vector3d& world);

/// Moves a shape; where a path or a motion places it, all of that.
void move_shape(Lesson& lesson, std::size_t body, const Eigen::Vector3d& by);

/// Moves a vertex, or the shape where `index` is below 0; `now`: where the bodies are.
void nudge(Lesson& lesson, std::size_t body, int index, const PositionedRun& now,
           const Eigen::Vector3d& by);

/// Turns a shape about the middle of its vertices.
void turn_shape(Lesson& lesson, std::size_t body, double degrees);

/// Inserts a vertex after vertex `edge`; returns its index. It gets a name that is not taken.
int insert_vertex(Lesson& lesson, std::size_t body, int edge, const Placement& placement,
                  const Eigen::Vector3d& world);

/// Takes a vertex away, unless it is the last one. First simplices that name it are forgotten, and
/// so are the support points that the lesson expects.
bool erase_vertex(Lesson& lesson, std::size_t body, int index);

/// Corners on the circle of radius 1 around the origin, counter-clockwise; the lowest edge lies
/// flat.
[[nodiscard]] std::vector<Eigen::Vector2d> regular_polygon(int corners);

/// The shape becomes `unit`, whose coordinates lie in [-1, 1], at its own place and size; a point
/// takes the size of the other shape. Names of vertices that are gone are forgotten, as
/// erase_vertex does it.
void reshape(Lesson& lesson, std::size_t body, const std::vector<Eigen::Vector2d>& unit);

/// Both shapes become random convex polygons of 3 to 8 vertices, as large as the shapes are, and Y
/// goes where it is apart from X, close to it or over it. `now`: where they are.
void make_random_pair(Lesson& lesson, const PositionedRun& now, std::uint64_t seed);

/// With more pairs of vertices than this with_shapes leaves out effects of all differences.
inline constexpr std::size_t kMostPairs = 100'000;

/// The lesson with the shapes of a case in place of its own, and without what it says of its own
/// shapes. Effects of all differences go if there are too many to draw one by one; with shapes in
/// space everything goes that shows only the plane. D: 2 or 3.
template <int D>
[[nodiscard]] Lesson with_shapes(Lesson lesson, const CaseIn<D>& shapes);
/// The shapes of a case that was read, without problems and without outlines.
[[nodiscard]] Lesson with_shapes(Lesson lesson, const ReadCase& read);

/// The same shapes with the tour of an algorithm that follows GJK.
[[nodiscard]] Lesson with_tour(Lesson lesson, const Algorithm& algorithm);

/// The lesson with a second run in another scalar beside its own, on the stage and in the panel;
/// without a scalar, with none. Of the panel's blocks the listing stays: there is no room for more.
[[nodiscard]] Lesson with_second_run(Lesson lesson, std::optional<ScalarKind> beside);

/// The edge of a shape's outlines (LessonShape::ranges) nearest to `world`: the index of its first
/// vertex, and the distance.
struct NearestEdge {
  int edge = 0;
  double distance = 0.0;
};
[[nodiscard]] std::optional<NearestEdge> nearest_edge(const std::vector<Eigen::Vector2d>& vertices,
                                                      const std::vector<VertexRange>& outlines,
                                                      const Eigen::Vector2d& world);

}  // namespace gjkscope::edit
