#pragma once
// Files that are read whole, and appear whole or not at all, and where the shipped ones are.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gjkscope {

/// Writes under a temporary name in the same folder and renames: whenever the process ends, there
/// is the old file or the new one. A file that is replaced keeps its permissions, a symbolic link
/// stays one. Throws std::runtime_error with the path and the system's reason; then nothing is left
/// behind.
void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
/// The same for what somebody wrote: the text is on the disk before it takes the old one's place,
/// so that a power failure does not leave half of it, either.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// The temporary name that `path` has while it is written.
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& path);

/// A file's bytes, or why there are none.
struct FileText {
  std::optional<std::string> text;
  std::string problem;
};
/// Gives files that a lesson names; of a larger file than `most_bytes` the first bytes, one more.
using FileReader =
    std::function<FileText(const std::filesystem::path& file, std::size_t most_bytes)>;
/// From the file system.
[[nodiscard]] FileText read_file(const std::filesystem::path& file, std::size_t most_bytes);

/// All bytes of a file. Throws std::runtime_error with the path and the reason.
[[nodiscard]] std::string read_whole(const std::filesystem::path& path);

/// Removes the temporary files that a killed process left in `folder`.
void remove_leftovers(const std::filesystem::path& folder);

/// In every exported file, as text: it may be replaced without asking.
[[nodiscard]] const std::string& signature();
/// Whether a file has these bytes in its first 64 KiB or its last MiB.
[[nodiscard]] bool mentions(const std::filesystem::path& file, std::string_view text);
/// Whether a file may be replaced: it is not there, or was exported.
[[nodiscard]] bool is_exported(const std::filesystem::path& file);
/// Throws std::runtime_error, naming the file, where it may not.
void refuse_foreign(const std::filesystem::path& file);

/// The folder of lessons/ and assets/: $GJKSCOPE_SHARE; else share/gjkscope beside the folder of
/// the program, if it is there; else the source tree that the program was built from.
[[nodiscard]] std::filesystem::path share_folder();

}  // namespace gjkscope
