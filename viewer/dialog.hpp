#pragma once
// Dialogs, asked before all else: one at a time, in the middle of the window.

#include <filesystem>
#include <functional>
#include <string>

namespace gjkscope {

class App;

struct Dialog {
  std::string title;
  std::function<void()> draw;
};

[[nodiscard]] Dialog open_dialog(App& app);
/// Asks for the name of a file, and once more before one is overwritten that is not `own`.
[[nodiscard]] Dialog save_dialog(App& app, const std::string& title, const std::string& suggestion,
                                 const std::filesystem::path& own,
                                 std::function<void(const std::filesystem::path&)> save);
/// Unsaved work that other windows left: a list to open or discard one by one.
[[nodiscard]] Dialog left_work_dialog(App& app);
/// Before work goes that is kept nowhere.
[[nodiscard]] Dialog quit_dialog(App& app, std::function<void()> quit);
inline constexpr const char* kQuitTitle = "Work would be lost";
/// The most pixels of an exported image along each side.
inline constexpr int kMostPixels = 16384;
[[nodiscard]] Dialog export_dialog(App& app);
[[nodiscard]] Dialog keys_dialog(App& app);
/// Any command, lesson, effect or scalar by a part of its name.
[[nodiscard]] Dialog palette_dialog(App& app);

}  // namespace gjkscope
