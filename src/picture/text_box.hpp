#pragma once
// The place that a text takes.

#include <string>
#include <vector>

#include "picture/picture.hpp"
#include "picture/type.hpp"

namespace gjkscope {

/// The part of a text's width that lies left of where it is written.
[[nodiscard]] inline double share_before(Align align) {
  return align == Align::left ? 0.0 : align == Align::center ? 0.5 : 1.0;
}

/// From the base line to the height of capitals.
[[nodiscard]] inline Rect box_of(const Fonts& fonts, const Text& text) {
  const double width = fonts.width(text.style, text.text);
  const double left = text.at.x() - share_before(text.align) * width;
  return {{left, text.at.y() - fonts.cap_height(text.style)}, {left + width, text.at.y()}};
}

/// Breaks a text at spaces so that no line is wider than `width`, as far as words allow.
[[nodiscard]] std::vector<std::string> wrapped(const Fonts& fonts, const TextStyle& style,
                                               const std::string& text, double width);

}  // namespace gjkscope
