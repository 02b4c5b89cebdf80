#pragma once
// Pixels.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gjkscope {

/// 8-bit RGBA, rows from top to bottom.
struct Image {
  static constexpr std::size_t kChannels = 4;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  void resize(int new_width, int new_height) {
    width = new_width;
    height = new_height;
    pixels.resize(kChannels * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
};

/// Averages squares of `factor` x `factor` pixels, rounded to nearest, from row `first` of `small`
/// on. Rows that `small` does not have are left out.
void shrink_into(Image& small, int first, const Image& large, int factor);

}  // namespace gjkscope
