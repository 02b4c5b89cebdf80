#pragma once
#include <cstdint>
#include <vector>

#include "paint/canvas.hpp"

namespace gjkscope {

/// The image as a PNG file (RGB, stb_image_write with libdeflate). Same image, same bytes.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace gjkscope
