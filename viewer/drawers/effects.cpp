#include "drawers/effects.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <functional>

#include "app.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

void draw_effects(App& app) {
  wrapped_text("What a view calls for is computed when a mark needs it, and not otherwise.");
  EffectGraph& effects = app.session().effects();
  const std::vector<LessonView>& views = app.session().lesson().views;
  std::function<void()> change;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!shows_shapes(views[i].kind)) continue;
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    heading(app, views[i].kind == ViewKind::world ? "In the world" : "In the difference");
    for (const EffectInfo* info : offered_effects(app.session().lesson())) {
      bool on = views[i].calls_for(info->name);
      if (ImGui::Checkbox(title_of(*info).c_str(), &on))
        change = [&app, i, info] { toggle_effect(app, i, info->name); };
      tip(std::string(info->summary), tips::kLeft, ImGui::IsItemHovered());
      const EffectCount count = effects.count(info->name);
      ImGui::SameLine(static_cast<float>(210.0 * app.ui_scale()));
      if (count.runs > 0) {
        ImGui::Text("%ld x  %.3f ms", count.runs, 1e3 * count.seconds);
      } else {
        ImGui::TextDisabled("not run");
      }
    }
    ImGui::PopID();
  }
  if (change) change();
}

}  // namespace

std::vector<const EffectInfo*> offered_effects(const Lesson& lesson) {
  std::vector<const EffectInfo*> out;
  for (const EffectInfo& info : registered_effects()) {
    const bool fits = info.act.empty() || info.act == lesson.act;
    if (info.used_by == "view" && fits && (!info.second_run || lesson.beside)) out.push_back(&info);
  }
  return out;
}

std::string title_of(const EffectInfo& effect) {
  std::string title(effect.name);
  std::replace(title.begin(), title.end(), '-', ' ');
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

void toggle_effect(App& app, std::size_t view, std::string_view effect) {
  Lesson lesson = app.session().lesson();
  std::vector<std::string>& called = lesson.views[view].effects;
  if (std::erase(called, effect) == 0) called.emplace_back(effect);
  app.edit("effects", std::move(lesson));
}

Drawer effects_drawer(App& app) {
  return {"Effects", "E", "What the views show beyond the run", [&app] { draw_effects(app); }};
}

}  // namespace gjkscope
