#pragma once
#include <filesystem>

namespace gjkscope {

/// The lesson that the window opens on.
[[nodiscard]] std::filesystem::path opening_lesson(const std::filesystem::path& share);
/// Whether a file stands in a folder.
[[nodiscard]] bool is_in(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace gjkscope
