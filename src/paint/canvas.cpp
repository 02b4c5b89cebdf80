#include "paint/canvas.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "paint/imgui_painter.hpp"

namespace gjkscope {
namespace {

constexpr int kChannels = 4;

/// Of the samples that are drawn at once. A frame of 1280 x 720 with 2 x 2 samples a pixel is one
/// band; larger ones have smaller bands, for what they need besides is larger.
constexpr std::size_t kWholeBytes = std::size_t{16} << 20;
constexpr std::size_t kBandBytes = std::size_t{4} << 20;

bool is_uniform(const Image& image) {
  const std::vector<std::uint8_t>& p = image.pixels;
  return std::memcmp(p.data(), p.data() + kChannels, p.size() - kChannels) == 0;
}

/// What draw lists share, without a context of Dear ImGui.
struct SharedData : ImDrawListSharedData {
  SharedData(const ImFontAtlas& atlas, int width, int height) {
    Font = atlas.Fonts.front();
    FontSize = Font->FontSize;
    TexUvWhitePixel = atlas.TexUvWhitePixel;
    TexUvLines = atlas.TexUvLines;
    ClipRectFullscreen = ImVec4(0.0f, 0.0f, static_cast<float>(width), static_cast<float>(height));
    InitialFlags = ImDrawListFlags_AntiAliasedLines | ImDrawListFlags_AntiAliasedFill;
  }
};

}  // namespace

struct Canvas::Context {
  Context(const Fonts& fonts, const Theme& the_theme, const CanvasOptions& the_options)
      : options(the_options),
        theme(the_theme),
        factor(options.supersampling),
        width(options.width * factor),
        height(options.height * factor),
        scale(factor * options.zoom) {
    if (options.width < 1 || options.height < 1 || factor < 1) {
      throw std::runtime_error(fmt::format("an image of {}x{} is too small; the least is 1x1",
                                           options.width, options.height));
    }
    band_rows = rows_of_band();
    gl_context = make_gl_context(options.renderer, width, band_rows);
    gl_context->begin(band);
    check_size();

    atlas.Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines |
                   ImFontAtlasFlags_NoPowerOfTwoHeight;
    atlas.TexDesiredWidth = 2048;
    fonts_in_atlas = std::make_unique<AtlasFonts>(atlas, fonts, scale);
    if (!atlas.Build()) throw std::runtime_error("the font atlas cannot be built");
    upload_atlas();
    shared = std::make_unique<SharedData>(atlas, width, height);
  }

  [[nodiscard]] int rows_of_band() const {
    const std::size_t row = static_cast<std::size_t>(width) * kChannels;
    if (row * static_cast<std::size_t>(height) <= kWholeBytes) return height;
    const auto most = std::max<std::size_t>(1, kBandBytes / (row * factor));  // Of the image
    const std::size_t count = (static_cast<std::size_t>(options.height) + most - 1) / most;
    return static_cast<int>((options.height + count - 1) / count) * factor;
  }

  void check_size() const {
    std::array<GLint, 2> most = {};
    gl_context->gl().GetIntegerv(GL_MAX_VIEWPORT_DIMS, most.data());
    if (width <= most[0] && height <= most[1]) return;
    throw std::runtime_error(fmt::format(
        "an image of {}x{} is too large: the renderer draws at most {} pixels either way",
        options.width, options.height, most[0] / factor));
  }

