#pragma once
// How many times finer the pixels of a screen are than usual, as it says of itself.

#include <optional>
#include <string_view>

namespace gjkscope {

/// Dots per inch of type, as desktops write them into the resources of X ("Xft.dpi:\t192").
[[nodiscard]] std::optional<double> dpi_of_resources(std::string_view resources);
/// 1 for 96 dots per inch and fewer, in quarters.
[[nodiscard]] double scale_of_dpi(double dpi);

}  // namespace gjkscope
