#include "paint/canvas.hpp"

#include <GL/osmesa.h>
#include <backends/imgui_impl_opengl2.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "paint/imgui_painter.hpp"

namespace gjkscope {
namespace {

constexpr int kChannels = 4;

struct ContextDeleter {
  void operator()(osmesa_context* context) const { OSMesaDestroyContext(context); }
};
using ContextHandle = std::unique_ptr<osmesa_context, ContextDeleter>;

/// Creates a context, the most specific way first.
ContextHandle create_context(std::string& tried) {
  // The OpenGL 2 back end of Dear ImGui calls functions that a core profile does not have. Neither
  // depth nor stencil nor accumulation: a draw list is painted in order.
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            0,
                            OSMESA_STENCIL_BITS,
                            0,
                            OSMESA_ACCUM_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_COMPAT_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            2,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            1,
                            0};
  if (ContextHandle context{OSMesaCreateContextAttribs(attributes, nullptr)}) return context;
  tried += "\n  OSMesaCreateContextAttribs (RGBA, compatibility profile, 2.1): no context";
  if (ContextHandle context{OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr)}) return context;
  tried += "\n  OSMesaCreateContextExt (RGBA): no context";
  return nullptr;
}

std::runtime_error no_image(const std::string& tried) {
  return std::runtime_error(
      fmt::format("cannot draw without a display; tried:{}\n"
                  "Debian has the software renderer: apt-get install libosmesa6",
                  tried));
}

bool is_uniform(const Image& image) {
  const std::vector<std::uint8_t>& p = image.pixels;
  return std::memcmp(p.data(), p.data() + kChannels, p.size() - kChannels) == 0;
}

/// A row of pixels whose every channel is the mean of 2 x 2, from the two rows `a` and `b`. Two
/// channels at a time, in 32-bit words with 16 bits for each sum: the compiler makes vector code of
/// it, which it does not of the general case.
void halve_row(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* to, int width) {
  constexpr std::uint32_t kEven = 0x00FF00FF;
  constexpr std::uint32_t kHalf = 0x00020002;  // To nearest: half of the divisor, 4
  for (int x = 0; x < width; ++x) {
    std::uint32_t p[4];
    std::memcpy(p, a + 2 * kChannels * x, 2 * kChannels);
    std::memcpy(p + 2, b + 2 * kChannels * x, 2 * kChannels);
    const std::uint32_t even =
        (p[0] & kEven) + (p[1] & kEven) + (p[2] & kEven) + (p[3] & kEven) + kHalf;
    const std::uint32_t odd = ((p[0] >> 8) & kEven) + ((p[1] >> 8) & kEven) +
                              ((p[2] >> 8) & kEven) + ((p[3] >> 8) & kEven) + kHalf;
    const std::uint32_t mean = ((even >> 2) & kEven) | (((odd >> 2) & kEven) << 8);
    std::memcpy(to + kChannels * x, &mean, kChannels);
  }
}

/// The same for squares of any size; `stride` is the length of a large row in bytes.
void average_row(const std::uint8_t* from, std::size_t stride, std::uint8_t* to, int width,
                 int factor) {
  const unsigned count = static_cast<unsigned>(factor) * factor;
  for (int x = 0; x < width; ++x) {
    for (int c = 0; c < kChannels; ++c) {
      const std::uint8_t* const square =
          from + static_cast<std::size_t>(x) * factor * kChannels + c;
      unsigned sum = count / 2;
      for (int row = 0; row < factor; ++row) {
        for (int k = 0; k < factor; ++k) sum += square[row * stride + k * kChannels];
      }
      to[x * kChannels + c] = static_cast<std::uint8_t>(sum / count);
    }
  }
}

}  // namespace

namespace {

/// While it lives, a context of Dear ImGui is the current one; then the one that was before.
class CurrentImGui {
 public:
  explicit CurrentImGui(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
    ImGui::SetCurrentContext(context);
  }
  ~CurrentImGui() { ImGui::SetCurrentContext(before_); }
  CurrentImGui(const CurrentImGui&) = delete;
  CurrentImGui& operator=(const CurrentImGui&) = delete;

 private:
  ImGuiContext* before_;
};

}  // namespace

struct Canvas::Context {
  Context(const Fonts& fonts, const Theme& the_theme, int the_width, int the_height, int factor,
          double zoom)
      : theme(the_theme),
        width(the_width * factor),
        height(the_height * factor),
        scale(factor * zoom) {
    if (the_width < 1 || the_height < 1 || factor < 1) {
      throw std::runtime_error(
          fmt::format("an image of {}x{} is too small; the least is 1x1", the_width, the_height));
    }
    std::string tried;
    gl = create_context(tried);
    if (!gl) throw no_image(tried);
    GLint largest = 0;
    OSMesaGetIntegerv(OSMESA_MAX_WIDTH, &largest);
    if (std::max(width, height) > largest) {
      throw std::runtime_error(
          fmt::format("an image of {}x{} is too large: OSMesa draws at most {} pixels either way",
                      the_width, the_height, largest / factor));
    }
    Image first;
    target(first);

    const CurrentImGui current(nullptr);
    imgui.context = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
    io.DeltaTime = 1.0f / 60.0f;
    io.Fonts->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    io.Fonts->TexDesiredWidth = 2048;
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    fonts_in_atlas = std::make_unique<AtlasFonts>(*io.Fonts, fonts, scale);
    if (!io.Fonts->Build()) throw std::runtime_error("the font atlas cannot be built");
    imgui.has_backend = ImGui_ImplOpenGL2_Init();
    if (!imgui.has_backend) throw std::runtime_error("Dear ImGui has no OpenGL 2 back end");
    // One frame of Dear ImGui's own, without a window: it uploads the atlas, and gives draw lists
    // the font and the flags that they share.
    ImGui_ImplOpenGL2_NewFrame();
    ImGui::NewFrame();
    ImGui::EndFrame();
  }

