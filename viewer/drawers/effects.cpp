#include <imgui.h>

#include <optional>
#include <vector>

#include "app.hpp"
#include "effects/registry.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

void draw_effects(App& app) {
  wrapped_text("What a view calls for is computed when a mark needs it, and not otherwise.");
  EffectGraph& effects = app.session().effects();
  const std::vector<LessonView>& views = app.session().lesson().views;
  std::optional<Lesson> wanted;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!shows_shapes(views[i].kind)) continue;
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    heading(app, views[i].kind == ViewKind::world ? "In the world" : "In the difference");
    for (const EffectInfo& info : registered_effects()) {
      if (info.used_by != "view") continue;
      const std::string name(info.name);
      bool on = views[i].calls_for(name);
      if (ImGui::Checkbox(name.c_str(), &on)) {
        wanted = app.session().lesson();
        std::vector<std::string>& called = wanted->views[i].effects;
        if (std::erase(called, name) == 0) called.push_back(name);
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
  if (wanted) app.edit("effects", *std::move(wanted));
}

}  // namespace

Drawer effects_drawer(App& app) {
  return {"Effects", "E", "What the views show beyond the run", [&app] { draw_effects(app); }};
}

}  // namespace gjkscope
