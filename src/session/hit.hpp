#pragma once
// Finds the part of a picture that is under the pointer.

#include "picture/picture.hpp"
#include "subjects/run/voronoi.hpp"

namespace gjkscope {

/// The subject of the mark at `p` (frame pixels), kind none where there is none. Points come before
/// lines and lines before areas, and of each the last painted; points and lines are hit from up to
/// `slack` away.
[[nodiscard]] Subject subject_at(const Picture& picture, const Fonts& fonts, const Point& p,
                                 double slack);

/// The face of a simplex that a click means: its vertex or its edge within `reach` of `p`, else
/// that of the Voronoi region around `p`. Points are in the coordinates of the Minkowski
/// difference.
[[nodiscard]] gjk::Face face_at(const std::vector<Eigen::Vector2d>& simplex,
                                const VoronoiRegions::Value& regions, const Eigen::Vector2d& p,
                                double reach);

[[nodiscard]] bool is_in(const Rect& rect, const Point& p, double slack = 0.0);

/// Whether any part of a shape, or of the difference, is inside of `card`; also where no mark
/// stands for one, and nobody can tell.
[[nodiscard]] bool is_in_sight(const Picture& picture, const Rect& card);

[[nodiscard]] inline bool is_vertex(const Subject& subject) {
  return subject.kind == Subject::Kind::vertex_of_x || subject.kind == Subject::Kind::vertex_of_y;
}
[[nodiscard]] inline bool is_shape(const Subject& subject) {
  return subject.kind == Subject::Kind::shape_x || subject.kind == Subject::Kind::shape_y;
}
[[nodiscard]] inline bool is_of_difference(const Subject& subject) {
  return subject.kind == Subject::Kind::difference ||
         subject.kind == Subject::Kind::difference_vertex;
}
/// The body that a vertex belongs to, or a shape is; the second one for a difference.
[[nodiscard]] inline std::size_t body_of(const Subject& subject) {
  const bool is_x =
      subject.kind == Subject::Kind::vertex_of_x || subject.kind == Subject::Kind::shape_x;
  return is_x ? 0 : 1;
}
[[nodiscard]] inline Subject vertex_of(std::size_t body, int index) {
  return body == 0 ? Subject{Subject::Kind::vertex_of_x, index}
                   : Subject{Subject::Kind::vertex_of_y, -1, index};
}
/// The index of a vertex in its body.
[[nodiscard]] inline int index_of(const Subject& vertex) {
  return body_of(vertex) == 0 ? vertex.x : vertex.y;
}

/// The subject that a drag takes: for a volume of a tree, the shape that it bounds a part of.
[[nodiscard]] Subject held(const Subject& subject);

/// True when the two are parts of the same thing: a vertex of the difference and the vertices that
/// made it.
[[nodiscard]] bool is_linked(const Subject& a, const Subject& b);

}  // namespace gjkscope
