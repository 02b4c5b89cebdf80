#pragma once
// Pictures by cairo: vectors on the pages of a document, or pixels.

#include <cairo.h>

#include <memory>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using SurfaceHandle = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>>;
using CairoHandle = std::unique_ptr<cairo_t, Destroy<cairo_destroy>>;
using FaceHandle = std::unique_ptr<cairo_font_face_t, Destroy<cairo_font_face_destroy>>;

/// Throws std::runtime_error "cannot `what`: ...", unless all is well.
void require(cairo_status_t status, const char* what);

class CairoFaces;

/// On pages texts stay texts. Among pixels, base lines and thin lines along an axis stand on whole
/// ones.
enum class Medium { page, pixels };

class CairoPainter {
 public:
  /// Throws std::runtime_error when FreeType cannot read a font. `fonts` stays the caller's.
  CairoPainter(const Fonts& fonts, Medium medium);
  ~CairoPainter();
  CairoPainter(const CairoPainter&) = delete;
  CairoPainter& operator=(const CairoPainter&) = delete;

  /// All marks, at `scale` units of `cairo` for each unit of the picture. The background is the
  /// caller's.
  void paint(cairo_t* cairo, const Picture& picture, const Theme& theme, double scale) const;
  /// One line of text.
  void write(cairo_t* cairo, const Text& text, const Theme& theme, const Color& ink) const;

 private:
  std::unique_ptr<const CairoFaces> faces_;
  Medium medium_;
};

}  // namespace gjkscope
