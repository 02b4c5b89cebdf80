#pragma once
// Pieces that more than one panel or dialog is made of.

#include <imgui.h>

#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "lesson/names.hpp"

namespace gjkscope {

inline constexpr ImGuiTableFlags kRuled =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;

[[nodiscard]] std::string number_text(double value, bool hexadecimal);
/// A whole text as a number, decimal or hex float ("0x1.8p-1").
[[nodiscard]] std::optional<double> read_number(const std::string& text);

/// Whether what is done in another thread has ended.
template <class T>
[[nodiscard]] bool is_ready(const std::future<T>& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

class App;

/// In a stronger type than what stands below it.
void heading(const App& app, const std::string& text);
/// Stands left of the field that is drawn next, and makes that field fill the row.
void field_label(const char* text);
void wrapped_text(const std::string& text);
/// The colour of what went wrong.
[[nodiscard]] ImVec4 error_ink();
/// Height of a line of notices, in pixels at scale 1.
inline constexpr double kNoticeRow = 30.0;
/// On which side of a thing the words about it stand, so that the thing stays in sight.
namespace tips {
inline const ImVec2 kBelow(0.0f, 1.0f);
inline const ImVec2 kAbove(0.0f, -1.0f);
inline const ImVec2 kRight(1.0f, 0.0f);
inline const ImVec2 kLeft(-1.0f, 0.0f);
}  // namespace tips
/// Words about what was drawn last, while `now`.
void tip(const std::string& words, const ImVec2& side, bool now);
/// A row of a table with a name and texts.
void table_row(const std::string& name, const std::vector<std::string>& cells);

/// A list to choose from; true when another value was chosen.
template <class E>
bool choose_value(const char* label, E& value) {
  bool changed = false;
  if (ImGui::BeginCombo(label, std::string(name_of(value)).c_str())) {
    for (const auto& [name, candidate] : Named<E>::kTable) {
      if (ImGui::Selectable(std::string(name).c_str(), candidate == value) && candidate != value) {
        value = candidate;
        changed = true;
      }
    }
    ImGui::EndCombo();
  }
  return changed;
}

}  // namespace gjkscope
