#pragma once
// The surface of a canvas: pixels drawn by cairo or by OpenGL.

#include <memory>
#include <string>

#include "paint/canvas.hpp"

namespace gjkscope {

class Surface {
 public:
  virtual ~Surface() = default;
  Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  /// `image` has the size of the canvas. Throws std::runtime_error when drawing fails.
  virtual void draw(const Picture& picture, Image& image) = 0;
  /// For messages: "cairo 1.16.0".
  [[nodiscard]] virtual std::string renderer() const = 0;
};

/// Both throw std::runtime_error for sizes that they cannot draw.
[[nodiscard]] std::unique_ptr<Surface> make_cairo_surface(const Fonts& fonts, const Theme& theme,
                                                          const CanvasOptions& options);
[[nodiscard]] std::unique_ptr<Surface> make_gl_surface(const Fonts& fonts, const Theme& theme,
                                                       const CanvasOptions& options);

}  // namespace gjkscope
