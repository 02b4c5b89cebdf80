#include "widgets.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "app.hpp"
#include "base/hexadecimal.hpp"

namespace gjkscope {

std::string number_text(double value, bool hexadecimal) {
  return hexadecimal ? gjkscope::hexadecimal(value) : fmt::format("{}", value);
}

std::optional<double> read_number(const std::string& text) {
  if (text.empty()) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

void heading(const App& app, const std::string& text) {
  ImGui::PushFont(app.panel_fonts().strong);
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::PopFont();
}

void field_label(const char* text) {
  constexpr float kColumn = 8.0f;  // ems
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kColumn * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
}

void wrapped_text(const std::string& text) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::PopTextWrapPos();
}

ImVec4 error_ink() { return {0.84f, 0.25f, 0.0f, 1.0f}; }

void tip(const std::string& words, const ImVec2& side, bool now) {
  if (!now) return;
  constexpr float kGap = 0.5f;     // ems
  constexpr float kWidth = 32.0f;  // ems
  const float em = ImGui::GetFontSize();
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const ImVec2 at(0.5f * (min.x + max.x + side.x * (max.x - min.x)) + side.x * kGap * em,
                  0.5f * (min.y + max.y + side.y * (max.y - min.y)) + side.y * kGap * em);
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, {0.5f - 0.5f * side.x, 0.5f - 0.5f * side.y});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kWidth * em);
  ImGui::TextUnformatted(words.c_str(), words.c_str() + words.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void table_row(const std::string& name, const std::vector<std::string>& cells) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name.c_str());
  for (const std::string& cell : cells) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(cell.c_str());
  }
}

}  // namespace gjkscope
