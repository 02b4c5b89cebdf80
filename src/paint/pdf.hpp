#pragma once
// Pictures to pages. Vectors and text, without a renderer.

#include <memory>
#include <string>
#include <vector>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

/// Words about the document that its file holds.
struct PdfWords {
  std::string title;
  std::string subject;
  std::string keywords;
};

/// A picture and what is said below it on a handout.
struct PdfFigure {
  Picture picture;
  std::string label;    ///< The label of its page: "polygons-gjk 3".
  std::string title;    ///< The title of its bookmark: "3. iteration 1 of 4 · closest".
  std::string caption;  ///< May have several lines.
};

struct PdfLayout {
  double scale = 1.0;        ///< Points for each unit of a picture.
  int handout = 0;           ///< Figures with captions on a page of A4; 0: a page each.
  bool transparent = false;  ///< No background.
};
inline constexpr int kMostOnHandout = 8;

/// A document of figures. Texts are texts, fonts are embedded as far as they are used. Same
/// figures, same bytes. Throws std::runtime_error when cairo cannot.
[[nodiscard]] std::string to_pdf(const std::vector<PdfFigure>& figures, const Fonts& fonts,
                                 const Theme& theme, const PdfWords& words,
                                 const PdfLayout& layout = {});

}  // namespace gjkscope
