#pragma once
// The places of terms on a picture, for whoever points at them.

#include <vector>

#include "lesson/terms.hpp"
#include "picture/picture.hpp"
#include "picture/type.hpp"

namespace gjkscope {

struct TermSpot {
  Rect box;  ///< Around the words, a line high.
  const CourseTerm* term = nullptr;
};

/// A term that goes on in the next line has a spot in each.
[[nodiscard]] std::vector<TermSpot> term_spots(const Picture& picture, const Fonts& fonts,
                                               const std::vector<CourseTerm>& terms);

}  // namespace gjkscope
