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
#include "picture/frame.hpp"
#include "picture/stage.hpp"
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

/// A run of its own, whose views call for an effect, or do not.
class Trial {
 public:
  Trial(const LessonRun& run, const Fonts& fonts) : run_(run), effects_(run_), fonts_(fonts) {}

  void call_for(std::size_t view, std::string_view effect, bool on) {
    std::vector<std::string>& called = run_.lesson.views[view].effects;
    std::erase(called, effect);
    if (on) called.emplace_back(effect);
  }
  [[nodiscard]] std::vector<FrameText> texts() { return lesson_texts(run_, effects_); }
  [[nodiscard]] Scene scene(std::size_t view, std::size_t frame) {
    const LessonView& shown = run_.lesson.views[view];
    if (!map_) map_.emplace(kCard, camera_of(run_, shown, kCard));
    return stage_scene(run_, effects_, run_.frames[frame], shown, *map_, fonts_);
  }

 private:
  static inline const Rect kCard{{0.0, 0.0}, {600.0, 400.0}};

  LessonRun run_;
  EffectGraph effects_;
  const Fonts& fonts_;
  std::optional<StageMap> map_;  ///< The same for both.
};

/// For each view and effect of a lesson, the frames that it changes.
using Changes = std::map<std::pair<std::size_t, std::string_view>, std::vector<bool>>;

/// Found out beside the window, anew for each version of the lesson that comes to rest.
class ChangesOfEffects {
 public:
  /// Null while that is not known.
  const Changes* of(App& app) {
    Session& session = app.session();
    if (finding_.valid() && is_ready(finding_)) known_ = finding_.get();
    if (version_ != session.version()) {
      stop_.request_stop();
      known_.clear();
      if (!finding_.valid() && !session.is_dragging())
        find(session.run(), app.fonts(), session.version());
    }
    return version_ == session.version() && !finding_.valid() ? &known_ : nullptr;
  }
  [[nodiscard]] bool waits() const { return finding_.valid(); }

 private:
  void find(const LessonRun& run, const Fonts& fonts, long version) {
    version_ = version;
    stop_ = {};
    auto own = std::make_shared<const LessonRun>(run);
    finding_ = std::async(std::launch::async, [own, &fonts, stop = stop_.get_token()] {
      Changes out;
      for (std::size_t view = 0; view < own->lesson.views.size(); ++view) {
        if (!shows_shapes(own->lesson.views[view].kind)) continue;
        for (const EffectInfo* info : offered_effects(own->lesson)) {
          if (auto frames = frames_changed_by(*own, fonts, view, info->name, stop))
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

std::optional<std::vector<bool>> frames_changed_by(const LessonRun& run, const Fonts& fonts,
                                                   std::size_t view, std::string_view effect,
                                                   const std::stop_token& stop) {
  constexpr std::size_t kMostDifferences = 2500;  // there are effects that show them all
  constexpr std::size_t kMostFrames = 400;
  const Lesson& lesson = run.lesson;
  if (lesson.x().vertices.size() * lesson.y().vertices.size() > kMostDifferences ||
      run.frames.size() > kMostFrames)
    return std::nullopt;
  Trial trial(run, fonts);
  trial.call_for(view, effect, false);
  const std::vector<FrameText> texts = trial.texts();
  std::vector<Scene> scenes;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    if (stop.stop_requested()) return std::nullopt;
    scenes.push_back(trial.scene(view, i));
  }
  trial.call_for(view, effect, true);
  const std::vector<FrameText> texts_with = trial.texts();
  std::vector<bool> out;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    if (stop.stop_requested()) return std::nullopt;
    out.push_back(texts[i].caption != texts_with[i].caption ||
                  texts[i].detail != texts_with[i].detail ||
                  !look_alike(scenes[i], trial.scene(view, i)));
  }
  return out;
}

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
  Session& session = app.session();
  Lesson lesson = session.lesson();
  std::vector<std::string>& called = lesson.views[view].effects;
  if (std::erase(called, effect) == 0) {
    const auto frames = frames_changed_by(session.run(), app.fonts(), view, effect);
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
  Drawer drawer{"Effects", "E", "What the views show beyond the run",
                [&app, changes] { draw_effects(app, *changes); }};
  drawer.waits = [changes] { return changes->waits(); };
  return drawer;
}

}  // namespace gjkscope
