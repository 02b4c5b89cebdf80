#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "app.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

using Event = Session::Event;

struct RunUntil {
  Event event;
  const char* name;
};
constexpr RunUntil kRunUntil[] = {{Event::simplex_changes, "Run until the simplex changes"},
                                  {Event::vertex_dropped, "Run until a vertex is dropped"},
                                  {Event::run_ends, "Run until the run ends"}};

/// Names of what frames have to show, in the order in which they first come.
std::vector<std::string> columns_of(const std::vector<FrameText>& texts) {
  std::vector<std::string> names;
  for (const FrameText& text : texts) {
    for (const auto& [name, value] : text.values) {
      const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
      const bool is_constant = name == "x" || name == "y" || name.starts_with("iteration");
      if (!is_known && !is_constant) names.push_back(name);
    }
  }
  return names;
}

struct Table {
  int shown = -1;  ///< The frame that was in sight when it was drawn last.
  long version = -1;
  std::vector<std::string> columns;  ///< The columns of that version of the lesson.
  int pointed = -1;                  ///< The row whose caption is shown.
  double width = 400.0;              ///< All columns', in pixels at scale 1.
};

/// Names a step in few words.
std::string step_name(const FrameText& text) {
  if (text.iteration == 0) return text.phase == "start" ? text.phase : text.position;
  return fmt::format("{} · {}", text.iteration, text.phase);
}

/// As the table has it: the names that go with weights stand in the column of the simplex.
std::string cell(const std::string& column, const std::string& value) {
  if (column != "weights") return value;
  std::string out;
  std::istringstream words(value);
  for (std::string weight, name; words >> weight; words >> name)
    out += (out.empty() ? "" : "  ") + weight;
  return out;
}

/// The width that all columns need, with a bar to scroll by.
float width_of(const std::vector<FrameText>& texts, const std::vector<std::string>& columns) {
  const auto measured = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  float first = measured("step");
  std::vector<float> widths;
  for (const std::string& column : columns) widths.push_back(measured(column));
  for (const FrameText& text : texts) {
    first = std::max(first, measured(step_name(text)));
    for (const auto& [name, value] : text.values) {
      const auto column = std::find(columns.begin(), columns.end(), name);
      if (column == columns.end()) continue;
      float& width = widths[column - columns.begin()];
      width = std::max(width, measured(cell(name, value)));
    }
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  const float between = 2.0f * style.CellPadding.x + 1.0f;
  const float around = style.ScrollbarSize + 2.0f * style.WindowPadding.x + ImGui::GetFontSize();
  float all = first + between + around;
  for (const float width : widths) all += width + between;
  return all;
}

void draw_row(Session& session, Table& table, int i) {
  const FrameText& text = session.texts()[i];
  ImGui::TableNextColumn();
  ImGui::PushID(i);
  if (ImGui::Selectable(step_name(text).c_str(), i == session.index(),
                        ImGuiSelectableFlags_SpanAllColumns))
    session.go_to(i);
  // Not while the keys step and the pointer rests.
  const ImVec2& moved = ImGui::GetIO().MouseDelta;
  if (moved.x != 0.0f || moved.y != 0.0f) table.pointed = i;
  tip(text.caption, tips::kLeft, ImGui::IsItemHovered() && table.pointed == i);
  ImGui::PopID();
  for (const std::string& name : table.columns) {
    ImGui::TableNextColumn();
    for (const auto& [known, value] : text.values) {
      if (known == name) ImGui::TextUnformatted(cell(name, value).c_str());
    }
  }
}

constexpr ImGuiTableFlags kStepsTable = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX |
                                        ImGuiTableFlags_ScrollY;

/// Steps beside each other, and their values below: all of these are in sight in any width.
void draw_across(Session& session, Table& table) {
  constexpr int kMost = 60;  // steps; a table has at most 64 columns
  const int count = session.last_open() + 1;
  const int first = std::clamp(session.index() - kMost / 2, 0, std::max(count - kMost, 0));
  const int last = std::min(first + kMost, count);
  if (!ImGui::BeginTable("##steps-across", last - first + 1, kStepsTable)) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  // No row of headers: those are not asked how wide they are.
  ImGui::TableNextRow();
  ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_TableHeaderBg));
  ImGui::TableNextColumn();
  const bool has_moved = std::exchange(table.shown, session.index()) != session.index();
  for (int i = first; i < last; ++i) {
    const FrameText& text = session.texts()[i];
    ImGui::TableNextColumn();
    ImGui::PushID(i);
    if (ImGui::Selectable(step_name(text).c_str(), i == session.index())) session.go_to(i);
    tip(text.caption, tips::kBelow, ImGui::IsItemHovered());
    if (has_moved && i == session.index()) ImGui::SetScrollHereX();
    ImGui::PopID();
  }
  for (const std::string& name : table.columns) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name.c_str());
    for (int i = first; i < last; ++i) {
      ImGui::TableNextColumn();
      if (i == session.index())
        ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, ImGui::GetColorU32(ImGuiCol_Header));
      for (const auto& [known, value] : session.texts()[i].values) {
        if (known == name) ImGui::TextUnformatted(cell(name, value).c_str());
      }
    }
  }
  ImGui::EndTable();
}

void draw_steps(App& app, Table& table) {
  Session& session = app.session();
  for (const RunUntil& each : kRunUntil) app.draw_button(each.name, -1.0f);
  if (table.version != session.version()) {
    table.columns = columns_of(session.texts());
    table.version = session.version();
    table.width = width_of(session.texts(), table.columns) / app.ui_scale();
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  if (ImGui::GetContentRegionAvail().x + 2.0f * style.WindowPadding.x + ImGui::GetFontSize() <
      table.width * app.ui_scale())
    return draw_across(session, table);
  const ImVec2 padding = style.CellPadding;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.6f * padding.x, padding.y));
  const bool is_open =
      ImGui::BeginTable("##steps", static_cast<int>(table.columns.size()) + 1, kStepsTable);
  ImGui::PopStyleVar();
  if (!is_open) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  ImGui::TableSetupColumn("step");
  for (const std::string& name : table.columns) ImGui::TableSetupColumn(name.c_str());
  ImGui::TableHeadersRow();
  // A question hides the steps after it from the table until it is answered.
  const int count = session.last_open() + 1;
  const float row = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  if (std::exchange(table.shown, session.index()) != session.index()) {
    table.pointed = -1;
    const auto middle = static_cast<float>(session.index() + 1) * row;
    ImGui::SetScrollY(std::max(middle - 0.5f * ImGui::GetWindowHeight(), 0.0f));
  }
  ImGuiListClipper clipper;
  clipper.Begin(count, row);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw_row(session, table, i);
  }
  ImGui::EndTable();
}

}  // namespace

Drawer steps_drawer(App& app) {
  const auto table = std::make_shared<Table>();
  Drawer drawer{"Steps", "J", "All steps in a table, and how to run to the one you look for",
                [&app, table] { draw_steps(app, *table); }};
  drawer.width = [table] { return table->width; };
  for (const RunUntil& each : kRunUntil) {
    drawer.commands.push_back(
        {each.name,
         "Step",
         {},
         [&app, each] { (void)app.session().run_until(each.event); },
         [&app, each] { return app.session().next(each.event).has_value(); }});
  }
  return drawer;
}

}  // namespace gjkscope
