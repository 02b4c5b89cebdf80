// Words and buttons on the stage beside the picture: where to begin, and the way home.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app.hpp"
#include "imgui_vec.hpp"
#include "session/hit.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

constexpr ImGuiWindowFlags kCard =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar;

void begin_card(const char* name, const Point& at, const ImVec2& pivot) {
  ImGui::SetNextWindowPos(vec(at), ImGuiCond_Always, pivot);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
  ImGui::Begin(name, nullptr, kCard);
  ImGui::PopStyleVar(2);
}

}  // namespace

void App::draw_on_stage() {
  for (const Rect& card : picture_.empty_cards()) {
    begin_card(fmt::format("##home{}", card.min.x() + card.min.y()).c_str(), card.center(),
               ImVec2(0.5f, 0.5f));
    ImGui::TextUnformatted("No shape is in sight here.");
    if (ImGui::Button("Show all (F)")) run_command("Fit");
    ImGui::End();
  }
  if (!welcomes_) return;
  const Rect card = picture_.last_card();
  const Point inset = Point::Constant(10.0 * ui_scale_);
  begin_card("##welcome", card.max - inset, ImVec2(1.0f, 1.0f));
  heading(*this, "Where to begin");
  const auto door = [&](const std::string& words) {
    const double width = std::min(24.0 * ImGui::GetFontSize(), card.size().x() - 4.0 * inset.x());
    return ImGui::Button(words.c_str(), ImVec2(static_cast<float>(std::max(width, 80.0)), 0.0f));
  };
  const auto first = std::find_if(lessons_.begin(), lessons_.end(), [](const ListedLesson& lesson) {
    return lesson.problem.empty() && lesson.chapter > 0;
  });
  if (first != lessons_.end() && door("Begin with the first lesson")) {
    open_path(first->file);
    welcomes_ = false;
  }
  if (door("Play: drag these shapes")) welcomes_ = false;
  if (door("Open a case or a lesson")) show_dialog(open_dialog(*this));
  ImGui::End();
  // A user who has begun needs no door.
  if (session_.index() > 0 || !session_.undo_name().empty() || has_dialog()) welcomes_ = false;
}

}  // namespace gjkscope
