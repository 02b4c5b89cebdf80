#include "drawers/effects.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <future>
#include <map>
#include <memory>

#include "app.hpp"
#include "frames/frame.hpp"
#include "frames/stage.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

/// Whether two scenes look the same. Labels stand where they have room: their anchors tell.
bool look_alike(const Scene& a, const Scene& b) {
  const auto is_same = [](const LabelRequest& one, const LabelRequest& other) {
    return one.text == other.text && one.role == other.role && one.anchor == other.anchor;
  };
  const auto is_same_area = [](const AreaLabelRequest& one, const AreaLabelRequest& other) {
    return one.text == other.text && one.polygon == other.polygon;
  };
  return a.marks == b.marks && std::ranges::equal(a.fixed_labels, b.fixed_labels, is_same) &&
         std::ranges::equal(a.moving_labels, b.moving_labels, is_same) &&
         std::ranges::equal(a.area_labels, b.area_labels, is_same_area);
}

/// For each view and effect of a lesson, the frames that it changes.
using Changes = std::map<std::pair<std::size_t, std::string_view>, std::vector<bool>>;

/// Found out beside the window, anew for each version of the lesson that comes to rest.
class ChangesOfEffects {
 public:
  ChangesOfEffects() = default;
  ChangesOfEffects(const ChangesOfEffects&) = delete;
  ChangesOfEffects& operator=(const ChangesOfEffects&) = delete;
  /// Null while that is not known.
  const Changes* of(App& app) {
    Session& session = app.session();
    if (finding_.valid() && is_ready(finding_)) known_ = finding_.get();
    if (!is_of(session)) {
      stop_.request_stop();
      known_.clear();
      if (!finding_.valid() && !session.is_dragging()) find(session, app.fonts());
    }
    return is_of(session) && !finding_.valid() ? &known_ : nullptr;
  }
  [[nodiscard]] bool waits() const { return finding_.valid(); }
  ~ChangesOfEffects() { stop_.request_stop(); }

 private:
  /// Questions are frames, too, and no change of the lesson.
  [[nodiscard]] bool is_of(const Session& session) const {
    return version_ == session.version() && frames_ == session.frame_count();
  }
  void find(Session& session, const Fonts& fonts) {
    version_ = session.version();
    frames_ = session.frame_count();
    stop_ = {};
    auto trial = std::make_shared<EffectTrial>(session.run(), session.effects(), fonts);
    finding_ = std::async(std::launch::async, [trial, stop = stop_.get_token()] {
      Changes out;
      const Lesson lesson = trial->lesson();
      for (std::size_t view = 0; view < lesson.views.size(); ++view) {
        if (!shows_shapes(lesson.views[view].kind)) continue;
        for (const EffectInfo* info : offered_effects(lesson)) {
          if (auto frames = trial->frames_changed_by(view, info->name, stop))
            out[{view, info->name}] = *std::move(frames);
        }
      }
      return out;
    });
  }

  std::future<Changes> finding_;
  std::stop_source stop_;
  Changes known_;
  long version_ = -1;
  int frames_ = 0;
};

