#pragma once
// The stop tests that a file may choose, in [query] and for a second run.

#include <array>
#include <optional>
#include <string_view>

#include "lesson/names.hpp"
#include "lesson/toml_reader.hpp"
#include "lesson/toml_text.hpp"

namespace gjkscope {

inline constexpr std::array kStopTestNames = {name_of(gjk::StopReason::repeated_support),
                                              name_of(gjk::StopReason::no_progress)};
inline constexpr std::string_view kStopTests = "list of: repeated-support, no-progress";

/// Which of them are on; none where there is no such field.
[[nodiscard]] std::optional<std::array<bool, 2>> read_stop_tests(toml_file::Reader& reader,
                                                                 const toml_file::Field& field);
void write_stop_tests(TomlText& out, const std::array<bool, 2>& tests);

}  // namespace gjkscope
