#pragma once
// Random shapes with small whole coordinates, so that a student can compute with them by hand.

#include <cstdint>
#include <random>

#include "lesson/lesson.hpp"

namespace gjkscope::practice {

/// Random whole numbers, the same on every machine.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : bits_(seed) {}
  [[nodiscard]] std::uint64_t next() { return bits_(); }
  /// From `low` to `high`, both included.
  [[nodiscard]] int among(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 bits_;
};

// Each puts two shapes with their names into a lesson. Those of a point query are about Q.

/// The segment AB and Q.
void draw_segment(Draws& draws, Lesson& lesson);
/// The same, Q on the line through A and B.
void draw_on_line(Draws& draws, Lesson& lesson);
/// The same, Q on the perpendicular to AB at A or B.
void draw_above_end(Draws& draws, Lesson& lesson);
/// The triangle ABC and Q.
void draw_triangle(Draws& draws, Lesson& lesson);
/// The same, Q on the perpendicular to a side at one of its ends.
void draw_triangle_border(Draws& draws, Lesson& lesson);
/// A convex polygon of 4 to 6 vertices and Q.
void draw_polygon(Draws& draws, Lesson& lesson);
/// The same, Q at a vertex.
void draw_at_vertex(Draws& draws, Lesson& lesson);
/// Convex polygons X and Y, of 3 to 5 vertices each.
void draw_pair(Draws& draws, Lesson& lesson);
/// The same, with a vertex in one place.
void draw_touching(Draws& draws, Lesson& lesson);
/// The same, a side of Y parallel to one of X.
void draw_parallel(Draws& draws, Lesson& lesson);
/// The tetrahedron ABCD and Q.
void draw_tetrahedron(Draws& draws, Lesson& lesson);
/// The same, Q on a face.
void draw_on_face(Draws& draws, Lesson& lesson);
/// A polyhedron of 5 or 6 vertices and Q.
void draw_polyhedron(Draws& draws, Lesson& lesson);

}  // namespace gjkscope::practice
