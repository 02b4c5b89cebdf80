#include "paint/pdf.hpp"

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "paint/cairo_painter.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

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
      : fonts_(fonts), painter_(fonts, Medium::page), theme_(theme), transparent_(transparent) {
    surface_.reset(cairo_pdf_surface_create_for_stream(append, &bytes_, 1.0, 1.0));
    cairo_pdf_surface_restrict_to_version(surface_.get(), CAIRO_PDF_VERSION_1_4);
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
    draw(figure.picture, scale);
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
          wrapped(fonts_, kCaption, figures[i].caption,
                  layout.beside ? size.x() - wide - HandoutPage::kGap : size.x());
      const double below =
          layout.beside ? 0.0 : kLineHeight * (static_cast<double>(lines.size()) + 0.5);
      const double scale = std::min(wide / picture.width, (size.y() - below) / picture.height);
      cairo_save(cairo_.get());
      cairo_translate(cairo_.get(), slot.min.x(), slot.min.y());
      draw(picture, scale);
      cairo_restore(cairo_.get());
      write(lines, layout.beside ? Point(slot.min.x() + wide + HandoutPage::kGap, slot.min.y())
                                 : Point(slot.min.x(), slot.min.y() + scale * picture.height));
    }
    end_page(last);
  }

  std::string finish() {
    require(cairo_status(cairo_.get()), kWhat);
    cairo_.reset();
    cairo_surface_finish(surface_.get());
    require(cairo_surface_status(surface_.get()), kWhat);
    return std::move(bytes_);
  }

 private:
  static constexpr const char* kWhat = "make a PDF";
  static constexpr TextStyle kCaption{Face::regular, 9.0};
  static constexpr double kLineHeight = 12.0;
  static constexpr double kShareBeside = 0.6;  ///< The figure's share of a row's width.

  void begin_page(double width, double height, const std::string& label) {
    cairo_pdf_surface_set_size(surface_.get(), width, height);
    cairo_pdf_surface_set_page_label(surface_.get(), label.c_str());
    ++page_;
  }
  void bookmark(const std::string& title, double top) {
    cairo_pdf_surface_add_outline(surface_.get(), CAIRO_PDF_OUTLINE_ROOT, title.c_str(),
                                  fmt::format("page={} pos=[0 {}]", page_, top).c_str(),
                                  static_cast<cairo_pdf_outline_flags_t>(0));
  }
  void end_page(bool last) {
    if (last) cairo_tag_end(cairo_.get(), "Document");
    cairo_show_page(cairo_.get());
    require(cairo_status(cairo_.get()), kWhat);
  }

  void draw(const Picture& picture, double scale) {
    cairo_t* const cairo = cairo_.get();
    if (!transparent_) {
      const Color color = theme_.background();
      cairo_set_source_rgb(cairo, color.r / 255.0, color.g / 255.0, color.b / 255.0);
      cairo_rectangle(cairo, 0.0, 0.0, scale * picture.width, scale * picture.height);
      cairo_fill(cairo);
    }
    // Not around the background: cairo 1.16 forgets what came before a fill of the whole page, the
    // beginning of a tag, too.
    if (!std::exchange(in_document_, true)) cairo_tag_begin(cairo, "Document", nullptr);
    cairo_tag_begin(cairo, "Figure", nullptr);
    painter_.paint(cairo, picture, theme_, scale);
    cairo_tag_end(cairo, "Figure");
  }

  /// On paper, which is white.
  void write(const std::vector<std::string>& lines, Point at) {
    cairo_tag_begin(cairo_.get(), "Caption", nullptr);
    for (const std::string& line : lines) {
      at.y() += kLineHeight;
      painter_.write(cairo_.get(), Text{at, line, kCaption}, theme_, Color{0, 0, 0, 255});
    }
    cairo_tag_end(cairo_.get(), "Caption");
  }

  std::string bytes_;
  const Fonts& fonts_;
  CairoPainter painter_;
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
