#include "paint/cairo_painter.hpp"

#include <cairo-ft.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "paint/arrow.hpp"
#include "paint/cut.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

/// FreeType, and the bytes that its faces read. Cairo keeps faces after their last use, so each
/// holds on to this.
struct FontLibrary {
  explicit FontLibrary(const Fonts& fonts) : files(faces_of(fonts)) {
    if (FT_Init_FreeType(&freetype) != 0) throw std::runtime_error("FreeType does not start");
  }
  ~FontLibrary() { FT_Done_FreeType(freetype); }
  FontLibrary(const FontLibrary&) = delete;
  FontLibrary& operator=(const FontLibrary&) = delete;

  std::array<FaceBytes, kFaceCount> files;
  FT_Library freetype = nullptr;
};

}  // namespace

void require(cairo_status_t status, const char* what) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(fmt::format("cannot {}: {}", what, cairo_status_to_string(status)));
}

/// The font files as cairo and FreeType know them.
class CairoFaces {
 public:
  explicit CairoFaces(const Fonts& fonts)
      : fonts_(fonts), library_(std::make_shared<FontLibrary>(fonts)) {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      add(faces_[f].main, library_->files[f].main);
      add(faces_[f].fallback, library_->files[f].fallback);
    }
  }

  struct Glyph {
    cairo_font_face_t* face = nullptr;
    unsigned long index = 0;
    double advance = 0.0;  ///< In ems; and how far to the right it stands in it.
    double offset = 0.0;
  };
  [[nodiscard]] Glyph glyph(Face face, char32_t character) const {
    const Files& files = faces_[static_cast<std::size_t>(face)];
    const bool in_main = FT_Get_Char_Index(files.main.freetype, character) != 0;
    const File& file = in_main ? files.main : files.fallback;
    Glyph out{file.cairo.get(), FT_Get_Char_Index(file.freetype, character), 0.0, 0.0};
    if (out.index == 0) out.index = FT_Get_Char_Index(file.freetype, 0xFFFD);
    out.advance = fonts_.advance({face, 1.0}, character);
    // Figures stand in the middle of a place that is as wide as the widest.
    if (FT_Load_Glyph(file.freetype, static_cast<FT_UInt>(out.index), FT_LOAD_NO_SCALE) == 0) {
      const double own = static_cast<double>(file.freetype->glyph->metrics.horiAdvance) /
                         file.freetype->units_per_EM;
      out.offset = 0.5 * (out.advance - own);
    }
    return out;
  }
  [[nodiscard]] const Fonts& measures() const { return fonts_; }

 private:
  struct File {
    FT_Face freetype = nullptr;
    FaceHandle cairo;
  };
  struct Files {
    File main;
    File fallback;
  };
  void add(File& file, const std::vector<unsigned char>& bytes) const {
    if (FT_New_Memory_Face(library_->freetype, bytes.data(), static_cast<FT_Long>(bytes.size()), 0,
                           &file.freetype) != 0) {
      throw std::runtime_error("FreeType cannot read a font of assets/fonts.toml");
    }
    file.cairo.reset(cairo_ft_font_face_create_for_ft_face(file.freetype, FT_LOAD_NO_HINTING));
    require(cairo_font_face_status(file.cairo.get()), "use a font");
    static const cairo_user_data_key_t key = {};
    auto held = std::make_unique<std::shared_ptr<FontLibrary>>(library_);
    const auto let_go = [](void* library) {
      delete static_cast<std::shared_ptr<FontLibrary>*>(library);
    };
    require(cairo_font_face_set_user_data(file.cairo.get(), &key, held.get(), let_go),
            "use a font");
    static_cast<void>(held.release());
  }

  const Fonts& fonts_;
  std::shared_ptr<FontLibrary> library_;
  std::array<Files, kFaceCount> faces_;
};

namespace {

void add_box(cairo_t* cairo, const Rect& rect, double corner) {
  const double r = std::min(corner, 0.5 * rect.size().minCoeff());
  if (r <= 0.0) {
    cairo_rectangle(cairo, rect.min.x(), rect.min.y(), rect.size().x(), rect.size().y());
    return;
  }
  constexpr double kRight = 0.5 * std::numbers::pi;
  cairo_new_sub_path(cairo);
  cairo_arc(cairo, rect.max.x() - r, rect.min.y() + r, r, -kRight, 0.0);
  cairo_arc(cairo, rect.max.x() - r, rect.max.y() - r, r, 0.0, kRight);
  cairo_arc(cairo, rect.min.x() + r, rect.max.y() - r, r, kRight, 2.0 * kRight);
  cairo_arc(cairo, rect.min.x() + r, rect.min.y() + r, r, 2.0 * kRight, 3.0 * kRight);
  cairo_close_path(cairo);
}

/// One mark after the other.
class CairoMarks {
 public:
  CairoMarks(cairo_t* cairo, const CairoFaces& faces, const Theme& theme, Medium medium,
             const Rect& page, double scale)
      : cairo_(cairo), faces_(faces), theme_(theme), medium_(medium), scale_(scale) {
    // Cairo counts in 256ths of a pixel, up to 2^23 pixels. Lines are cut off more than a page
    // away, because neither their ends nor heads of arrows show there.
    const Point beyond = page.size() + Point::Constant(kMargin);
    drawn_ = {page.min - beyond, page.max + beyond};
  }

