// Dialogs about unsaved work: that of windows that are gone, and this window's before it goes.

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <chrono>
#include <optional>

#include "app.hpp"
#include "dialog.hpp"
#include "lesson/load.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

constexpr float kDialogWidth = 40.0f;  // ems
constexpr float kHeight = 26.0f;       // ems

std::string clock_text(const fs::file_time_type& time) {
  const auto moment = std::chrono::file_clock::to_sys(time);
  const std::time_t seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(moment));
  return fmt::format("{:%d %b %Y, %H:%M}", fmt::localtime(seconds));
}

std::string title_of(const UnsavedWork::Left& left) {
  const LoadedLesson loaded =
      parse_lesson(left.text, left.file.empty() ? "unsaved.toml" : left.file, vocabulary());
  return loaded.lesson ? loaded.lesson->title : "a lesson that cannot be read";
}

struct LeftWorkList {
  App& app;
  std::vector<std::string> titles;  ///< One for each piece, in the list's order.

  void draw() {
    std::vector<App::LeftWork>& all = app.left_work();
    if (titles.size() != all.size()) {
      titles.clear();
      for (const App::LeftWork& each : all) titles.push_back(title_of(each.work));
    }
    const float em = ImGui::GetFontSize();
    std::optional<std::size_t> opened;
    ImGui::BeginChild("##works", ImVec2(kDialogWidth * em, kHeight * em));
    for (std::size_t i = 0; i < all.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (draw_work(all[i], titles[i])) opened = i;
      ImGui::PopID();
      ImGui::Separator();
    }
    ImGui::EndChild();
    wrapped_text("What is discarded can be put back until this window ends.");
    if (ImGui::Button("Close")) app.close_dialog();
    if (!opened) return;
    app.close_dialog();
    (void)app.open_left(*opened);
  }

  /// True when it is to be opened.
  bool draw_work(App::LeftWork& each, const std::string& title) {
    const UnsavedWork::Left& work = each.work;
    const float em = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(6.0f * em, 4.0f * em);
    app.draw_small_picture(work.kept_in, at, size);
    ImGui::Dummy(size);
    ImGui::SameLine();
    ImGui::BeginGroup();
    heading(app, title);
    ImGui::TextDisabled("%s    %s", clock_text(work.time).c_str(),
                        work.file.empty() ? "in no file" : work.file.c_str());
    ImGui::BeginDisabled(each.is_discarded);
    const bool opened = ImGui::Button("Open");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button(each.is_discarded ? "Put back" : "Discard"))
      each.is_discarded = !each.is_discarded;
    if (each.is_discarded) {
      ImGui::SameLine();
      ImGui::TextDisabled("discarded");
    }
    ImGui::EndGroup();
    return opened;
  }
};

}  // namespace

Dialog left_work_dialog(App& app) {
  return {"Unsaved work", [list = LeftWorkList{app, {}}]() mutable { list.draw(); }};
}

Dialog quit_dialog(App& app, std::function<void()> quit) {
  return {kQuitTitle, [&app, quit = std::move(quit)] {
            ImGui::TextUnformatted(
                "What was changed here is in no file, and unsaved work cannot be kept:");
            for (const Session::Unsaved& each : app.session().all_unsaved()) {
              ImGui::BulletText("%s%s", each.lesson.title.c_str(),
                                each.file.empty()
                                    ? ""
                                    : fmt::format(" ({})", each.file.filename().string()).c_str());
            }
            if (ImGui::Button("Save as")) {
              app.close_dialog();
              return app.save_as();
            }
            ImGui::SameLine();
            if (ImGui::Button("Quit and lose it")) return quit();
            ImGui::SameLine();
            if (ImGui::Button("Stay")) app.close_dialog();
          }};
}

}  // namespace gjkscope
