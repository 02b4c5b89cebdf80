#include <imgui.h>

#include <algorithm>

#include "app.hpp"
#include "effects/registry.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

void draw_effects(App& app) {
  wrapped_text("What a view calls for is computed when a mark needs it, and not otherwise.");
  EffectGraph& effects = app.session().effects();
  Lesson wanted = app.session().lesson();
  bool changed = false;
  for (std::size_t i = 0; i < wanted.views.size(); ++i) {
    if (!shows_shapes(wanted.views[i].kind)) continue;
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    ImGui::Text("In %s", wanted.views[i].kind == ViewKind::world ? "the world" : "the difference");
    std::vector<std::string>& called = wanted.views[i].effects;
    for (const EffectInfo& info : registered_effects()) {
      if (info.used_by != "view") continue;
      const std::string name(info.name);
      bool on = std::find(called.begin(), called.end(), name) != called.end();
      if (ImGui::Checkbox(name.c_str(), &on)) {
        if (on) {
          called.push_back(name);
        } else {
          std::erase(called, name);
        }
        changed = true;
      }
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(info.summary).c_str());
      const EffectCount count = effects.count(info.name);
      ImGui::SameLine(static_cast<float>(210.0 * app.ui_scale()));
      if (count.runs > 0) {
        ImGui::Text("%ld x  %.3f ms", count.runs, 1e3 * count.seconds);
      } else {
        ImGui::TextDisabled("not run");
      }
    }
    ImGui::PopID();
  }
  if (changed) app.edit("effects", std::move(wanted));
}

}  // namespace

Drawer effects_drawer(App& app) {
  return {"Effects", "E", "What the views show beyond the run", [&app] { draw_effects(app); }};
}

}  // namespace gjkscope
