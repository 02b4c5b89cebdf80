#include "paint/pdf.hpp"

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "paint/arrow.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

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

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(fmt::format("cannot make a PDF: {}", cairo_status_to_string(status)));
}

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

/// The font files as cairo and FreeType know them.
class PdfFonts {
 public:
  explicit PdfFonts(const Fonts& fonts)
      : fonts_(fonts), library_(std::make_shared<FontLibrary>(fonts)) {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      add(faces_[f].main, library_->files[f].main);
      add(faces_[f].fallback, library_->files[f].fallback);
    }
  }

  struct Glyph {
    const cairo_font_face_t* face = nullptr;
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
    require(cairo_font_face_status(file.cairo.get()));
    static const cairo_user_data_key_t key = {};
    auto held = std::make_unique<std::shared_ptr<FontLibrary>>(library_);
    require(cairo_font_face_set_user_data(file.cairo.get(), &key, held.get(), [](void* library) {
      delete static_cast<std::shared_ptr<FontLibrary>*>(library);
    }));
    static_cast<void>(held.release());
  }

  const Fonts& fonts_;
  std::shared_ptr<FontLibrary> library_;
  std::array<Files, kFaceCount> faces_;
};

/// One mark onto the page.
class PagePainter {
 public:
  PagePainter(cairo_t* cairo, const PdfFonts& fonts, const Theme& theme, const Style& style)
      : cairo_(cairo), fonts_(fonts), theme_(theme), style_(style) {}

