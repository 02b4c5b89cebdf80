#pragma once
// Fonts of the system for what the panels' own face cannot write: names of files and lessons.

#include <string>
#include <vector>

namespace gjkscope {

struct SystemFont {
  std::string file;
  int index = 0;  ///< The face in its file.
  std::u32string characters;
};

/// Fonts that together have these characters, as far as fontconfig knows of any; each character
/// comes once.
[[nodiscard]] std::vector<SystemFont> system_fonts_for(const std::u32string& characters);

}  // namespace gjkscope
