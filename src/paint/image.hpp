#pragma once
// Pixels.

#include <cstdint>
#include <vector>

namespace gjkscope {

/// 8-bit RGBA, rows from top to bottom.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Averages squares of `factor` x `factor` pixels, rounded to nearest, from row `first` of `small`
/// on. Rows that `small` does not have are left out.
void shrink_into(Image& small, int first, const Image& large, int factor);

}  // namespace gjkscope
