#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "paint/gl_context.hpp"
#include "paint/imgui_painter.hpp"
#include "paint/surface.hpp"

namespace gjkscope {
namespace {

/// Bytes of the samples that are drawn at once. A frame of 1280 x 720 with 2 x 2 samples a pixel is
/// one band; larger frames have smaller bands, because they need more memory for the rest.
constexpr std::size_t kWholeBytes = std::size_t{16} << 20;
constexpr std::size_t kBandBytes = std::size_t{4} << 20;

/// Data that draw lists share, without a context of Dear ImGui.
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

std::unique_ptr<GlContext> context_for(Renderer renderer, int width, int height) {
  const bool egl = renderer == Renderer::egl;
  try {
    return egl ? make_egl_context(width, height) : make_osmesa_context(width, height);
  } catch (const std::runtime_error& why) {
    throw std::runtime_error(fmt::format(
        "cannot draw by {}: {}\nDebian 12 has it: apt-get install {}. The renderer "
        "cairo needs nothing else",
        egl ? "EGL" : "OSMesa", why.what(), egl ? "libegl1 libgl1-mesa-dri" : "libosmesa6"));
  }
}

/// Draws band by band: its memory does not grow with the height of images.
class GlSurface : public Surface {
 public:
  GlSurface(const Fonts& fonts, const Theme& theme, const CanvasOptions& options)
      : options_(options),
        theme_(theme),
        factor_(options_.supersampling),
        width_(options_.width * factor_),
        height_(options_.height * factor_),
        scale_(factor_ * options_.zoom) {
    if (factor_ < 1) throw std::runtime_error("supersampling needs a sample a pixel or more");
    band_rows_ = rows_of_band();
    gl_context_ = context_for(options_.renderer, width_, band_rows_);
    gl_context_->begin(band_);
    check_size();

    atlas_.Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines |
                    ImFontAtlasFlags_NoPowerOfTwoHeight;
    atlas_.TexDesiredWidth = 2048;
    fonts_in_atlas_ = std::make_unique<AtlasFonts>(atlas_, fonts, scale_);
    if (!atlas_.Build()) throw std::runtime_error("the font atlas cannot be built");
    upload_atlas();
    shared_ = std::make_unique<SharedData>(atlas_, width_, height_);
  }

  void draw(const Picture& picture, Image& image) override {
    options_.transparent ? paint_transparent(picture, image) : paint(picture, image);
  }
  [[nodiscard]] std::string renderer() const override {
    const auto* name = reinterpret_cast<const char*>(gl_context_->gl().GetString(GL_RENDERER));
    return name ? name : "unknown";
  }

 private:
  [[nodiscard]] int rows_of_band() const {
    const std::size_t row = static_cast<std::size_t>(width_) * Image::kChannels;
    if (row * static_cast<std::size_t>(height_) <= kWholeBytes) return height_;
    const auto most = std::max<std::size_t>(1, kBandBytes / (row * factor_));  // Rows of the image
    const std::size_t count = (static_cast<std::size_t>(options_.height) + most - 1) / most;
    return static_cast<int>((options_.height + count - 1) / count) * factor_;
  }

  void check_size() const {
    std::array<GLint, 2> most = {};
    gl_context_->gl().GetIntegerv(GL_MAX_VIEWPORT_DIMS, most.data());
    if (width_ <= most[0] && height_ <= most[1]) return;
    throw std::runtime_error(fmt::format(
        "an image of {}x{} is too large: the renderer draws at most {} pixels either way",
        options_.width, options_.height, most[0] / factor_));
  }

