#pragma once
// Lessons to frames on disk: `gjkscope export`.

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "export/format.hpp"
#include "lesson/lesson.hpp"
#include "paint/canvas.hpp"

namespace gjkscope {

/// The place of captions: in the frame, nowhere, or in a text file beside it.
enum class CaptionPlace { below, none, file };

struct ExportOptions {
  std::filesystem::path out_dir;     ///< Made when it is not there.
  std::filesystem::path assets_dir;  ///< Holds fonts.toml and themes/.
  std::string file_name;  ///< In `out_dir`, of the one file that is asked for; empty: by lesson.
  Format format = Format::png;
  std::string theme = "light";
  int width = 1280;
  int height = 720;
  double scale = 1.0;        ///< Pixels of an image for each of width and height.
  double dpi = 0.0;          ///< Pixels of width and height an inch, where files say so; 0: 72.
  bool transparent = false;  ///< png, svg, pdf, tex: no background.
  bool stage_only = false;   ///< Nothing but the stages, and captions below them.
  int handout = 0;           ///< pdf: frames a page, with captions; 0: one page a frame.
  double seconds = 2.0;      ///< Films: how long a frame is shown; the last twice as long.
  int fps = 0;  ///< Images a second of what moves from frame to frame; 0: frames follow at once.
  double turn = 0.0;  ///< Films of lessons in space: degrees that the eye walks around meanwhile.
  CaptionPlace caption = CaptionPlace::below;
  std::optional<int> first_step;  ///< From 1; frames A..B of each lesson, all without.
  std::optional<int> last_step;   ///< Past the last frame means: to the last.
  int jobs = 0;                   ///< Threads that paint, encode and write; 0: one a processor.
  Renderer renderer = Renderer::cairo;  ///< The library that draws pixels.
  bool questions = true;                ///< Frames that ask are among them.
  bool index = false;     ///< png: also write index.html, the contact sheet of these lessons.
  bool progress = false;  ///< Say on stderr what is being done.
  /// Called for each frame of a lesson, in the thread that exports.
  std::function<void(int done, int count)> on_progress = {};
  /// Ends the export as a signal does. With one that can be asked, signals are left to the caller.
  std::stop_token stop = {};
  bool force = false;  ///< Replace files that were not exported; make again what is up to date.
};

struct ExportResult {
  std::vector<std::filesystem::path> files;  ///< In order: frames and sidecar by lesson.
  int frames = 0;                            ///< All that the files show,
  int kept = 0;                              ///< and those in files that were up to date.
  double seconds = 0.0;                      ///< Wall clock, everything included.
  int signal = 0;  ///< SIGINT or SIGTERM when one ended the export; what was complete stays.
  bool is_complete = true;  ///< False where a signal, or ExportOptions::stop, ended it before.
  [[nodiscard]] double frames_per_second() const { return seconds > 0.0 ? frames / seconds : 0.0; }
};

/// Writes `<lesson>-0001.png` and so on, with what leads to the second as `<lesson>-0002-01.png`,
/// or `<lesson>.pdf`, and `<lesson>.json` with the words and values of each frame. Each file
/// appears whole or not at all, and holds a record of what it shows and was made from
/// (export/record.hpp); the same lessons give the same bytes, whatever `jobs` is. A file whose
/// record says that it was made from the same lesson, theme, fonts, options and program is up to
/// date, and stays. Throws std::runtime_error, naming the path, when something cannot be written,
/// or would replace what was not exported, and for a theme, a size or a range of steps that there
/// is not.
[[nodiscard]] ExportResult export_lessons(const std::vector<Lesson>& lessons,
                                          const ExportOptions& options);

/// The output of `export --json`.
[[nodiscard]] std::string to_json(const ExportResult& result);

}  // namespace gjkscope
