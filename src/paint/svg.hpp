#pragma once
// Pictures to vectors.

#include <string>

#include "picture/picture.hpp"
#include "picture/theme.hpp"

namespace gjkscope {

/// The picture as an SVG file: each mark an element, each text a text, in the faces of
/// assets/fonts.toml or what stands for them where it is opened, `zoom` times as wide as it was
/// laid out. `title` describes the picture to readers who cannot see it. Each mark says its role
/// (data-mark) and, where it stands for something, what (data-of, as `subject_name` says). Same
/// picture, same bytes. `record`: what the file says of itself to programs. `transparent`: no
/// background.
[[nodiscard]] std::string to_svg(const Picture& picture, const Fonts& fonts, const Theme& theme,
                                 const std::string& title, const std::string& record = {},
                                 bool transparent = false, double zoom = 1.0);

/// "x 1" and "y 2": vertices; "X", "Y": shapes; "z 1 2": the difference of vertices 1 of X and 2 of
/// Y; "Z": the difference; "region 3", "frame 4", "phase 2", "dot 5". Empty for none.
[[nodiscard]] std::string subject_name(const Subject& subject);

}  // namespace gjkscope
