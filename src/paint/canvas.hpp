#pragma once
// Pictures to pixels, without a display: the ImGui draw list through OpenGL.

#include <memory>
#include <optional>

#include "paint/gl_context.hpp"
#include "paint/image.hpp"
#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

struct CanvasOptions {
  int width = 1280;  ///< Of the images, in pixels.
  int height = 720;
  int supersampling = 2;     ///< Samples a pixel, each way.
  double zoom = 1.0;         ///< Pixels for each frame pixel of a picture.
  bool transparent = false;  ///< The background shines through: alpha, which colours are multiplied
                             ///< by. Else images are opaque.
  std::optional<Renderer> renderer;  ///< The first that is there, without.
};

/// Draws images, band by band: its memory does not grow with their height. Contexts of Dear ImGui
/// are left alone; canvases on several threads do not know of each other.
class Canvas {
 public:
  /// Throws std::runtime_error saying what was tried.
  Canvas(const Fonts& fonts, const Theme& theme, const CanvasOptions& options);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Throws std::runtime_error when nothing of a picture with marks came out.
  [[nodiscard]] Image paint(const Picture& picture);
  /// The same into an image whose memory is used again.
  void paint(const Picture& picture, Image& image);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace gjkscope
