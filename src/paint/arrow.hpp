#pragma once
// The parts of an arrow, for all painters.

#include <array>
#include <optional>

#include "picture/picture.hpp"

namespace gjkscope {

struct ArrowParts {
  std::optional<Point>
      shaft_end;              ///< The end of the line from `from`; none when the arrow is all head.
  std::array<Point, 3> head;  ///< The first is `to`.
};

/// `width`: of the shaft. Nothing of an arrow without length.
[[nodiscard]] inline std::optional<ArrowParts> arrow_parts(const Arrow& arrow, double width) {
  // The length of a head grows with the line's width only. A 2.5 pixel line gets a head 12 pixels
  // long and 10 wide, which reads from the last row and still fits a 24 pixel arrow.
  constexpr double kHeadLength = 6.0;
  constexpr double kHeadLengthPerWidth = 2.4;
  constexpr double kHeadAspect = 0.84;
  constexpr double kCoincident = 1e-3;
  const Point along = arrow.to - arrow.from;
  const double length = along.norm();
  if (length <= kCoincident) return {};
  const Point unit = along / length;
  const double head = kHeadLength + kHeadLengthPerWidth * width;
  const Point base = arrow.to - head * unit;
  const Point half = 0.5 * kHeadAspect * head * Point(-unit.y(), unit.x());
  ArrowParts out{{}, {arrow.to, base + half, base - half}};
  // The shaft ends inside the head: at the tip it would show beside it.
  if (length > 0.8 * head) out.shaft_end = arrow.to - 0.8 * head * unit;
  return out;
}

}  // namespace gjkscope
