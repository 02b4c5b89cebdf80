#pragma once
// A part of a view, enlarged: where it stands, and what of the view's marks is in it.

#include <vector>

#include "lesson/lesson.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

/// The part of a card in which a close-up stands.
[[nodiscard]] Rect close_up_in(const Rect& card, CardCorner corner);

/// The parts of the marks that are in `card`. Lines and areas end a little outside of it: far marks
/// may be farther than painters can tell. Nothing of them can be taken hold of.
[[nodiscard]] std::vector<Mark> cut(const std::vector<Mark>& marks, const Rect& card);

}  // namespace gjkscope
