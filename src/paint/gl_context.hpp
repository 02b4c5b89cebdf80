#pragma once
// OpenGL without a display. Its libraries are looked for at run time: nothing links to them.

#include <GL/gl.h>

#include <memory>

#include "paint/image.hpp"

namespace gjkscope {

#define GJKSCOPE_GL_FUNCTIONS(FUNCTION) \
  FUNCTION(BindTexture)                 \
  FUNCTION(BlendFunc)                   \
  FUNCTION(Clear)                       \
  FUNCTION(ClearColor)                  \
  FUNCTION(ColorMask)                   \
  FUNCTION(ColorPointer)                \
  FUNCTION(DrawElements)                \
  FUNCTION(Enable)                      \
  FUNCTION(EnableClientState)           \
  FUNCTION(Finish)                      \
  FUNCTION(GenTextures)                 \
  FUNCTION(GetError)                    \
  FUNCTION(GetIntegerv)                 \
  FUNCTION(GetString)                   \
  FUNCTION(LoadIdentity)                \
  FUNCTION(MatrixMode)                  \
  FUNCTION(Ortho)                       \
  FUNCTION(PixelStorei)                 \
  FUNCTION(ReadPixels)                  \
  FUNCTION(Scissor)                     \
  FUNCTION(TexCoordPointer)             \
  FUNCTION(TexImage2D)                  \
  FUNCTION(TexParameteri)               \
  FUNCTION(VertexPointer)               \
  FUNCTION(Viewport)

/// The functions of OpenGL 2.1 that drawing here uses, under their names without "gl".
struct Gl {
// A declared name cannot stand in parentheses.
#define GJKSCOPE_MEMBER(name) decltype(&::gl##name) name{};  // NOLINT(bugprone-macro-parentheses)
  GJKSCOPE_GL_FUNCTIONS(GJKSCOPE_MEMBER)
#undef GJKSCOPE_MEMBER
};

/// A context of OpenGL 2.1 with an image to draw on, opaque or not, without depth or stencil.
class GlContext {
 public:
  virtual ~GlContext() = default;
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Is the calling thread's context from here on; it draws to `image`, which has its size.
  virtual void begin(Image& image) = 0;
  /// All that was drawn is in the image of `begin`.
  virtual void end(Image& image) = 0;
  [[nodiscard]] const Gl& gl() const { return functions_; }

 protected:
  Gl functions_;
};

/// OSMesa draws into memory, but has left Mesa with version 25.1; EGL without a surface of a
/// display (EGL_MESA_platform_surfaceless) is its successor. What they draw differs by one step of
/// 255 at most, in one pixel of 10,000 at most (tests/paint/canvas_test.cpp). Both throw
/// std::runtime_error saying what is missing.
[[nodiscard]] std::unique_ptr<GlContext> make_osmesa_context(int width, int height);
[[nodiscard]] std::unique_ptr<GlContext> make_egl_context(int width, int height);

}  // namespace gjkscope
