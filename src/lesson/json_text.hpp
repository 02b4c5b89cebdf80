#pragma once
// Places in a text of JSON, which need not be well-formed.

#include <cstddef>
#include <string_view>

namespace gjkscope {

[[nodiscard]] std::size_t skip_space(std::string_view text, std::size_t at);
/// One past the string that begins at `at`.
[[nodiscard]] std::size_t skip_string(std::string_view text, std::size_t at);
/// One past the value that begins at `at`.
[[nodiscard]] std::size_t skip_value(std::string_view text, std::size_t at);

}  // namespace gjkscope
