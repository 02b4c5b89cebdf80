#pragma once
// Areas shown by parallel lines: what has a meaning must not hang on a pale colour alone.

#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

/// Lines at 45 degrees, rising, that fill a simple polygon as far as `area` shows it; `spacing` in
/// frame pixels.
[[nodiscard]] std::vector<Polyline> hatch(const std::vector<Point>& polygon, double spacing,
                                          const Rect& area);

}  // namespace gjkscope
