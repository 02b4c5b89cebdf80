#pragma once
// Places in JSON texts, for messages about their values.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

/// Keys and indices.
using JsonPath = std::vector<std::string>;

[[nodiscard]] std::size_t skip_space(std::string_view text, std::size_t at);
/// One past the value that begins at `at`, which need not be well-formed.
[[nodiscard]] std::size_t skip_value(std::string_view text, std::size_t at);
/// The beginning of the value at `path` in a well-formed text.
[[nodiscard]] std::size_t find_value(std::string_view text, std::size_t at, const JsonPath& path);

/// A number, or a string that holds one ("0.1", "0x1.8p-4", "nan"); nothing where it is neither.
[[nodiscard]] std::optional<double> number_in(const nlohmann::ordered_json& value);

}  // namespace gjkscope
