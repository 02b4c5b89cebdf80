#include <imgui.h>

#include <algorithm>
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
  std::vector<std::string> columns;  ///< Of that version of the lesson.
};

void draw_row(Session& session, const Table& table, int i) {
  const FrameText& text = session.texts()[static_cast<std::size_t>(i)];
  ImGui::TableNextColumn();
  ImGui::PushID(i);
  if (ImGui::Selectable(text.position.c_str(), i == session.index(),
                        ImGuiSelectableFlags_SpanAllColumns))
    session.go_to(i);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.caption.c_str());
  ImGui::PopID();
  for (const std::string& name : table.columns) {
    ImGui::TableNextColumn();
    for (const auto& [known, value] : text.values) {
      if (known == name) ImGui::TextUnformatted(value.c_str());
    }
  }
}

void draw_steps(App& app, Table& table) {
  Session& session = app.session();
  for (const RunUntil& each : kRunUntil) app.draw_button(each.name, -1.0f);
  if (table.version != session.version()) {
    table.columns = columns_of(session.texts());
    table.version = session.version();
  }
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                     ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX |
                                     ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("##steps", static_cast<int>(table.columns.size()) + 1, kFlags)) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  ImGui::TableSetupColumn("step");
  for (const std::string& name : table.columns) ImGui::TableSetupColumn(name.c_str());
  ImGui::TableHeadersRow();
  // What is asked before it is told is not in the table before it was told.
  const int count = session.is_predicting() ? session.index() + 1 : session.frame_count();
  const float row = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
  if (std::exchange(table.shown, session.index()) != session.index()) {
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
  Drawer drawer{"Steps", "J", "All steps in a table, and how to run to the one you look for",
                [&app, table = Table{}]() mutable { draw_steps(app, table); }};
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
