#pragma once
// A picture as part of a larger one.

#include "picture/picture.hpp"

namespace gjkscope {

/// Adds the marks of `part` to `page`, its top left corner at `corner`. Nobody can point at what
/// they stand for there.
void add_part(Picture& page, const Picture& part, const Point& corner);

}  // namespace gjkscope
