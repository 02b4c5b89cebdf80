#pragma once
// Pictures to pixels, without a display: the ImGui draw list through OSMesa.

#include <cstdint>
#include <memory>
#include <vector>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

/// 8-bit RGBA, rows from top to bottom, opaque.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Draws images of `width` x `height` pixels, `zoom` pixels for each frame pixel of a picture, at
/// `supersampling` times that size. Contexts of Dear ImGui that others have are left as they are.
class Canvas {
 public:
  /// Throws std::runtime_error saying what was tried.
  Canvas(const Fonts& fonts, const Theme& theme, int width, int height, int supersampling = 2,
         double zoom = 1.0);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// The picture at full supersampled size; `shrink` brings it to size (so that another thread can
  /// do it). Throws std::runtime_error when nothing of a picture with marks came out.
  [[nodiscard]] Image paint(const Picture& picture);
  /// The same into an image whose memory is used again.
  void paint(const Picture& picture, Image& image);

  /// Makes the canvas that of another theme.
  void set_theme(const Theme& theme);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Averages squares of `factor` x `factor` pixels, rounded to nearest.
[[nodiscard]] Image shrink(const Image& image, int factor);

}  // namespace gjkscope
