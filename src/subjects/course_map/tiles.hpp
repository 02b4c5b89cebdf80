#pragma once
// Places on the map of the course that lead to its chapters.

#include <string>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

/// The places of chapters 1, 2, ... in a picture of the map, each with the room for its title, in
/// the picture's pixels; none in other pictures.
[[nodiscard]] std::vector<Rect> tiles_of_map(const Picture& picture);
/// A tile's place on a picture of this size, as a style of HTML.
[[nodiscard]] std::string style_of_tile(const Rect& tile, const Point& whole);

}  // namespace gjkscope
