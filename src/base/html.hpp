#pragma once
// Helpers for pages and SVG.

#include <string>
#include <string_view>

namespace gjkscope {

/// Text as HTML and SVG show it, in elements and in quoted attributes.
[[nodiscard]] std::string escape_html(std::string_view text);

/// `page` with `content` in the place of `mark`; as it is without the mark.
[[nodiscard]] std::string with_content(std::string page, std::string_view mark,
                                       const std::string& content);

}  // namespace gjkscope
