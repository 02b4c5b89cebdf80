#pragma once
// Lessons to frames on disk: `gjkscope export`.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lesson/lesson.hpp"

namespace gjkscope {

struct ExportOptions {
  std::filesystem::path out_dir;     ///< Made when it is not there.
  std::filesystem::path assets_dir;  ///< Holds fonts.toml and themes/.
  std::string theme = "light";
  int width = 1280;
  int height = 720;
  std::optional<int> first_step;  ///< From 1; frames A..B of each lesson, all without.
  std::optional<int> last_step;   ///< Past the last frame means: to the last.
  int jobs = 0;                   ///< Threads that shrink, encode and write; 0: one a processor.
  std::string format = "png";
  bool questions = true;  ///< Frames that ask are among them.
  bool index = false;     ///< Also write index.html, the contact sheet of these lessons.
  bool progress = false;  ///< Say on stderr what is being done.
};

struct ExportResult {
  std::vector<std::filesystem::path> files;  ///< Written, in order: frames and sidecar by lesson.
  int frames = 0;
  double seconds = 0.0;  ///< Wall clock, everything included.
  int signal = 0;        ///< SIGINT or SIGTERM when one ended the export; what was complete stays.
  [[nodiscard]] double frames_per_second() const { return seconds > 0.0 ? frames / seconds : 0.0; }
};

/// Writes `<lesson>-0001.png` and so on, and `<lesson>.json` with the words and values of each
/// frame. Each file appears whole or not at all; the same lessons give the same bytes, whatever
/// `jobs` is. Throws std::runtime_error, naming the path, when something cannot be written, and
/// for a theme, a size or a range of steps that there is not.
[[nodiscard]] ExportResult export_lessons(const std::vector<Lesson>& lessons,
                                          const ExportOptions& options);

/// What `export --json` prints.
[[nodiscard]] std::string to_json(const ExportResult& result);

}  // namespace gjkscope
