#pragma once
// Pictures to vectors.

#include <string>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

/// The picture as an SVG file: each mark an element, each text a text, in the faces of
/// assets/fonts.toml or what stands for them where it is opened, as wide as it was laid out.
/// `title` is what readers that do not see it are told. Same picture, same bytes.
[[nodiscard]] std::string to_svg(const Picture& picture, const Fonts& fonts, const Theme& theme,
                                 const std::string& title);

}  // namespace gjkscope
