#pragma once
// Themes: what each role looks like. Files in assets/themes; format in assets/themes/README.md.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
};

struct Style {
  std::optional<Color> fill;  ///< Also the colour of text.
  std::optional<Color> stroke;
  double width = 1.0;        ///< The width of the stroke, in frame pixels.
  std::vector<double> dash;  ///< On, off, ... in frame pixels; empty: solid.
};

/// The text of a theme's file, by the theme's name; nothing when there is no such theme.
using ThemeTexts = std::function<std::optional<std::string>(std::string_view name)>;

class Theme {
 public:
  /// Throws std::runtime_error with name.toml:line:column for a malformed theme, and for a name
  /// that `texts` does not know.
  [[nodiscard]] static Theme read(const ThemeTexts& texts, std::string_view name);
  /// Throws std::runtime_error with file:line:column for a malformed theme or an unknown name
  /// (naming those there are).
  [[nodiscard]] static Theme load(const std::filesystem::path& folder, std::string_view name);
  [[nodiscard]] static std::vector<std::string> names(const std::filesystem::path& folder);

  [[nodiscard]] Color background() const { return background_; }
  /// The same theme on another background.
  [[nodiscard]] Theme on(Color background) const {
    Theme theme = *this;
    theme.background_ = background;
    return theme;
  }
  /// The opaque colours of its styles, and its background, the first.
  [[nodiscard]] std::vector<Color> colors() const;
  /// The style of `role`, or of its nearest ancestor ("a.b.c", "a.b", "a"). Throws
  /// std::out_of_range when there is none: every role that pictures use must be in every theme
  /// (tested).
  [[nodiscard]] const Style& style(std::string_view role) const;
  /// The style of its role, as faint as the mark is.
  [[nodiscard]] Style style(const Mark& mark) const;

 private:
  [[nodiscard]] static Theme resolve(const ThemeTexts& texts, std::string_view name,
                                     const std::filesystem::path& folder);

  Color background_;
  std::map<std::string, Style, std::less<>> styles_;
};

}  // namespace gjkscope
