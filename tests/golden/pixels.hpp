#pragma once
// Pictures compared pixel by pixel.

#include <string>

#include "paint/image.hpp"

namespace gjkscope::golden {

/// Software renderers round differently on other processors. A pixel counts as another when a
/// channel is off by more than kNoise of 255: antialiased edges stay below, a moved line is far
/// above. kOthers of the pixels may be: a label that moves by a pixel makes about ten times as
/// many.
inline constexpr int kNoise = 40;
inline constexpr double kOthers = 2e-4;

/// 1 where the sizes differ.
[[nodiscard]] double share_of_others(const Image& a, const Image& b);

/// Without pixels where it is no PNG.
[[nodiscard]] Image decoded(const std::string& png);

}  // namespace gjkscope::golden