  void paint(const Mark& mark) {
    style_ = theme_.style(mark);
    std::visit(*this, mark.shape);
  }
  void set_style(const Style& style) { style_ = style; }

  void operator()(const Polygon& polygon) const {
    outline(polygon.points, true);
    fill(style_.fill);
    stroke(style_.stroke);
  }
  void operator()(const Polyline& line) const {
    std::vector<Point> points = line.points;
    if (medium_ == Medium::pixels && points.size() == 2) {
      align_to_pixels(points[0], points[1], style_, scale_);
    }
    const std::optional<Color> color = line.closed ? style_.stroke : line_color();
    // Cairo looks for all crossings within a path, in a time that grows with their number.
    constexpr std::size_t kMostAtOnce = 256;
    if (medium_ != Medium::pixels || points.size() <= kMostAtOnce || !style_.dash.empty()) {
      outline(points, line.closed);
      return stroke(color);
    }
    constexpr std::size_t kPiece = 32;
    if (line.closed) points.push_back(points.front());
    for (std::size_t first = 0; first + 1 < points.size(); first += kPiece) {
      outline(std::span(points).subspan(first, std::min(kPiece + 1, points.size() - first)), false);
      stroke(color);
    }
  }
  void operator()(const Arrow& arrow) const {
    const std::optional<ArrowParts> parts = arrow_parts(arrow, style_.width);
    if (!parts) return;
    if (parts->shaft_end) {
      outline(std::array{arrow.from, *parts->shaft_end}, false);
      stroke(line_color());
    }
    outline(parts->head, true);
    fill(line_color());
  }
  void operator()(const Disk& disk) const {
    const Point radius = Point::Constant(disk.radius);
    if (shows_whole(disk.center - radius) && shows_whole(disk.center + radius)) {
      cairo_new_path(cairo_);
      cairo_arc(cairo_, disk.center.x(), disk.center.y(), disk.radius, 0.0, 2.0 * std::numbers::pi);
      cairo_close_path(cairo_);
    } else {
      outline(circle(disk.center, disk.radius, scale_), true);
    }
    fill(style_.fill);
    stroke(style_.stroke);
  }
  void operator()(const Cross& cross) const {
    for (const Point& half : {Point(cross.radius, 0.0), Point(0.0, cross.radius)}) {
      outline(std::array<Point, 2>{cross.center - half, cross.center + half}, false);
      stroke(line_color());
    }
  }
  /// The outline lies inside.
  void operator()(const Box& box) const {
    const double inset = style_.stroke ? 0.5 * style_.width : 0.0;
    const Point by = Point::Constant(inset);
    const Rect rect{box.rect.min + by, box.rect.max - by};
    if ((rect.size().array() <= 0.0).any()) return;
    cairo_new_path(cairo_);
    add_box(cairo_, rect, std::max(0.0, box.corner - inset));
    fill(style_.fill);
    stroke(style_.stroke);
  }
  void operator()(const Text& text) const {
    if (!style_.fill || text.text.empty() || !shows_whole(text.at)) return;
    Point pen(box_of(faces_.measures(), text).min.x(), text.at.y());
    if (medium_ == Medium::pixels) pen.y() = std::round(pen.y() * scale_) / scale_;
    if (text.tones.empty()) write(text.style, text.text, *style_.fill, pen);
    for (const Tone& tone : text.tones) {
      write(text.style, tone.text, theme_.style(tone.role).fill.value_or(*style_.fill), pen);
    }
  }

 private:
  static constexpr double kMargin = 200.0;

  /// Part of a text, from `pen` on, which moves behind it.
  void write(const TextStyle& style, const std::string& part, const Color& color,
             Point& pen) const {
    source(color);
    cairo_set_font_size(cairo_, style.size);
    const std::u32string characters = code_points(part);
    // A stretch is what one font file draws.
    for (std::size_t i = 0; i < characters.size();) {
      cairo_font_face_t* const face = faces_.glyph(style.face, characters[i]).face;
      std::vector<cairo_glyph_t> glyphs;
      std::vector<cairo_text_cluster_t> clusters;
      std::string utf8;
      for (; i < characters.size(); ++i) {
        const CairoFaces::Glyph glyph = faces_.glyph(style.face, characters[i]);
        if (glyph.face != face) break;
        const std::string bytes = utf8_of(characters[i]);
        glyphs.push_back({glyph.index, pen.x() + style.size * glyph.offset, pen.y()});
        clusters.push_back({static_cast<int>(bytes.size()), 1});
        utf8 += bytes;
        pen.x() += style.size * glyph.advance;
      }
      cairo_set_font_face(cairo_, face);
      if (medium_ == Medium::page) {
        cairo_show_text_glyphs(cairo_, utf8.data(), static_cast<int>(utf8.size()), glyphs.data(),
                               static_cast<int>(glyphs.size()), clusters.data(),
                               static_cast<int>(clusters.size()),
                               static_cast<cairo_text_cluster_flags_t>(0));
      } else {
        // Not shown as glyphs: cairo 1.16 moves each onto a whole pixel.
        cairo_new_path(cairo_);
        cairo_glyph_path(cairo_, glyphs.data(), static_cast<int>(glyphs.size()));
        cairo_fill(cairo_);
      }
    }
  }

