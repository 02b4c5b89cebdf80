#pragma once
// Pictures to a Dear ImGui draw list. Knows nothing of the window or the image behind the list, nor
// of GL: the caller renders the list with the back end it has.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

struct ImDrawList;
struct ImFont;
struct ImFontAtlas;

namespace gjkscope {

/// The styles of type::all_styles() in a font atlas, for one scale.
class AtlasFonts {
 public:
  /// Adds the fonts to `atlas`, which the caller builds. `scale` is pixels of the atlas per frame
  /// pixel; `fonts` must outlive the building of the atlas.
  AtlasFonts(ImFontAtlas& atlas, const Fonts& fonts, double scale);

  struct Sized {
    const ImFont* font;
    double density;  ///< Pixels of the atlas per pixel of the glyphs' coordinates.
  };
  /// Throws std::out_of_range for a style that is not in type::all_styles().
  [[nodiscard]] const Sized& font(const TextStyle& style) const;
  [[nodiscard]] double scale() const { return scale_; }

 private:
  using GlyphRanges = std::vector<unsigned short>;

  double scale_;
  std::vector<std::pair<TextStyle, Sized>> fonts_;
  // Dear ImGui keeps pointers to these until the atlas is built. One set a face.
  std::vector<std::array<GlyphRanges, 2>> ranges_;
};

/// The place of a picture in a draw list: `origin` is its upper left corner, in pixels of the list.
struct DrawPlacement {
  Point origin = Point::Zero();
  double scale = 1.0;  ///< Pixels of the list per frame pixel; that of the fonts.
  /// Bound while shapes are drawn. Their texture coordinates are those of the font atlas's white
  /// pixel, so the atlas serves. A back end that draws plain colour without a texture may say so
  /// here: sampling the atlas for every pixel of a fill is most of the work of a software renderer.
  void* shape_texture = nullptr;
};

/// Appends the marks from index `first` on, and returns the index of the first one left out: the
/// number of marks, unless the list came near the 65,536 vertices that its indices can tell apart.
/// The background is the caller's.
[[nodiscard]] std::size_t paint_marks(ImDrawList& list, const Picture& picture, std::size_t first,
                                      const Theme& theme, const AtlasFonts& fonts,
                                      const DrawPlacement& placement);

}  // namespace gjkscope
