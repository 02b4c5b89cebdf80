#include "paint/canvas.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "paint/surface.hpp"

namespace gjkscope {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"cairo", "osmesa", "egl"};

bool is_uniform(const Image& image) {
  const std::vector<std::uint8_t>& p = image.pixels;
  return std::memcmp(p.data(), p.data() + Image::kChannels, p.size() - Image::kChannels) == 0;
}

}  // namespace

std::optional<Renderer> renderer_of(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<Renderer>(i);
  }
  return std::nullopt;
}

Canvas::Canvas(const Fonts& fonts, const Theme& theme, const CanvasOptions& options)
    : options_(options) {
  if (options.width < 1 || options.height < 1) {
    throw std::runtime_error(fmt::format("an image of {}x{} is too small; the least is 1x1",
                                         options.width, options.height));
  }
  surface_ = options.renderer == Renderer::cairo ? make_cairo_surface(fonts, theme, options)
                                                 : make_gl_surface(fonts, theme, options);
}

Canvas::~Canvas() = default;

Image Canvas::paint(const Picture& picture) {
  Image image;
  paint(picture, image);
  return image;
}

void Canvas::paint(const Picture& picture, Image& image) {
  image.resize(options_.width, options_.height);
  surface_->draw(picture, image);
  if (picture.marks.empty() || !is_uniform(image)) return;
  throw std::runtime_error(fmt::format(
      "nothing was drawn: a picture of {} marks came out as an empty image (renderer: {})",
      picture.marks.size(), surface_->renderer()));
}

}  // namespace gjkscope
