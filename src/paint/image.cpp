#include "paint/image.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace gjkscope {
namespace {

constexpr int kPixelBytes = 4;

/// A row of pixels whose every channel is the mean of 2 x 2, from the two rows `a` and `b`. Two
/// channels at a time, in 32-bit words with 16 bits for each sum: the compiler makes vector code of
/// it, which it does not of the general case.
void halve_row(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* to, int width) {
  constexpr std::uint32_t kEven = 0x00FF00FF;
  constexpr std::uint32_t kHalf = 0x00020002;  // To nearest: half of the divisor, 4
  for (int x = 0; x < width; ++x) {
    std::uint32_t p[4];
    std::memcpy(p, a + 2 * kPixelBytes * x, 2 * kPixelBytes);
    std::memcpy(p + 2, b + 2 * kPixelBytes * x, 2 * kPixelBytes);
    const std::uint32_t even =
        (p[0] & kEven) + (p[1] & kEven) + (p[2] & kEven) + (p[3] & kEven) + kHalf;
    const std::uint32_t odd = ((p[0] >> 8) & kEven) + ((p[1] >> 8) & kEven) +
                              ((p[2] >> 8) & kEven) + ((p[3] >> 8) & kEven) + kHalf;
    const std::uint32_t mean = ((even >> 2) & kEven) | (((odd >> 2) & kEven) << 8);
    std::memcpy(to + kPixelBytes * x, &mean, kPixelBytes);
  }
}

/// The same for squares of any size; `stride` is the length of a large row in bytes.
void average_row(const std::uint8_t* from, std::size_t stride, std::uint8_t* to, int width,
                 int factor) {
  const unsigned count = static_cast<unsigned>(factor) * factor;
  for (int x = 0; x < width; ++x) {
    for (int c = 0; c < kPixelBytes; ++c) {
      const std::uint8_t* const square =
          from + static_cast<std::size_t>(x) * factor * kPixelBytes + c;
      unsigned sum = count / 2;
      for (int row = 0; row < factor; ++row) {
        for (int k = 0; k < factor; ++k) sum += square[row * stride + k * kPixelBytes];
      }
      to[x * kPixelBytes + c] = static_cast<std::uint8_t>(sum / count);
    }
  }
}

}  // namespace

void shrink_into(Image& small, int first, const Image& large, int factor) {
  const std::size_t stride = static_cast<std::size_t>(large.width) * kPixelBytes;
  const std::size_t row_bytes = static_cast<std::size_t>(small.width) * kPixelBytes;
  const int rows = std::min(large.height / factor, small.height - first);
  for (int y = 0; y < rows; ++y) {
    const std::uint8_t* from = large.pixels.data() + static_cast<std::size_t>(y) * factor * stride;
    std::uint8_t* to = small.pixels.data() + static_cast<std::size_t>(first + y) * row_bytes;
    if (factor == 2) {
      halve_row(from, from + stride, to, small.width);
    } else {
      average_row(from, stride, to, small.width, factor);
    }
  }
}

}  // namespace gjkscope