  void upload_atlas() {
    const Gl& gl = gl_context_->gl();
    unsigned char* pixels = nullptr;
    int atlas_width = 0;
    int atlas_height = 0;
    // Alpha alone: at 3840 x 2160 the atlas would else be most of a canvas's memory.
    atlas_.GetTexDataAsAlpha8(&pixels, &atlas_width, &atlas_height);
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, atlas_width, atlas_height, 0, GL_ALPHA,
                  GL_UNSIGNED_BYTE, pixels);
    atlas_.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)));
    atlas_.ClearTexData();
  }

  void paint(const Picture& picture, Image& image) {
    const std::size_t list_count = build_lists(picture);
    for (int top = 0; top < height_; top += band_rows_) {
      gl_context_->begin(band_);
      set_up(top);
      for (std::size_t i = 0; i < list_count; ++i) draw_list(*lists_[i], top);
      gl_context_->end(band_);
      shrink_into(image, top / factor_, band_, factor_);
    }
    check();
  }

  /// For rows from `top` on. GL counts them from the bottom.
  void set_up(int top) const {
    const Gl& gl = gl_context_->gl();
    gl.Viewport(0, top + band_rows_ - height_, width_, height_);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(0.0, width_, height_, 0.0, -1.0, 1.0);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Enable(GL_TEXTURE_2D);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY}) {
      gl.EnableClientState(array);
    }
    const Color paper = theme_.background();
    gl.Scissor(0, 0, width_, band_rows_);
    gl.ClearColor(paper.r / 255.0f, paper.g / 255.0f, paper.b / 255.0f, 1.0f);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    // Marks over the paper leave it opaque.
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  }

  void draw_list(const ImDrawList& list, int top) const {
    if (list.VtxBuffer.empty()) return;
    const Gl& gl = gl_context_->gl();
    const ImDrawVert* const vertices = list.VtxBuffer.Data;
    constexpr GLsizei kStride = sizeof(ImDrawVert);
    gl.VertexPointer(2, GL_FLOAT, kStride, &vertices->pos);
    gl.TexCoordPointer(2, GL_FLOAT, kStride, &vertices->uv);
    gl.ColorPointer(4, GL_UNSIGNED_BYTE, kStride, &vertices->col);
    static_assert(sizeof(ImDrawIdx) == sizeof(GLushort));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const auto left = static_cast<GLint>(std::max(command.ClipRect.x, 0.0f));
      const auto upper = static_cast<GLint>(std::max(command.ClipRect.y, 0.0f));
      const auto right = static_cast<GLint>(command.ClipRect.z);
      const auto lower = static_cast<GLint>(command.ClipRect.w);
      if (command.ElemCount == 0 || right <= left || lower <= upper) continue;
      if (lower <= top || upper >= top + band_rows_) continue;
      gl.Scissor(left, top + band_rows_ - lower, right - left, lower - upper);
      gl.BindTexture(GL_TEXTURE_2D,
                     static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                      list.IdxBuffer.Data + command.IdxOffset);
    }
  }

  void check() const {
    const Gl& gl = gl_context_->gl();
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
      throw std::runtime_error(fmt::format("OpenGL error {:#x} while drawing", error));
    }
  }

  /// Transparency is the difference between the picture on black and the picture on white.
  void paint_transparent(const Picture& picture, Image& image) {
    const Theme opaque = theme_;
    theme_ = opaque.on({255, 255, 255, 255});
    on_white_.resize(options_.width, options_.height);
    paint(picture, on_white_);
    theme_ = opaque.on({0, 0, 0, 255});
    paint(picture, image);
    theme_ = opaque;
    for (std::size_t i = 0; i < image.pixels.size(); i += Image::kChannels) {
      image.pixels[i + 3] =
          static_cast<std::uint8_t>(255 - (on_white_.pixels[i + 1] - image.pixels[i + 1]));
    }
  }

  /// Fills as many lists as the picture needs, and returns how many.
  std::size_t build_lists(const Picture& picture) {
    std::size_t count = 0;
    std::size_t next = 0;
    do {
      if (count == lists_.size()) lists_.push_back(std::make_unique<ImDrawList>(shared_.get()));
      ImDrawList& list = *lists_[count++];
      list._ResetForNewFrame();
      list.PushTextureID(atlas_.TexID);
      list.PushClipRectFullScreen();
      // Texture 0 is incomplete, and then fixed-function GL draws plain colour.
      const DrawPlacement placement{Point::Zero(), scale_, nullptr};
      next = paint_marks(list, picture, next, theme_, *fonts_in_atlas_, placement);
    } while (next < picture.marks.size());
    return count;
  }

  CanvasOptions options_;
  Theme theme_;
  int factor_;
  int width_;  ///< The width of all bands, in samples.
  int height_;
  double scale_;  ///< Samples for each frame pixel.
  int band_rows_ = 0;
  Image band_;
  Image on_white_;
  std::unique_ptr<GlContext> gl_context_;
  ImFontAtlas atlas_;
  std::unique_ptr<AtlasFonts> fonts_in_atlas_;
  std::unique_ptr<SharedData> shared_;
  std::vector<std::unique_ptr<ImDrawList>> lists_;
};

}  // namespace

std::unique_ptr<Surface> make_gl_surface(const Fonts& fonts, const Theme& theme,
                                         const CanvasOptions& options) {
  return std::make_unique<GlSurface>(fonts, theme, options);
}

}  // namespace gjkscope
