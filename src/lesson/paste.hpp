#pragma once
// Shapes in the forms in which people have them, which are not the JSON of case.hpp:
//
//   WKT, GeoJSON       POLYGON ((0 0, 4 0, 4 4, 0 0), (1 1, ...)): a ring, and holes after it
//   OBJ, OFF, STL      vertices of a polyhedron; `o`, a second OFF or a second solid begin the next
//   lists in code      b2Vec2 a[] = {{0, 0}, {1, 0}};  np.array([[0, 0], [1, 0]])
//   columns            two or three numbers a line; an empty line or a heading between X and Y
//
// In a text that is free in form brackets group: two or three numbers are a point, a list of
// points is a shape. Points that are named one by one (v[0], v[1]) are of one shape where their
// names differ in the number alone. A number keeps its digits: suffixes (1f, 1.0F, 2.5f64) say
// nothing more, digits may be grouped (1_000.5), 0x begins hexadecimal digits (0x1.8p3, 0x10).
// Nothing is computed: 1/3 and sqrt(2) are problems.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/problem.hpp"

namespace gjkscope {

/// An outline of a shape: its points up to the next part's.
struct PastedPart {
  enum class Kind : std::uint8_t { ring, hole, chain };
  std::size_t first = 0;
  Kind kind = Kind::ring;
};

struct PastedShape {
  std::string file;
  Place place;         ///< The place of its first point,
  std::size_t at = 0;  ///< as an index of the text, too.
  int dimension = 2;
  std::vector<Eigen::Vector3d> points;  ///< Never empty; z = 0 in the plane.
  std::vector<PastedPart> parts;        ///< In the plane; empty: points, whose hull counts.
  bool was_outline = false;             ///< In space: the ring or chain that the points were.
};

struct Pasted {
  std::vector<PastedShape> shapes;    ///< At most two, of one dimension.
  std::vector<std::string> left_out;  ///< "properties": what the text says beside its shapes.
  std::vector<Problem> problems;      ///< The first one; then there are no shapes.
  Place end;                          ///< The end of the text.
};
/// Whether files in these forms end so: ".wkt", ".txt".
[[nodiscard]] bool is_pasted_ending(std::string_view ending);

[[nodiscard]] Pasted read_pasted(std::string_view text, std::string_view file);

}  // namespace gjkscope
