#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "paint/cairo_painter.hpp"
#include "paint/surface.hpp"

namespace gjkscope {
namespace {

class CairoSurface : public Surface {
 public:
  CairoSurface(const Fonts& fonts, const Theme& theme, const CanvasOptions& options)
      : painter_(fonts, Medium::pixels), theme_(theme), options_(options) {
    constexpr int kMost = 32767;
    if (options.width <= kMost && options.height <= kMost) return;
    throw std::runtime_error(
        fmt::format("an image of {}x{} is too large: cairo draws at most {} pixels either way",
                    options.width, options.height, kMost));
  }

  void draw(const Picture& picture, Image& image) override {
    const SurfaceHandle surface(cairo_image_surface_create_for_data(
        image.pixels.data(), options_.transparent ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
        image.width, image.height, static_cast<int>(Image::kChannels) * image.width));
    const CairoHandle cairo(cairo_create(surface.get()));
    if (options_.transparent) {
      std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{0});
    } else {
      const Color paper = theme_.background();
      cairo_set_source_rgb(cairo.get(), paper.r / 255.0, paper.g / 255.0, paper.b / 255.0);
      cairo_paint(cairo.get());
    }
    painter_.paint(cairo.get(), picture, theme_, options_.zoom);
    require(cairo_status(cairo.get()), "draw pixels");
    cairo_surface_finish(surface.get());
    to_rgba(image);
  }
  [[nodiscard]] std::string renderer() const override {
    return fmt::format("cairo {}", cairo_version_string());
  }

 private:
  /// From cairo's pixels: numbers 0xAARRGGBB, in the order of the machine's bytes.
  void to_rgba(Image& image) const {
    const std::uint32_t opaque = options_.transparent ? 0u : 0xFF000000u;
    std::uint8_t* const bytes = image.pixels.data();
    for (std::size_t i = 0; i < image.pixels.size(); i += Image::kChannels) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, bytes + i, sizeof pixel);
      pixel |= opaque;
      bytes[i] = static_cast<std::uint8_t>(pixel >> 16);
      bytes[i + 1] = static_cast<std::uint8_t>(pixel >> 8);
      bytes[i + 2] = static_cast<std::uint8_t>(pixel);
      bytes[i + 3] = static_cast<std::uint8_t>(pixel >> 24);
    }
  }

  CairoPainter painter_;
  Theme theme_;
  CanvasOptions options_;
};

}  // namespace

std::unique_ptr<Surface> make_cairo_surface(const Fonts& fonts, const Theme& theme,
                                            const CanvasOptions& options) {
  return std::make_unique<CairoSurface>(fonts, theme, options);
}

}  // namespace gjkscope
