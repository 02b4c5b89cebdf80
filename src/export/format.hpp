#pragma once
// Formats in which frames can be exported.

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace gjkscope {

enum class Format { png, svg, pdf, tex, gif, apng, mp4, webm };

/// By its name, which is also the ending of its files.
[[nodiscard]] std::optional<Format> format_of(std::string_view name);
[[nodiscard]] std::string_view name_of(Format format);
[[nodiscard]] std::span<const Format> all_formats();

/// Each frame is a file of its own; of the others a lesson is one file.
[[nodiscard]] constexpr bool has_file_per_frame(Format format) {
  return format == Format::png || format == Format::svg;
}
[[nodiscard]] constexpr bool is_film(Format format) { return format >= Format::gif; }

}  // namespace gjkscope