  [[nodiscard]] bool shows_whole(const Point& p) const {
    return (p.array() >= drawn_.min.array()).all() && (p.array() <= drawn_.max.array()).all();
  }
  /// The colour of a line, which a style may name as stroke or as fill.
  [[nodiscard]] std::optional<Color> line_color() const {
    return style_.stroke ? style_.stroke : style_.fill;
  }

  void outline(std::span<const Point> points, bool closed) const {
    cairo_new_path(cairo_);
    const auto add = [this](const Point& p) { cairo_line_to(cairo_, p.x(), p.y()); };
    if (std::all_of(points.begin(), points.end(),
                    [this](const Point& p) { return shows_whole(p); })) {
      std::for_each(points.begin(), points.end(), add);
    } else if (closed) {
      const auto& [a, b] = drawn_;
      const std::vector<Point> kept =
          intersect({points.begin(), points.end()}, {a, {b.x(), a.y()}, b, {a.x(), b.y()}});
      std::for_each(kept.begin(), kept.end(), add);
    } else {
      add_parts(points);
    }
    if (closed && cairo_has_current_point(cairo_)) cairo_close_path(cairo_);
  }
  void add_parts(std::span<const Point> points) const {
    const double period = std::accumulate(style_.dash.begin(), style_.dash.end(), 0.0);
    std::optional<Point> pen;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto part = visible_part(points[i - 1], points[i], drawn_, period);
      if (!part) continue;
      const auto& [from, to] = *part;
      if (pen != from) cairo_move_to(cairo_, from.x(), from.y());
      cairo_line_to(cairo_, to.x(), to.y());
      pen = to;
    }
  }

  void source(const Color& color) const {
    cairo_set_source_rgba(cairo_, color.r / 255.0, color.g / 255.0, color.b / 255.0,
                          color.a / 255.0);
  }
  /// These two keep the path.
  void fill(const std::optional<Color>& color) const {
    if (!color) return;
    source(*color);
    cairo_fill_preserve(cairo_);
  }
  void stroke(const std::optional<Color>& color) const {
    if (!color || style_.width <= 0.0) return;
    source(*color);
    cairo_set_line_width(cairo_, style_.width);
    cairo_set_dash(cairo_, style_.dash.data(), static_cast<int>(style_.dash.size()), 0.0);
    cairo_stroke_preserve(cairo_);
  }

  cairo_t* cairo_;
  const CairoFaces& faces_;
  const Theme& theme_;
  Medium medium_;
  double scale_;
  Rect drawn_;
  Style style_;
};

}  // namespace

CairoPainter::CairoPainter(const Fonts& fonts, Medium medium)
    : faces_(std::make_unique<CairoFaces>(fonts)), medium_(medium) {}
CairoPainter::~CairoPainter() = default;

void CairoPainter::paint(cairo_t* cairo, const Picture& picture, const Theme& theme,
                         double scale) const {
  CairoMarks painter(cairo, *faces_, theme, medium_,
                     {Point::Zero(), {picture.width, picture.height}}, scale);
  cairo_save(cairo);
  cairo_scale(cairo, scale, scale);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  int clip = -1;
  cairo_save(cairo);
  for (const Mark& mark : picture.marks) {
    if (mark.clip != clip) {
      cairo_restore(cairo);
      cairo_save(cairo);
      clip = mark.clip;
      if (clip >= 0) {
        const Rect& rect = picture.clips.at(static_cast<std::size_t>(clip));
        cairo_new_path(cairo);
        add_box(cairo, rect, picture.clip_corner);
        cairo_clip(cairo);
      }
    }
    painter.paint(mark);
  }
  cairo_restore(cairo);
  cairo_restore(cairo);
}

void CairoPainter::write(cairo_t* cairo, const Text& text, const Theme& theme,
                         const Color& ink) const {
  CairoMarks painter(cairo, *faces_, theme, medium_, {text.at, text.at}, 1.0);
  painter.set_style({ink, {}, 1.0, {}});
  painter(text);
}

}  // namespace gjkscope
