#include "paint/png.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace gjkscope {
namespace png_test {

/// Flat areas, gradients and noise.
Image sample(int width, int height) {
  Image image{width, height, {}};
  std::mt19937 random(7);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool noisy = x > width / 2 && y > height / 2;
      const auto value =
          static_cast<std::uint8_t>(noisy ? random() : 4u * static_cast<unsigned>(x));
      image.pixels.insert(image.pixels.end(),
                          {value, static_cast<std::uint8_t>(y), 200, std::uint8_t{255}});
    }
  }
  return image;
}

Image decode(const std::vector<std::uint8_t>& png, int& channels) {
  Image image;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(png.data(), static_cast<int>(png.size()), &image.width, &image.height,
                            &channels, 4),
      &stbi_image_free);
  if (pixels) {
    image.pixels.assign(pixels.get(), pixels.get() + 4 * image.width * image.height);
  }
  return image;
}

TEST(Png, DecodesToTheSamePixels) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {640, 360}}) {
    const Image image = sample(width, height);
    int channels = 0;
    const Image decoded = decode(encode_png(image), channels);
    EXPECT_EQ(decoded.width, width);
    EXPECT_EQ(decoded.height, height);
    EXPECT_EQ(channels, 3);
    EXPECT_EQ(decoded.pixels, image.pixels);
  }
}

TEST(Png, SameImageSameBytesOnEveryThread) {
  const Image image = sample(320, 180);
  const std::vector<std::uint8_t> expected = encode_png(image);
  std::vector<std::vector<std::uint8_t>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&result, &image] { result = encode_png(image); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, expected);
}

}  // namespace png_test
}  // namespace gjkscope
