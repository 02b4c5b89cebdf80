#include "paint/gl_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace gjkscope {
namespace {

/// A library that is never closed, because its threads and memory live as long as the process.
class Library {
 public:
  explicit Library(const char* name) : name_(name), handle_(::dlopen(name, RTLD_NOW)) {
    if (!handle_) throw std::runtime_error(::dlerror());
  }
  template <class Function>
  void find(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(::dlsym(handle_, name));
    if (!function) throw std::runtime_error(fmt::format("{} has no {}", name_, name));
  }

 private:
  const char* name_;
  void* handle_;
};

template <class Find>
void find_functions(Gl& gl, Find find) {
#define GJKSCOPE_FIND(name)                                        \
  gl.name = reinterpret_cast<decltype(gl.name)>(find("gl" #name)); \
  if (!gl.name) throw std::runtime_error("the renderer has no gl" #name);
  GJKSCOPE_GL_FUNCTIONS(GJKSCOPE_FIND)
#undef GJKSCOPE_FIND
}

// Declarations of GL/osmesa.h, which not every Mesa has.
using OsMesaFunction = void (*)();
struct OsMesa {
  void* (*create)(const int* attributes, void* shared) = nullptr;
  void (*destroy)(void* context) = nullptr;
  GLboolean (*make_current)(void* context, void* pixels, GLenum type, GLsizei width,
                            GLsizei height) = nullptr;
  void (*pixel_store)(GLint name, GLint value) = nullptr;
  OsMesaFunction (*function)(const char* name) = nullptr;

  OsMesa() {
    const Library library("libOSMesa.so.8");
    library.find(create, "OSMesaCreateContextAttribs");
    library.find(destroy, "OSMesaDestroyContext");
    library.find(make_current, "OSMesaMakeCurrent");
    library.find(pixel_store, "OSMesaPixelStore");
    library.find(function, "OSMesaGetProcAddress");
  }
};

class OsMesaContext : public GlContext {
 public:
  OsMesaContext(int width, int height) : width_(width), height_(height) {
    constexpr int kFormat = 0x22;  // OSMESA_FORMAT and so on
    constexpr int kDepthBits = 0x30;
    constexpr int kStencilBits = 0x31;
    constexpr int kAccumBits = 0x32;
    constexpr int kProfile = 0x33;
    constexpr int kCompatible = 0x35;
    constexpr int kMajor = 0x36;
    constexpr int kMinor = 0x37;
    const std::array<int, 15> attributes = {kFormat, GL_RGBA,    kDepthBits, 0,        kStencilBits,
                                            0,       kAccumBits, 0,          kProfile, kCompatible,
                                            kMajor,  2,          kMinor,     1,        0};
    context_ = mesa_.create(attributes.data(), nullptr);
    if (!context_) throw std::runtime_error("no context (RGBA, compatibility profile, 2.1)");
    find_functions(functions_, mesa_.function);
  }
  ~OsMesaContext() override {
    if (context_) mesa_.destroy(context_);
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  void begin(Image& image) override {
    constexpr GLint kYUp = 0x11;
    image.resize(width_, height_);
    if (!mesa_.make_current(context_, image.pixels.data(), GL_UNSIGNED_BYTE, width_, height_)) {
      throw std::runtime_error(fmt::format("no drawing on {}x{} pixels", width_, height_));
    }
    mesa_.pixel_store(kYUp, 0);
  }
  void end(Image& /*image*/) override { functions_.Finish(); }

 private:
  OsMesa mesa_;
  int width_;
  int height_;
  void* context_ = nullptr;
};

struct Egl {
#define GJKSCOPE_EGL(name, type) type name = nullptr;
#define GJKSCOPE_EGL_FUNCTIONS(FUNCTION)                         \
  FUNCTION(GetPlatformDisplay, PFNEGLGETPLATFORMDISPLAYPROC)     \
  FUNCTION(Initialize, PFNEGLINITIALIZEPROC)                     \
  FUNCTION(BindAPI, PFNEGLBINDAPIPROC)                           \
  FUNCTION(ChooseConfig, PFNEGLCHOOSECONFIGPROC)                 \
  FUNCTION(CreateContext, PFNEGLCREATECONTEXTPROC)               \
  FUNCTION(DestroyContext, PFNEGLDESTROYCONTEXTPROC)             \
  FUNCTION(CreatePbufferSurface, PFNEGLCREATEPBUFFERSURFACEPROC) \
  FUNCTION(DestroySurface, PFNEGLDESTROYSURFACEPROC)             \
  FUNCTION(MakeCurrent, PFNEGLMAKECURRENTPROC)                   \
  FUNCTION(GetProcAddress, PFNEGLGETPROCADDRESSPROC)
  GJKSCOPE_EGL_FUNCTIONS(GJKSCOPE_EGL)
#undef GJKSCOPE_EGL

  Egl() {
    const Library library("libEGL.so.1");
#define GJKSCOPE_EGL(name, type) library.find(name, "egl" #name);
    GJKSCOPE_EGL_FUNCTIONS(GJKSCOPE_EGL)
#undef GJKSCOPE_EGL
#undef GJKSCOPE_EGL_FUNCTIONS
  }
};

class EglContext : public GlContext {
 public:
  EglContext(int width, int height) : width_(width), height_(height) {
    // The same pixels on every machine, whatever graphics card it has.
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    display_ = egl_.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!display_) throw std::runtime_error("no display without a surface (that of Mesa has one)");
    // Once for all contexts: a display is the process's, and stays.
    if (!egl_.Initialize(display_, nullptr, nullptr))
      throw std::runtime_error("no renderer in software");
    constexpr std::array<EGLint, 13> kWanted = {EGL_SURFACE_TYPE,
                                                EGL_PBUFFER_BIT,
                                                EGL_RENDERABLE_TYPE,
                                                EGL_OPENGL_BIT,
                                                EGL_RED_SIZE,
                                                8,
                                                EGL_GREEN_SIZE,
                                                8,
                                                EGL_BLUE_SIZE,
                                                8,
                                                EGL_ALPHA_SIZE,
                                                8,
                                                EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl_.ChooseConfig(display_, kWanted.data(), &config, 1, &count) || count == 0) {
      throw std::runtime_error("no image of 8-bit RGBA");
    }
    const std::array<EGLint, 5> size = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    surface_ = egl_.CreatePbufferSurface(display_, config, size.data());
    egl_.BindAPI(EGL_OPENGL_API);
    context_ = egl_.CreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (!surface_ || !context_) {
      close();
      throw std::runtime_error(
          fmt::format("no context of OpenGL with {}x{} pixels", width, height));
    }
    find_functions(functions_, egl_.GetProcAddress);
  }
  ~EglContext() override { close(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void begin(Image& image) override {
    image.resize(width_, height_);
    egl_.BindAPI(EGL_OPENGL_API);
    if (!egl_.MakeCurrent(display_, surface_, surface_, context_)) {
      throw std::runtime_error(fmt::format("no drawing on {}x{} pixels", width_, height_));
    }
  }
  void end(Image& image) override {
    constexpr GLenum kPackInvert = 0x8758;  // GL_MESA_pack_invert: rows from top to bottom
    functions_.PixelStorei(kPackInvert, 1);
    functions_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  }

 private:
  void close() {
    egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_) egl_.DestroyContext(display_, context_);
    if (surface_) egl_.DestroySurface(display_, surface_);
  }

  Egl egl_;
  int width_;
  int height_;
  EGLDisplay display_ = nullptr;
  EGLSurface surface_ = nullptr;
  EGLContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context(int width, int height) {
  return std::make_unique<OsMesaContext>(width, height);
}

std::unique_ptr<GlContext> make_egl_context(int width, int height) {
  return std::make_unique<EglContext>(width, height);
}

}  // namespace gjkscope
