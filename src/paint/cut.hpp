#pragma once
// The parts of marks that a painter can draw: outlines inside a rectangle, and lines on pixels.

#include <optional>
#include <utility>
#include <vector>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

[[nodiscard]] inline double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The part of a polygon inside a convex one, which turns clockwise as seen on the frame: cut by
/// one side after the other (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). Of a
/// polygon that is not convex, parts hang together along the sides.
[[nodiscard]] std::vector<Point> intersect(std::vector<Point> polygon,
                                           const std::vector<Point>& inside);

/// The part of the line from `a` to `b` that may show inside `bounds`. It begins a whole number of
/// periods after `a`, so that dashes stay where they are; 0 is the period of a solid line. Nothing
/// where the line passes by or has no length.
[[nodiscard]] std::optional<std::pair<Point, Point>> visible_part(const Point& a, const Point& b,
                                                                  const Rect& bounds,
                                                                  double period);

/// Corners of a polygon that stays within 0.08 pixels of an arc. Angles in radians.
[[nodiscard]] std::vector<Point> arc(const Point& center, double radius, double from, double to,
                                     double pixels_per_unit);
[[nodiscard]] std::vector<Point> circle(const Point& center, double radius, double pixels_per_unit);

/// Moves a line along an axis onto whole pixels, where it is thin and solid: rules and ticks stay
/// crisp, wider lines may move smoothly.
void align_to_pixels(Point& a, Point& b, const Style& style, double pixels_per_unit);

}  // namespace gjkscope
