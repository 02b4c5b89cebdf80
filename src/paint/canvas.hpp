#pragma once
// Pictures to pixels, without a display.

#include <memory>
#include <optional>
#include <string_view>

#include "paint/image.hpp"
#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

/// The library that draws pixels. Cairo is part of the program. The others draw as the window does,
/// by the Dear ImGui draw list and OpenGL, from a library that is looked for at run time.
enum class Renderer { cairo, osmesa, egl };
/// "cairo", "osmesa" or "egl".
[[nodiscard]] std::optional<Renderer> renderer_of(std::string_view name);

struct CanvasOptions {
  int width = 1280;  ///< The width of the images, in pixels.
  int height = 720;
  int supersampling = 2;     ///< Samples a pixel, each way, by OpenGL; cairo counts areas.
  double zoom = 1.0;         ///< Pixels for each frame pixel of a picture.
  bool transparent = false;  ///< The background shines through: alpha, which colours are multiplied
                             ///< by. Else images are opaque.
  Renderer renderer = Renderer::cairo;
};

class Surface;

/// Draws images. Contexts of Dear ImGui are left alone; canvases on several threads do not know of
/// each other.
class Canvas {
 public:
  /// Throws std::runtime_error when the renderer is not there or the image too large for it.
  Canvas(const Fonts& fonts, const Theme& theme, const CanvasOptions& options);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Throws std::runtime_error when nothing of a picture with marks came out.
  [[nodiscard]] Image paint(const Picture& picture);
  /// The same into an image whose memory is used again.
  void paint(const Picture& picture, Image& image);

 private:
  CanvasOptions options_;
  std::unique_ptr<Surface> surface_;
};

}  // namespace gjkscope
