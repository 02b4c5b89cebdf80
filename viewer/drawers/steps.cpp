#include <imgui.h>

#include <algorithm>

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

/// `shown`: the frame that was in sight when it was drawn last.
void draw_steps(App& app, int& shown) {
  Session& session = app.session();
  for (const RunUntil& each : kRunUntil) app.draw_button(each.name, -1.0f);
  const std::vector<FrameText>& texts = session.texts();
  const std::vector<std::string> columns = columns_of(texts);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                     ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX |
                                     ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("##steps", static_cast<int>(columns.size()) + 1, kFlags)) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  ImGui::TableSetupColumn("step");
  for (const std::string& name : columns) ImGui::TableSetupColumn(name.c_str());
  ImGui::TableHeadersRow();
  // What is asked before it is told is not in the table before it was told.
  const int count = session.is_predicting() ? session.index() + 1 : session.frame_count();
  for (int i = 0; i < count; ++i) {
    const FrameText& text = texts[static_cast<std::size_t>(i)];
    const bool is_now = i == session.index();
    ImGui::TableNextColumn();
    ImGui::PushID(i);
    if (ImGui::Selectable(text.position.c_str(), is_now, ImGuiSelectableFlags_SpanAllColumns))
      session.go_to(i);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.caption.c_str());
    if (is_now && shown != i) ImGui::SetScrollHereY();
    ImGui::PopID();
    for (const std::string& name : columns) {
      ImGui::TableNextColumn();
      for (const auto& [known, value] : text.values) {
        if (known == name) ImGui::TextUnformatted(value.c_str());
      }
    }
  }
  shown = session.index();
  ImGui::EndTable();
}

}  // namespace

Drawer steps_drawer(App& app) {
  Drawer drawer{"Steps", "J", "All steps in a table, and how to run to the one you look for",
                [&app, shown = -1]() mutable { draw_steps(app, shown); }};
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
