#pragma once
// Settings that the window remembers from one start to the next.

#include <filesystem>
#include <map>
#include <string>

namespace gjkscope {

inline constexpr double kSlowest = 0.25;  // frames a second
inline constexpr double kFastest = 32.0;
inline constexpr double kSmallestPanels = 0.875;  // their type has 13 pixels then
inline constexpr double kLargestPanels = 3.0;

/// How frames were exported last.
struct ExportSettings {
  std::string folder;  ///< Empty: none were.
  std::string format = "png";
  std::string theme = "light";
  int width = 1280;
  int height = 720;
  bool transparent = false;
  bool stage_only = false;
  friend bool operator==(const ExportSettings&, const ExportSettings&) = default;
};

struct Settings {
  std::string theme = "light";
  double panel_size = 1.0;  ///< The scale of the panels' type.
  double frames_per_second = 1.0;
  bool lessons = true;  ///< Their list stands beside the stage.
  bool thumbnails = true;
  bool motion = true;
  bool snaps = false;
  bool hexadecimal = false;
  std::map<std::string, double> drawers;  ///< Widths that were chosen, in pixels at scale 1.
  ExportSettings exported;
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// As the file says, as far as it does: what is not there, or cannot be read, is as at first.
[[nodiscard]] Settings read_settings(const std::filesystem::path& file);
[[nodiscard]] std::string settings_text(const Settings& settings);

}  // namespace gjkscope
