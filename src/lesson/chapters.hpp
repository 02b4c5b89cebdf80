#pragma once
// Titles of the chapters that lessons belong to: assets/chapters.toml.

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace gjkscope {

/// The number that a key of a file stands for; none where it is no number.
[[nodiscard]] std::optional<int> chapter_number(std::string_view key);

/// By number. Throws std::runtime_error, with the place, where the text is not of this form; `name`
/// stands for the file.
[[nodiscard]] std::map<int, std::string> parse_chapters(std::string_view text,
                                                        std::string_view name);

}  // namespace gjkscope
