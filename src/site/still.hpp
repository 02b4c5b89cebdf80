#pragma once
// The first frame as a page holds it until its program draws: to be seen, not to be touched.

#include <string>
#include <string_view>

namespace gjkscope {

/// The text that `to_svg` wrote, in fewer bytes: without marks that draw nothing, with what
/// neighbours share said once, and outlines to a tenth of a pixel. Of the names of marks those of
/// vertices stay.
[[nodiscard]] std::string still(std::string_view svg);

}  // namespace gjkscope
