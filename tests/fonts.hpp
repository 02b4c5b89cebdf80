#pragma once
// The shipped fonts, read once for all tests of a program.

#include <filesystem>

#include "picture/type.hpp"

namespace gjkscope::testing {

inline const Fonts& fonts() {
  static const Fonts loaded(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  return loaded;
}

}  // namespace gjkscope::testing