  void operator()(const Polygon& polygon) const {
    outline(polygon.points, true);
    paint(style_.fill, style_.stroke);
  }
  void operator()(const Polyline& line) const {
    outline(line.points, line.closed);
    paint({}, line.closed ? style_.stroke : line_color());
  }
  void operator()(const Arrow& arrow) const {
    const std::optional<ArrowParts> parts = arrow_parts(arrow, style_.width);
    if (!parts) return;
    if (parts->shaft_end) {
      outline(std::array{arrow.from, *parts->shaft_end}, false);
      paint({}, line_color());
    }
    outline(parts->head, true);
    paint(line_color(), {});
  }
  void operator()(const Disk& disk) const {
    cairo_new_path(cairo_);
    cairo_arc(cairo_, disk.center.x(), disk.center.y(), disk.radius, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(cairo_);
    paint(style_.fill, style_.stroke);
  }
  void operator()(const Cross& cross) const {
    const Point x(cross.radius, 0.0);
    const Point y(0.0, cross.radius);
    for (const Point& half : {x, y}) {
      outline(std::array<Point, 2>{cross.center - half, cross.center + half}, false);
      paint({}, line_color());
    }
  }
  /// The outline lies inside.
  void operator()(const Box& box) const {
    const double inset = style_.stroke ? 0.5 * style_.width : 0.0;
    const Point by = Point::Constant(inset);
    const Rect rect{box.rect.min + by, box.rect.max - by};
    if ((rect.size().array() <= 0.0).any()) return;
    rounded(cairo_, rect, std::max(0.0, box.corner - inset));
    paint(style_.fill, style_.stroke);
  }
  void operator()(const Text& text) const {
    if (!style_.fill || text.text.empty()) return;
    double pen = box_of(fonts_.measures(), text).min.x();
    if (text.tones.empty()) write(text, code_points(text.text), *style_.fill, pen);
    for (const Tone& tone : text.tones) {
      write(text, code_points(tone.text), theme_.style(tone.role).fill.value_or(*style_.fill), pen);
    }
  }

  static void rounded(cairo_t* cairo, const Rect& rect, double corner) {
    const double r = std::min(corner, 0.5 * rect.size().minCoeff());
    cairo_new_path(cairo);
    if (r <= 0.0) {
      cairo_rectangle(cairo, rect.min.x(), rect.min.y(), rect.size().x(), rect.size().y());
      return;
    }
    constexpr double kRight = 0.5 * std::numbers::pi;
    cairo_arc(cairo, rect.max.x() - r, rect.min.y() + r, r, -kRight, 0.0);
    cairo_arc(cairo, rect.max.x() - r, rect.max.y() - r, r, 0.0, kRight);
    cairo_arc(cairo, rect.min.x() + r, rect.max.y() - r, r, kRight, 2.0 * kRight);
    cairo_arc(cairo, rect.min.x() + r, rect.min.y() + r, r, 2.0 * kRight, 3.0 * kRight);
    cairo_close_path(cairo);
  }

 private:
  /// Part of a text, from `pen` on, which moves behind it.
  void write(const Text& text, const std::u32string& characters, const Color& color,
             double& pen) const {
    source(color);
    const double size = text.style.size;
    // A stretch is what one font file draws.
    for (std::size_t i = 0; i < characters.size();) {
      const cairo_font_face_t* const face = fonts_.glyph(text.style.face, characters[i]).face;
      std::vector<cairo_glyph_t> glyphs;
      std::vector<cairo_text_cluster_t> clusters;
      std::string utf8;
      for (; i < characters.size(); ++i) {
        const PdfFonts::Glyph glyph = fonts_.glyph(text.style.face, characters[i]);
        if (glyph.face != face) break;
        const std::string bytes = utf8_of(characters[i]);
        glyphs.push_back({glyph.index, pen + size * glyph.offset, text.at.y()});
        clusters.push_back({static_cast<int>(bytes.size()), 1});
        utf8 += bytes;
        pen += size * glyph.advance;
      }
      cairo_set_font_face(cairo_, const_cast<cairo_font_face_t*>(face));
      cairo_set_font_size(cairo_, size);
      cairo_show_text_glyphs(cairo_, utf8.data(), static_cast<int>(utf8.size()), glyphs.data(),
                             static_cast<int>(glyphs.size()), clusters.data(),
                             static_cast<int>(clusters.size()),
                             static_cast<cairo_text_cluster_flags_t>(0));
    }
  }

  void source(const Color& color) const {
    cairo_set_source_rgba(cairo_, color.r / 255.0, color.g / 255.0, color.b / 255.0,
                          color.a / 255.0);
  }
  /// What is only a line may name its colour either way.
  [[nodiscard]] std::optional<Color> line_color() const {
    return style_.stroke ? style_.stroke : style_.fill;
  }
  void outline(std::span<const Point> points, bool closed) const {
    cairo_new_path(cairo_);
    for (const Point& p : points) cairo_line_to(cairo_, p.x(), p.y());
    if (closed && !points.empty()) cairo_close_path(cairo_);
  }
  void paint(const std::optional<Color>& fill, const std::optional<Color>& stroke) const {
    if (fill) {
      source(*fill);
      cairo_fill_preserve(cairo_);
    }
    if (stroke && style_.width > 0.0) {
      source(*stroke);
      cairo_set_line_width(cairo_, style_.width);
      cairo_set_dash(cairo_, style_.dash.data(), static_cast<int>(style_.dash.size()), 0.0);
      cairo_stroke_preserve(cairo_);
    }
    cairo_new_path(cairo_);
  }

  cairo_t* cairo_;
  const PdfFonts& fonts_;
  const Theme& theme_;
  const Style& style_;
};

cairo_status_t append(void* out, const unsigned char* bytes, unsigned length) {
  static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

/// A4 in points, and how a handout divides it.
struct HandoutPage {
  static constexpr double kWidth = 595.0;
  static constexpr double kHeight = 842.0;
  static constexpr double kMargin = 36.0;
  static constexpr double kGap = 18.0;
  int columns = 1;
  int rows = 1;
  bool beside = false;  ///< Captions stand to the right of figures, not below.

  explicit HandoutPage(int figures)
      : columns(figures > 4 ? 2 : 1),
        rows((figures + columns - 1) / columns),
        beside(columns == 1 && figures > 2) {}

  [[nodiscard]] Rect slot(int index) const {
    const Point size((kWidth - 2 * kMargin - (columns - 1) * kGap) / columns,
                     (kHeight - 2 * kMargin - (rows - 1) * kGap) / rows);
    const int row = index / columns;
    const Point min(kMargin + (index % columns) * (size.x() + kGap),
                    kMargin + row * (size.y() + kGap));
    return {min, min + size};
  }
};

class PdfWriter {
 public:
  PdfWriter(const Fonts& fonts, const Theme& theme, const PdfWords& words, bool transparent)
      : fonts_(fonts), theme_(theme), transparent_(transparent) {
    surface_.reset(cairo_pdf_surface_create_for_stream(append, &bytes_, 1.0, 1.0));
    cairo_pdf_surface_restrict_to_version(surface_.get(), CAIRO_PDF_VERSION_1_5);
    const auto say = [&](cairo_pdf_metadata_t key, const std::string& text) {
      if (!text.empty()) cairo_pdf_surface_set_metadata(surface_.get(), key, text.c_str());
    };
    say(CAIRO_PDF_METADATA_TITLE, words.title);
    say(CAIRO_PDF_METADATA_SUBJECT, words.subject);
    say(CAIRO_PDF_METADATA_KEYWORDS, words.keywords);
    say(CAIRO_PDF_METADATA_CREATOR, "gjkscope");
    // Not the time of day: same figures, same bytes. What is no date leaves the date out.
    say(CAIRO_PDF_METADATA_CREATE_DATE, "none");
    cairo_.reset(cairo_create(surface_.get()));
  }

  void page(const PdfFigure& figure, double scale, bool last) {
    begin_page(scale * figure.picture.width, scale * figure.picture.height, figure.label);
    bookmark(figure.title, 0.0);
    cairo_save(cairo_.get());
    cairo_scale(cairo_.get(), scale, scale);
    draw(figure.picture);
    cairo_restore(cairo_.get());
    end_page(last);
  }

  void handout(std::span<const PdfFigure> figures, int count, bool last) {
    const HandoutPage layout(count);
    begin_page(HandoutPage::kWidth, HandoutPage::kHeight, figures.front().label);
    for (std::size_t i = 0; i < figures.size(); ++i) {
      const Picture& picture = figures[i].picture;
      const Rect slot = layout.slot(static_cast<int>(i));
      bookmark(figures[i].title, slot.min.y());
      const Point size = slot.size();
      const double wide = layout.beside ? kShareBeside * size.x() : size.x();
      const std::vector<std::string> lines =
          wrapped(fonts_.measures(), kCaption, figures[i].caption,
                  layout.beside ? size.x() - wide - HandoutPage::kGap : size.x());
      const double below =
          layout.beside ? 0.0 : kLineHeight * (static_cast<double>(lines.size()) + 0.5);
      const double scale = std::min(wide / picture.width, (size.y() - below) / picture.height);
      cairo_save(cairo_.get());
      cairo_translate(cairo_.get(), slot.min.x(), slot.min.y());
      cairo_scale(cairo_.get(), scale, scale);
      draw(picture);
      cairo_restore(cairo_.get());
      write(lines, layout.beside ? Point(slot.min.x() + wide + HandoutPage::kGap, slot.min.y())
                                 : Point(slot.min.x(), slot.min.y() + scale * picture.height));
    }
    end_page(last);
  }

  std::string finish() {
    require(cairo_status(cairo_.get()));
    cairo_.reset();
    cairo_surface_finish(surface_.get());
    require(cairo_surface_status(surface_.get()));
    return std::move(bytes_);
  }

 private:
  static constexpr TextStyle kCaption{Face::regular, 9.0};
  static constexpr double kLineHeight = 12.0;
  static constexpr double kShareBeside = 0.6;  ///< Of a row's width, for the figure.

  void begin_page(double width, double height, const std::string& label) {
    cairo_pdf_surface_set_size(surface_.get(), width, height);
    cairo_pdf_surface_set_page_label(surface_.get(), label.c_str());
    ++page_;
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_ROUND);
  }
  void bookmark(const std::string& title, double top) {
    cairo_pdf_surface_add_outline(surface_.get(), CAIRO_PDF_OUTLINE_ROOT, title.c_str(),
                                  fmt::format("page={} pos=[0 {}]", page_, top).c_str(),
                                  static_cast<cairo_pdf_outline_flags_t>(0));
  }
  void end_page(bool last) {
    if (last) cairo_tag_end(cairo_.get(), "Document");
    cairo_show_page(cairo_.get());
    require(cairo_status(cairo_.get()));
  }

  void draw(const Picture& picture) {
    cairo_t* const cairo = cairo_.get();
    if (!transparent_) {
      const Color color = theme_.background();
      cairo_set_source_rgb(cairo, color.r / 255.0, color.g / 255.0, color.b / 255.0);
      cairo_rectangle(cairo, 0.0, 0.0, picture.width, picture.height);
      cairo_fill(cairo);
    }
    // Not around the background: cairo 1.16 forgets what came before a fill of the whole page, the
    // beginning of a tag, too.
    if (!std::exchange(in_document_, true)) cairo_tag_begin(cairo, "Document", nullptr);
    cairo_tag_begin(cairo, "Figure", nullptr);
    for (const Mark& mark : picture.marks) {
      if (mark.clip >= 0) {
        cairo_save(cairo);
        PagePainter::rounded(cairo, picture.clips[static_cast<std::size_t>(mark.clip)],
                             picture.clip_corner);
        cairo_clip(cairo);
      }
      std::visit(PagePainter(cairo, fonts_, theme_, theme_.style(mark)), mark.shape);
      if (mark.clip >= 0) cairo_restore(cairo);
    }
    cairo_tag_end(cairo, "Figure");
  }

  /// On paper, which is white.
  void write(const std::vector<std::string>& lines, Point at) {
    const Style ink{Color{0, 0, 0, 255}, {}, 1.0, {}};
    const PagePainter painter(cairo_.get(), fonts_, theme_, ink);
    cairo_tag_begin(cairo_.get(), "Caption", nullptr);
    for (const std::string& line : lines) {
      at.y() += kLineHeight;
      painter(Text{at, line, kCaption, Align::left});
    }
    cairo_tag_end(cairo_.get(), "Caption");
  }

  std::string bytes_;
  PdfFonts fonts_;
  const Theme& theme_;
  bool transparent_;
  SurfaceHandle surface_;
  CairoHandle cairo_;
  int page_ = 0;
  bool in_document_ = false;  ///< Its tag is open.
};

}  // namespace

std::string to_pdf(const std::vector<PdfFigure>& figures, const Fonts& fonts, const Theme& theme,
                   const PdfWords& words, const PdfLayout& layout) {
  PdfWriter writer(fonts, theme, words, layout.transparent);
  const std::span all(figures);
  if (layout.handout == 0) {
    for (const PdfFigure& figure : all) writer.page(figure, layout.scale, &figure == &all.back());
  } else {
    const auto step = static_cast<std::size_t>(std::clamp(layout.handout, 1, kMostOnHandout));
    for (std::size_t at = 0; at < all.size(); at += step) {
      const std::size_t count = std::min(step, all.size() - at);
      writer.handout(all.subspan(at, count), layout.handout, at + count == all.size());
    }
  }
  return writer.finish();
}

}  // namespace gjkscope
