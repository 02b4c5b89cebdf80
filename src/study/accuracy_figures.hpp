#pragma once
// The study of accuracy as pictures.

#include <string>
#include <vector>

#include "picture/picture.hpp"
#include "picture/type.hpp"
#include "study/accuracy.hpp"

namespace gjkscope {

struct Figure {
  std::string name;   ///< For a file: "front-random".
  std::string title;  ///< Stands in the picture, too.
  Picture picture;
};

/// For each family the error against the time with its front, and bounds and error against
/// the cap on iterations; over all families time and error against the bound gap; time against the
/// number of vertices. What a study that was interrupted has nothing for is left out.
[[nodiscard]] std::vector<Figure> accuracy_figures(const study::Study& study, const Fonts& fonts);

}  // namespace gjkscope