  void upload_atlas() {
    const Gl& gl = gl_context->gl();
    unsigned char* pixels = nullptr;
    int atlas_width = 0;
    int atlas_height = 0;
    // Alpha alone: at 3840 x 2160 the atlas would else be most of a canvas's memory.
    atlas.GetTexDataAsAlpha8(&pixels, &atlas_width, &atlas_height);
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, atlas_width, atlas_height, 0, GL_ALPHA,
                  GL_UNSIGNED_BYTE, pixels);
    atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)));
    atlas.ClearTexData();
  }

  void paint(const Picture& picture, Image& image) {
    image.resize(options.width, options.height);
    const std::size_t list_count = build_lists(picture);
    for (int top = 0; top < height; top += band_rows) {
      gl_context->begin(band);
      set_up(top);
      for (std::size_t i = 0; i < list_count; ++i) draw(*lists[i], top);
      gl_context->end(band);
      shrink_into(image, top / factor, band, factor);
    }
    check(picture, image);
  }

  /// For rows from `top` on. GL counts them from the bottom.
  void set_up(int top) const {
    const Gl& gl = gl_context->gl();
    gl.Viewport(0, top + band_rows - height, width, height);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(0.0, width, height, 0.0, -1.0, 1.0);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Enable(GL_TEXTURE_2D);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY}) {
      gl.EnableClientState(array);
    }
    const Color paper = theme.background();
    gl.Scissor(0, 0, width, band_rows);
    gl.ClearColor(paper.r / 255.0f, paper.g / 255.0f, paper.b / 255.0f, 1.0f);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    // What is painted over the paper leaves it opaque.
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  }

  void draw(const ImDrawList& list, int top) const {
    if (list.VtxBuffer.empty()) return;
    const Gl& gl = gl_context->gl();
    const ImDrawVert* const vertices = list.VtxBuffer.Data;
    constexpr GLsizei kStride = sizeof(ImDrawVert);
    gl.VertexPointer(2, GL_FLOAT, kStride, &vertices->pos);
    gl.TexCoordPointer(2, GL_FLOAT, kStride, &vertices->uv);
    gl.ColorPointer(kChannels, GL_UNSIGNED_BYTE, kStride, &vertices->col);
    static_assert(sizeof(ImDrawIdx) == sizeof(GLushort));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const auto left = static_cast<GLint>(std::max(command.ClipRect.x, 0.0f));
      const auto upper = static_cast<GLint>(std::max(command.ClipRect.y, 0.0f));
      const auto right = static_cast<GLint>(command.ClipRect.z);
      const auto lower = static_cast<GLint>(command.ClipRect.w);
      if (command.ElemCount == 0 || right <= left || lower <= upper) continue;
      if (lower <= top || upper >= top + band_rows) continue;
      gl.Scissor(left, top + band_rows - lower, right - left, lower - upper);
      gl.BindTexture(GL_TEXTURE_2D,
                     static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                      list.IdxBuffer.Data + command.IdxOffset);
    }
  }

  void check(const Picture& picture, const Image& image) const {
    const Gl& gl = gl_context->gl();
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
      throw std::runtime_error(fmt::format("OpenGL error {:#x} while drawing", error));
    }
    if (!picture.marks.empty() && is_uniform(image)) {
      const auto* renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
      throw std::runtime_error(fmt::format(
          "nothing was drawn: a picture of {} marks came out as an empty image (renderer: {})",
          picture.marks.size(), renderer ? renderer : "unknown"));
    }
  }

  /// What differs between the picture on black and on white is what shines through.
  void paint_transparent(const Picture& picture, Image& image) {
    const Theme opaque = theme;
    theme = opaque.on({255, 255, 255, 255});
    paint(picture, on_white);
    theme = opaque.on({0, 0, 0, 255});
    paint(picture, image);
    theme = opaque;
    for (std::size_t i = 0; i < image.pixels.size(); i += kChannels) {
      image.pixels[i + 3] =
          static_cast<std::uint8_t>(255 - (on_white.pixels[i + 1] - image.pixels[i + 1]));
    }
  }

  /// Fills as many lists as the picture needs, and returns how many.
  std::size_t build_lists(const Picture& picture) {
    std::size_t count = 0;
    std::size_t next = 0;
    do {
      if (count == lists.size()) lists.push_back(std::make_unique<ImDrawList>(shared.get()));
      ImDrawList& list = *lists[count++];
      list._ResetForNewFrame();
      list.PushTextureID(atlas.TexID);
      list.PushClipRectFullScreen();
      // Texture 0 is incomplete, and then fixed-function GL draws plain colour.
      const DrawPlacement placement{Point::Zero(), scale, nullptr};
      next = paint_marks(list, picture, next, theme, *fonts_in_atlas, placement);
    } while (next < picture.marks.size());
    return count;
  }

  CanvasOptions options;
  Theme theme;
  int factor;
  int width;  ///< Of all bands together, in samples.
  int height;
  double scale;  ///< Samples for each frame pixel.
  int band_rows = 0;
  Image band;
  Image on_white;
  std::unique_ptr<GlContext> gl_context;
  ImFontAtlas atlas;
  std::unique_ptr<AtlasFonts> fonts_in_atlas;
  std::unique_ptr<SharedData> shared;
  std::vector<std::unique_ptr<ImDrawList>> lists;
};

Canvas::Canvas(const Fonts& fonts, const Theme& theme, const CanvasOptions& options)
    : context_(std::make_unique<Context>(fonts, theme, options)) {}

Canvas::~Canvas() = default;

Image Canvas::paint(const Picture& picture) {
  Image image;
  paint(picture, image);
  return image;
}

void Canvas::paint(const Picture& picture, Image& image) {
  context_->options.transparent ? context_->paint_transparent(picture, image)
                                : context_->paint(picture, image);
}

}  // namespace gjkscope
