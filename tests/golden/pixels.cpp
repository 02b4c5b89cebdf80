#include "golden/pixels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include "fonts.hpp"

namespace gjkscope::golden {
namespace {

/// Entry `id` of a font's table of names, whose letters are ASCII.
std::string name_in(const std::vector<unsigned char>& file, int id) {
  stbtt_fontinfo font;
  if (!stbtt_InitFont(&font, file.data(), 0)) return "no font";
  constexpr int kEnglish = 0x409;
  int bytes = 0;
  const char* utf16 = stbtt_GetFontNameString(&font, &bytes, STBTT_PLATFORM_ID_MICROSOFT,
                                              STBTT_MS_EID_UNICODE_BMP, kEnglish, id);
  std::string name;
  for (int i = 1; utf16 && i < bytes; i += 2) name += utf16[i];
  return name;
}

std::array<double, 3> mean_color(const Image& image, int left, int top) {
  std::array<double, 3> sum{};
  int count = 0;
  for (int y = top; y < std::min(top + kSquare, image.height); ++y) {
    for (int x = left; x < std::min(left + kSquare, image.width); ++x, ++count) {
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += image.pixels[4 * (static_cast<std::size_t>(y) * image.width + x) + k];
    }
  }
  for (double& channel : sum) channel /= count;
  return sum;
}

}  // namespace

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

double share_of_other_squares(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.pixels.empty()) return 1.0;
  int others = 0;
  int count = 0;
  for (int top = 0; top < a.height; top += kSquare) {
    for (int left = 0; left < a.width; left += kSquare, ++count) {
      const std::array<double, 3> one = mean_color(a, left, top);
      const std::array<double, 3> other = mean_color(b, left, top);
      bool same = true;
      for (std::size_t k = 0; k < 3; ++k) same = same && std::abs(one[k] - other[k]) <= kInk;
      others += same ? 0 : 1;
    }
  }
  return static_cast<double>(others) / count;
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

std::string names_of(const Fonts& fonts) {
  constexpr int kFullName = 4;
  constexpr int kVersion = 5;
  std::string names;
  for (int face = 0; face < kFaceCount; ++face) {
    const std::vector<unsigned char>& file = fonts.file(static_cast<Face>(face));
    names += fmt::format("{}, {}\n", name_in(file, kFullName), name_in(file, kVersion));
  }
  return names;
}

bool fonts_are_those_of_goldens() {
  std::ifstream in(std::string(GJKSCOPE_SOURCE_DIR) + "/tests/golden/fonts.txt");
  std::ostringstream named;
  named << in.rdbuf();
  return named.str() == names_of(testing::fonts());
}

::testing::AssertionResult looks_like(const std::string& expected, const Image& got) {
  const Image image = decoded(expected);
  if (fonts_are_those_of_goldens()) {
    const double share = share_of_others(image, got);
    if (share <= kOthers) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << share << " of the pixels differ";
  }
  const double share = share_of_other_squares(image, got);
  if (share <= kInkOthers) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << share
                                       << " of the squares differ (compared square by square, "
                                          "since the fonts here are not those of "
                                          "tests/golden/fonts.txt)";
}

}  // namespace gjkscope::golden