void draw_effects(App& app, ChangesOfEffects& changes) {
  wrapped_text("What a view calls for is computed when a mark needs it, and not otherwise.");
  const Changes* known = changes.of(app);
  Session& session = app.session();
  const std::vector<LessonView>& views = session.lesson().views;
  std::function<void()> change;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!shows_shapes(views[i].kind)) continue;
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    heading(app, views[i].kind == ViewKind::world ? "In the world" : "In the difference");
    for (const EffectInfo* info : offered_effects(session.lesson())) {
      bool on = views[i].calls_for(info->name);
      const std::vector<bool>* frames = nullptr;
      if (known) {
        const auto found = known->find({i, info->name});
        if (found != known->end()) frames = &found->second;
      }
      const bool never = frames && std::ranges::find(*frames, true) == frames->end();
      const auto now = static_cast<std::size_t>(session.index());
      const bool not_now = frames && now < frames->size() && !(*frames)[now];
      ImGui::BeginDisabled(never && !on);
      if (ImGui::Checkbox(title_of(*info).c_str(), &on))
        change = [&app, i, info] { toggle_effect(app, i, info->name); };
      ImGui::EndDisabled();
      const std::string why = never     ? "\nIn this view it changes no step of this lesson."
                              : not_now ? "\nIn this view it changes other steps, not this one."
                                        : "";
      tip(std::string(info->summary) + why, tips::kLeft,
          ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled));
      const EffectCount count = session.effects().count(info->name);
      ImGui::SameLine(static_cast<float>(210.0 * app.ui_scale()));
      if (never || not_now) {
        ImGui::TextDisabled("%s", never ? "changes no step" : "not in this step");
      } else if (count.runs > 0) {
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

EffectTrial::EffectTrial(const LessonRun& run, const EffectGraph& known, const Fonts& fonts)
    : run_(run), effects_(run_), fonts_(fonts) {
  effects_.take_over<Growth>(known);
}

void EffectTrial::call_for(std::size_t view, std::string_view effect, bool on) {
  std::vector<std::string>& called = run_.lesson.views[view].effects;
  std::erase(called, effect);
  if (on) called.emplace_back(effect);
}

Scene EffectTrial::scene(std::size_t view, std::size_t frame, const StageMap& map) {
  StillLayers drawn;  // none is kept: what is called for changes from scene to scene
  return stage_scene(run_, effects_, run_.frames[frame], run_.lesson.views[view], map, fonts_,
                     drawn);
}

std::optional<std::vector<bool>> EffectTrial::frames_changed_by(std::size_t view,
                                                                std::string_view effect,
                                                                const std::stop_token& stop) {
  constexpr std::size_t kMostDifferences = 2500;  // there are effects that show them all
  constexpr std::size_t kMostFrames = 400;
  const Lesson& lesson = run_.lesson;
  if (lesson.x().vertices.size() * lesson.y().vertices.size() > kMostDifferences ||
      run_.frames.size() > kMostFrames)
    return std::nullopt;
  const std::vector<std::string> called = lesson.views[view].effects;
  call_for(view, effect, false);
  // Seen alike with the effect and without it.
  const Rect card{{0.0, 0.0}, {600.0, 400.0}};
  const StageMap map(card, camera_of(run_, lesson.views[view], card));
  const std::vector<FrameText> texts = lesson_texts(run_, effects_);
  std::vector<Scene> scenes;
  for (std::size_t i = 0; i < run_.frames.size() && !stop.stop_requested(); ++i)
    scenes.push_back(scene(view, i, map));
  call_for(view, effect, true);
  const std::vector<FrameText> texts_with = lesson_texts(run_, effects_);
  std::vector<bool> out;
  for (std::size_t i = 0; i < run_.frames.size() && !stop.stop_requested(); ++i) {
    out.push_back(texts[i].caption != texts_with[i].caption ||
                  texts[i].detail != texts_with[i].detail ||
                  !look_alike(scenes[i], scene(view, i, map)));
  }
  run_.lesson.views[view].effects = called;
  if (stop.stop_requested()) return std::nullopt;
  return out;
}

std::vector<const EffectInfo*> offered_effects(const Lesson& lesson) {
  std::vector<const EffectInfo*> out;
  for (const EffectInfo* info : registered_effects()) {
    const bool fits = (info->tour.empty() || info->tour == lesson.tour) &&
                      is_shown_of(info->shown_of, lesson.dimension);
    if (info->used_by == "view" && fits && has_settings(lesson, info->table)) out.push_back(info);
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
  Session& session = app.session();
  Lesson lesson = session.lesson();
  std::vector<std::string>& called = lesson.views[view].effects;
  if (std::erase(called, effect) == 0) {
    const auto frames =
        EffectTrial(session.run(), session.effects(), app.fonts()).frames_changed_by(view, effect);
    if (frames && std::ranges::find(*frames, true) == frames->end())
      return app.say(fmt::format("{} changes no step of this lesson here", effect));
    called.emplace_back(effect);
    // Taken back, the lesson is what its file holds: the order says nothing.
    if (const Lesson* saved = session.saved(); saved && view < saved->views.size()) {
      const std::vector<std::string>& then = saved->views[view].effects;
      if (std::ranges::is_permutation(called, then)) called = then;
    }
  }
  app.edit("effects", std::move(lesson));
}

Drawer effects_drawer(App& app) {
  const auto changes = std::make_shared<ChangesOfEffects>();
  Drawer drawer{"Effects", "E", "Marks of the views beyond the run",
                [&app, changes] { draw_effects(app, *changes); }};
  drawer.waits = [changes] { return changes->waits(); };
  return drawer;
}

}  // namespace gjkscope
