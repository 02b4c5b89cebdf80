#pragma once
// Files that appear whole or not at all.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace gjkscope {

/// Writes under a temporary name in the same folder and renames. Throws std::runtime_error with the
/// path and the system's reason; then nothing is left behind.
void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_whole(const std::filesystem::path& path, std::string_view text);

/// Removes the temporary files that a killed process left in `folder`.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace gjkscope