  ~Context() {
    // The back end frees its texture; that needs the context to be current, and memory to draw to.
    Image last;
    try {
      if (imgui.has_backend) target(last);
      imgui.close();
    } catch (...) {
      // Without a current context the texture goes with the context.
    }
  }

  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// From here on GL draws to `image`.
  void target(Image& image) {
    image.width = width;
    image.height = height;
    image.pixels.resize(static_cast<std::size_t>(width) * height * kChannels);
    if (!OSMesaMakeCurrent(gl.get(), image.pixels.data(), GL_UNSIGNED_BYTE, width, height)) {
      throw no_image(
          fmt::format("\n  OSMesaMakeCurrent with {}x{} pixels: refused", width, height));
    }
    // Rows from top to bottom: GL's own order is flipped here, while the image is copied anyway.
    OSMesaPixelStore(OSMESA_Y_UP, 0);
  }

  void paint(const Picture& picture, Image& image) {
    const CurrentImGui current(imgui.context);
    target(image);
    const std::size_t list_count = build_lists(picture);
    std::vector<ImDrawList*> pointers;
    ImDrawData data;
    for (std::size_t i = 0; i < list_count; ++i) {
      pointers.push_back(lists[i].get());
      data.TotalVtxCount += lists[i]->VtxBuffer.Size;
      data.TotalIdxCount += lists[i]->IdxBuffer.Size;
    }
    data.Valid = true;
    data.CmdLists = pointers.data();
    data.CmdListsCount = static_cast<int>(pointers.size());
    data.DisplaySize = ImGui::GetIO().DisplaySize;
    data.FramebufferScale = ImVec2(1.0f, 1.0f);

    const Color paper = theme.background();
    glViewport(0, 0, width, height);
    glClearColor(paper.r / 255.0f, paper.g / 255.0f, paper.b / 255.0f, 1.0f);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT);
    // What is painted over the paper leaves it opaque.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    ImGui_ImplOpenGL2_RenderDrawData(&data);
    glFinish();

    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) {
      throw std::runtime_error(fmt::format("OpenGL error {:#x} while drawing", error));
    }
    if (!picture.marks.empty() && is_uniform(image)) {
      const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
      throw std::runtime_error(fmt::format(
          "nothing was drawn: a picture of {} marks came out as an empty image (renderer: {})",
          picture.marks.size(), renderer ? renderer : "unknown"));
    }
  }

  /// Fills as many lists as the picture needs, and returns how many.
  std::size_t build_lists(const Picture& picture) {
    std::size_t count = 0;
    std::size_t next = 0;
    do {
      if (count == lists.size()) {
        lists.push_back(std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData()));
      }
      ImDrawList& list = *lists[count++];
      list._ResetForNewFrame();
      list.PushTextureID(ImGui::GetIO().Fonts->TexID);
      list.PushClipRectFullScreen();
      // Texture 0 is incomplete, and then fixed-function GL draws plain colour.
      const DrawPlacement placement{Point::Zero(), scale, nullptr};
      next = paint_marks(list, picture, next, theme, *fonts_in_atlas, placement);
    } while (next < picture.marks.size());
    return count;
  }

  struct ImGuiHandle {
    ImGuiContext* context = nullptr;
    bool has_backend = false;
    ImGuiHandle() = default;
    ImGuiHandle(const ImGuiHandle&) = delete;
    ImGuiHandle& operator=(const ImGuiHandle&) = delete;
    ~ImGuiHandle() { close(); }
    void close() {
      const CurrentImGui current(context);
      if (has_backend) ImGui_ImplOpenGL2_Shutdown();
      if (context) ImGui::DestroyContext(context);
      has_backend = false;
      context = nullptr;
    }
  };

  Theme theme;
  int width;
  int height;
  double scale;
  ContextHandle gl;
  ImGuiHandle imgui;
  std::unique_ptr<AtlasFonts> fonts_in_atlas;
  std::vector<std::unique_ptr<ImDrawList>> lists;
};

Canvas::Canvas(const Fonts& fonts, const Theme& theme, int width, int height, int supersampling,
               double zoom)
    : context_(std::make_unique<Context>(fonts, theme, width, height, supersampling, zoom)) {}

Canvas::~Canvas() = default;

Image Canvas::paint(const Picture& picture) {
  Image image;
  context_->paint(picture, image);
  return image;
}

void Canvas::paint(const Picture& picture, Image& image) { context_->paint(picture, image); }

void Canvas::set_theme(const Theme& theme) { context_->theme = theme; }

Image shrink(const Image& image, int factor) {
  Image small;
  small.width = image.width / factor;
  small.height = image.height / factor;
  const auto row_bytes = static_cast<std::size_t>(small.width) * kChannels;
  small.pixels.resize(row_bytes * small.height);

  const std::size_t stride = static_cast<std::size_t>(image.width) * kChannels;
  for (int y = 0; y < small.height; ++y) {
    const std::uint8_t* from = image.pixels.data() + static_cast<std::size_t>(y) * factor * stride;
    std::uint8_t* to = small.pixels.data() + y * row_bytes;
    if (factor == 2) {
      halve_row(from, from + stride, to, small.width);
    } else {
      average_row(from, stride, to, small.width, factor);
    }
  }
  return small;
}

}  // namespace gjkscope
