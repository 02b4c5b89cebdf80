#include "golden/pixels.hpp"

#include <cstdlib>
#include <memory>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace gjkscope::golden {

double share_of_others(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.pixels.empty()) return 1.0;
  std::size_t others = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    bool same = true;
    for (std::size_t k = i; k < i + 3; ++k)
      same = same && std::abs(int{a.pixels[k]} - int{b.pixels[k]}) <= kNoise;
    others += same ? 0 : 1;
  }
  return 4.0 * static_cast<double>(others) / static_cast<double>(a.pixels.size());
}

Image decoded(const std::string& png) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()),
                            static_cast<int>(png.size()), &image.width, &image.height, &channels,
                            4),
      &stbi_image_free);
  if (pixels) image.pixels.assign(pixels.get(), pixels.get() + 4 * image.width * image.height);
  return image;
}

}  // namespace gjkscope::golden
