#pragma once
#include <string_view>

namespace gjkscope {

/// Axes and round coordinates of a view. There is nothing to compute: the camera says where they
/// are.
struct Grid {
  static constexpr std::string_view kName = "grid";
  static constexpr std::string_view kNeeds = "";
};

}  // namespace gjkscope
