#pragma once
// General models (Larsen 1998, "Distance for General Models"): outlines in the plane.
//
// A closed outline bounds matter: inside is where its winding number, summed over all closed
// outlines of the model, is not 0. So an outline that turns clockwise within one that turns
// counter-clockwise is a hole. An open chain is a line without an inside. Lengths are in the unit
// of the coordinates.

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

namespace models {

using Point = Eigen::Vector2d;

/// From left to right; of points one above the other, upward.
[[nodiscard]] inline bool before(const Point& a, const Point& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

struct Outline {
  std::vector<Point> points;
  bool closed = true;  ///< The last point is joined to the first.
};

/// From point `index` of an outline to the next one. Both may lie in the same place.
struct Segment {
  Point a = Point::Zero();
  Point b = Point::Zero();
  int outline = 0;
  int index = 0;
};

struct Model {
  std::vector<Outline> outlines;
  std::vector<Segment> segments;  ///< Outline by outline, in order.
};
[[nodiscard]] Model model_of(std::vector<Outline> outlines);

/// A reason why outlines are no model, or why a method does not take it.
enum class Fault : std::uint8_t {
  none,
  no_outline,        ///< There is none.
  too_few_points,    ///< An outline has fewer than two points.
  not_finite,        ///< A coordinate is infinite or no number.
  open_chain,        ///< The method needs closed outlines.
  not_simple,        ///< An outline meets itself; the method needs simple ones.
  outlines_meet,     ///< Two outlines of a model meet; the method needs them apart.
  several_outlines,  ///< The method needs one outline.
  not_convex,        ///< The method needs a convex outline.
};
[[nodiscard]] std::string_view name_of(Fault fault);

/// A fault and where it is: an outline, and a point or segment of it; of a meeting, the other
/// segment, too.
struct Flaw {
  Fault fault = Fault::none;
  int outline = 0;
  int index = 0;
  int other_outline = -1;
  int other_index = -1;
};

/// Requirements of a method on each model.
enum class Needs : std::uint8_t {
  segments,  ///< Finite points, at least two an outline.
  closed,    ///< Also: no open chains.
  simple,    ///< Also: outlines that do not meet themselves or each other.
  convex,    ///< Also: one of them, which is convex.
};
/// The first flaw, if there is one. Decides exactly. O(n log n) where few segments lie one above
/// the other, O(n^2) at worst.
[[nodiscard]] Flaw check(const std::vector<Outline>& outlines, Needs needs);

/// The outline without points that repeat the one before, counter-clockwise, and which points of
/// the outline are left.
struct Ring {
  std::vector<Point> points;
  std::vector<int> index;
  bool reversed = false;
  [[nodiscard]] int size() const { return static_cast<int>(points.size()); }
  [[nodiscard]] int next(int i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] int previous(int i) const { return (i == 0 ? size() : i) - 1; }
  /// The segment of the outline from ring point i to the next.
  [[nodiscard]] int segment(int i) const;
};
/// For a closed outline that does not meet itself.
[[nodiscard]] Ring ring_of(const Outline& outline);
/// Exactly; of repeated points one counts. Flat outlines are not.
[[nodiscard]] bool is_convex(const Outline& outline);

}  // namespace models
