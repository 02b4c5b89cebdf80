#pragma once
// A log of any GJK, opened as a lesson that sets it beside this one.

#include <optional>
#include <string>
#include <string_view>

#include "lesson/load.hpp"

namespace gjkscope {

/// The lesson of a log, or its problems; nothing where the text is no log. `file` is the log's.
[[nodiscard]] std::optional<LoadedLesson> log_as_lesson(std::string_view text,
                                                        const std::filesystem::path& file);

}  // namespace gjkscope
