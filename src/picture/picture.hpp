#pragma once
// A frame as data. Marks say what is there and what part it plays; a theme says what that looks
// like; a painter turns both into pixels or vectors.
//
// All coordinates and sizes are frame pixels: origin top left, y down, at the size of the picture.
// A painter that supersamples scales them.

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "picture/type.hpp"

namespace gjkscope {

using Point = Eigen::Vector2d;

struct Rect {
  Point min = Point::Zero();
  Point max = Point::Zero();
  [[nodiscard]] Point size() const { return max - min; }
  [[nodiscard]] Point center() const { return 0.5 * (min + max); }
  friend bool operator==(const Rect&, const Rect&) = default;
};
[[nodiscard]] inline bool overlap(const Rect& a, const Rect& b) {
  return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

/// A convex polygon, filled and outlined as its role says. Counter-clockwise or clockwise.
struct Polygon {
  std::vector<Point> points;
  friend bool operator==(const Polygon&, const Polygon&) = default;
};
struct Polyline {
  std::vector<Point> points;
  bool closed = false;
  friend bool operator==(const Polyline&, const Polyline&) = default;
};
/// The head is at `to`; its size does not depend on the length.
struct Arrow {
  Point from;
  Point to;
  friend bool operator==(const Arrow&, const Arrow&) = default;
};
struct Disk {
  Point center;
  double radius = 0.0;
  friend bool operator==(const Disk&, const Disk&) = default;
};
/// An upright cross: the origin, a position.
struct Cross {
  Point center;
  double radius = 0.0;
  friend bool operator==(const Cross&, const Cross&) = default;
};
/// A square that stands on a corner: a support point.
[[nodiscard]] inline Polygon diamond(const Point& center, double radius) {
  return {{center + Point(radius, 0.0), center + Point(0.0, radius), center - Point(radius, 0.0),
           center - Point(0.0, radius)}};
}
struct Box {
  Rect rect;
  double corner = 0.0;  ///< Corner radius.
  friend bool operator==(const Box&, const Box&) = default;
};
enum class Align { left, center, right };
/// Part of a text with a role of its own.
struct Tone {
  std::string text;
  std::string role;
  friend bool operator==(const Tone&, const Tone&) = default;
};
/// One line of text; `at` is on the base line.
struct Text {
  Point at;
  std::string text;  ///< UTF-8
  TextStyle style;
  Align align = Align::left;
  std::vector<Tone> tones = {};  ///< For parts that differ in colour: they make up the text.
  friend bool operator==(const Text&, const Text&) = default;
};

/// The thing that a mark stands for, if a reader may point at it.
struct Subject {
  enum class Kind {
    none,
    vertex_of_x,  ///< `x` is its index.
    vertex_of_y,  ///< `y` is its index.
    shape_x,
    shape_y,
    difference_vertex,  ///< Made of vertices `x` and `y`.
    difference,         ///< Z as a whole.
    region,             ///< Voronoi region of the face with the bits `x`.
    frame,              ///< `x` is its index.
    phase,              ///< `x` is its number: LessonRun::phases.
    study_dot,          ///< `x` is its index in its family, or among the choices of a question.
    tree_node           ///< `x` is its index in the tree of X, or `y` in that of Y; both: a pair.
  };
  Kind kind = Kind::none;
  int x = -1;
  int y = -1;
  friend bool operator==(const Subject&, const Subject&) = default;
};

struct Mark {
  std::string role;  ///< "simplex.edge"; a theme without it falls back to "simplex".
  std::variant<Polygon, Polyline, Arrow, Disk, Cross, Box, Text> shape;
  int clip = -1;  ///< Index into Picture::clips, or -1.
  Subject subject = {};
  double opacity = 1.0;  ///< The opacity of its style: less while it appears or goes.
  friend bool operator==(const Mark&, const Mark&) = default;
};

struct Picture {
  double width = 0.0;
  double height = 0.0;
  std::vector<Rect> clips;
  double clip_corner = 0.0;  ///< Corner radius of the clips; rounds the polygons they cut off.
  std::vector<Mark> marks;   ///< Painted in this order.
  friend bool operator==(const Picture&, const Picture&) = default;
};

}  // namespace gjkscope
