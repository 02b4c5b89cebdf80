#include "dialog.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "app.hpp"
#include "drawers/effects.hpp"
#include "drawers/shapes.hpp"
#include "drawers/values.hpp"
#include "lesson/names.hpp"
#include "lesson/paste.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

constexpr float kFieldWidth = 34.0f;  // ems
constexpr int kListLines = 14;

/// A line of text that has the keyboard when the dialog opens, and `again`; true on Enter.
bool field(std::string& text, const char* hint = "", bool again = false) {
  ImGui::SetNextItemWidth(kFieldWidth * ImGui::GetFontSize());
  if (again || ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  return ImGui::InputTextWithHint(
      "##field", hint, &text,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
}

bool begin_list() {
  return ImGui::BeginChild("##list", ImVec2(kFieldWidth * ImGui::GetFontSize(),
                                            kListLines * ImGui::GetTextLineHeightWithSpacing()));
}

void draw_cancel(App& app) {
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) app.close_dialog();
}

struct Open {
  App& app;
  std::string path;

  void open(const fs::path& file) const {
    app.close_dialog();
    app.open_path(file);
  }

  void draw() {
    const bool entered = field(path, "path of a lesson, a case or a folder");
    const fs::path typed(path);
    std::error_code none;
    if (entered && fs::is_regular_file(typed, none)) return open(typed);
    if (entered && !fs::is_directory(typed, none))
      app.say(fmt::format("there is no file '{}'", path), true);
    fs::path chosen;
    if (begin_list()) chosen = list(typed);
    ImGui::EndChild();
    std::error_code ignored;
    if (fs::is_directory(chosen, ignored)) {
      path = chosen.string();
    } else if (!chosen.empty()) {
      return open(chosen);
    }
    if (ImGui::Button("Cancel")) app.close_dialog();
  }

  /// The choice among the files used last and of those in the folder.
  [[nodiscard]] fs::path list(const fs::path& typed) const {
    std::error_code none;
    fs::path chosen;
    heading(app, "Recent");
    for (const std::string& recent : app.recent()) {
      if (ImGui::Selectable(recent.c_str())) chosen = recent;
    }
    ImGui::Separator();
    const fs::path folder = fs::is_directory(typed, none)
                                ? typed
                                : (typed.has_parent_path() ? typed.parent_path() : fs::path("."));
    ImGui::TextDisabled("%s", folder.c_str());
    std::vector<fs::path> entries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
      const fs::path& each = entry.path();
      app.will_show(each.string());
      const std::string ending = each.extension().string();
      const bool wanted =
          ending == ".toml" || ending == ".json" || ending == ".jsonl" || is_pasted_ending(ending);
      if (entry.is_directory(none) || wanted) entries.push_back(each);
    }
    std::sort(entries.begin(), entries.end());
    if (ImGui::Selectable("..")) chosen = fs::absolute(folder).parent_path();
    for (const fs::path& each : entries) {
      const bool is_folder = fs::is_directory(each, none);
      if (ImGui::Selectable((each.filename().string() + (is_folder ? "/" : "")).c_str()))
        chosen = each;
    }
    return chosen;
  }
};

struct Save {
  App& app;
  std::string path;
  fs::path own;
  std::function<void(const fs::path&)> save;
  std::string asked_about = {};  ///< A file that is there, and that the next press overwrites.
  bool asks = false;             ///< Since the last frame.

  void draw() {
    const bool entered = field(path, "path of a file", std::exchange(asks, false));
    std::error_code none;
    const bool overwrites = path != own && fs::exists(path, none);
    if (overwrites && asked_about == path)
      wrapped_text("There is such a file. What it holds is kept beside it, with a ~ at its end.");
    const bool pressed = ImGui::Button(overwrites && asked_about == path ? "Overwrite" : "Save");
    const bool wanted = (pressed || entered) && !path.empty();
    draw_cancel(app);
    if (!wanted) return;
    if (overwrites && asked_about != path) {
      asked_about = path;
      asks = true;
      return;
    }
    app.close_dialog();
    save(path);
  }
};

struct Export {
  App& app;
  ExportOptions options;
  std::string folder = "frames";

  void draw() {
    const bool entered = field(folder, "a folder");
    if (!folder.empty() && fs::path(folder).is_relative())
      ImGui::TextDisabled("%s", fs::absolute(folder).lexically_normal().c_str());
    field_label("format");
    if (ImGui::BeginCombo("##format", std::string(name_of(options.format)).c_str())) {
      for (const Format format : all_formats()) {
        if (ImGui::Selectable(std::string(name_of(format)).c_str(), format == options.format))
          options.format = format;
      }
      ImGui::EndCombo();
    }
    field_label("theme");
    if (ImGui::BeginCombo("##theme", options.theme.c_str())) {
      for (const std::string& theme : Theme::names(app.share() / "assets" / "themes")) {
        if (ImGui::Selectable(theme.c_str(), theme == options.theme)) options.theme = theme;
      }
      ImGui::EndCombo();
    }
    std::array<int, 2> size = {options.width, options.height};
    field_label("size in pixels");
    if (ImGui::InputInt2("##size", size.data())) {
      options.width = std::clamp(size[0], 1, kMostPixels);
      options.height = std::clamp(size[1], 1, kMostPixels);
    }
    for (const auto& [name, width, height] : kSizes) {
      if (ImGui::Button(name)) {
        options.width = width;
        options.height = height;
      }
      ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::BeginDisabled(is_film(options.format));
    ImGui::Checkbox("transparent", &options.transparent);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::Checkbox("the stages alone", &options.stage_only);
    ImGui::TextDisabled("`gjkscope export` makes handouts, films that move, and ranges of steps.");
    ImGui::Separator();
    ImGui::BeginDisabled(is_film(options.format));  // one frame does not move
    const bool frame = ImGui::Button("This frame");
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool all = ImGui::Button("All frames");
    draw_cancel(app);
    if (folder.empty() || (!entered && !frame && !all)) return;
    options.out_dir = fs::absolute(folder).lexically_normal();
    app.last_export = options;
    options.transparent = options.transparent && !is_film(options.format);
    app.close_dialog();
    app.export_frames(options, all || is_film(options.format));
  }

 private:
  struct Size {
    const char* name;
    int width;
    int height;
  };
  static constexpr Size kSizes[] = {{"1280x720", 1280, 720},
                                    {"1920x1080", 1920, 1080},
                                    {"3840x2160", 3840, 2160},
                                    {"1080x1080", 1080, 1080}};
};

void draw_keys(App& app) {
  constexpr float kTwoColumns = 60.0f;  // ems
  const float em = ImGui::GetFontSize();
  const bool is_wide = ImGui::GetIO().DisplaySize.x > (kTwoColumns + 6.0f) * em;
  ImGui::BeginChild("##keys", ImVec2((is_wide ? kTwoColumns : kFieldWidth) * em,
                                     2.0f * kListLines * ImGui::GetTextLineHeightWithSpacing()));
  if (is_wide) ImGui::Columns(2, nullptr, false);
  std::vector<std::pair<std::string, std::vector<const Command*>>> groups;
  for (const Command& command : app.commands()) {
    if (command.keys.empty() || command.name.starts_with("Answer ")) continue;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const auto& each) { return each.first == command.group; });
    if (group == groups.end()) group = groups.insert(group, {command.group, {}});
    group->second.push_back(&command);
  }
  for (const auto& [name, commands] : groups) {
    const float used = ImGui::GetCursorPosY() / ImGui::GetWindowHeight();
    if (is_wide && ImGui::GetColumnIndex() == 0 && used > 0.6f) ImGui::NextColumn();
    ImGui::Spacing();
    heading(app, name);
    for (const Command* command : commands) {
      ImGui::Text("%s", fmt::format("{}", fmt::join(command->keys, ", ")).c_str());
      ImGui::SameLine(12.0f * em);
      ImGui::TextUnformatted(command->name.c_str());
    }
  }
  ImGui::Spacing();
  heading(app, "Mouse");
  wrapped_text(
      "Drag a vertex, a shape, the handle of a selected shape, the timeline, or the empty stage; "
      "with Shift to round numbers. Wheel: zoom. Double click an edge: add a vertex; elsewhere: "
      "show all. Click a line of the "
      "pseudocode: go to its next run.");
  ImGui::Columns();
  ImGui::EndChild();
  if (ImGui::Button("Close")) app.close_dialog();
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Whether the characters of `wanted` come in `text`, in this order: "nxlsn" is in "Next lesson".
bool is_spelled(const std::string& wanted, const std::string& text) {
  std::size_t at = 0;
  for (const char c : wanted) {
    if (c == ' ') continue;
    at = text.find(c, at);
    if (at == std::string::npos) return false;
    ++at;
  }
  return true;
}

struct Palette {
  App& app;
  std::string wanted;
  struct Entry {
    std::string name;
    std::string key;
    std::function<void()> run;
  };

  [[nodiscard]] std::vector<Entry> entries() const {
    std::vector<Entry> all;
    App& to = app;
    for (const Command& command : app.commands()) {
      if (command.is_enabled())
        all.push_back(
            {command.name, command.keys.empty() ? "" : command.keys.front(), command.run});
    }
    // "polygon 7": the number that is typed is that of the corners.
    int corners = 0;
    const char* const digits =
        wanted.c_str() + std::min(wanted.find_first_of("123456789"), wanted.size());
    std::from_chars(digits, wanted.c_str() + wanted.size(), corners);
    if (corners >= kFewestCorners && corners <= kMostCorners) {
      for (const std::size_t body : {0, 1}) {
        all.push_back(
            {fmt::format("{} becomes a regular polygon of {} corners", kBodyKeys[body], corners),
             "", [&to, body, corners] { make_regular(to, body, corners); }});
      }
    }
    for (const ListedLesson& lesson : app.lessons()) {
      if (lesson.problem.empty())
        all.push_back({fmt::format("Lesson: {} ({})", lesson.title, lesson.id), "",
                       [&to, file = lesson.file] { to.open_path(file); }});
    }
    // In the last view with shapes: the difference, where it has a view.
    const Lesson& lesson = app.session().lesson();
    const auto takes_effects = [](const LessonView& view) { return shows_shapes(view.kind); };
    const auto last = std::find_if(lesson.views.rbegin(), lesson.views.rend(), takes_effects);
    const auto view = static_cast<std::size_t>(lesson.views.rend() - last) - 1;
    for (const EffectInfo* info :
         last == lesson.views.rend() ? std::vector<const EffectInfo*>() : offered_effects(lesson)) {
      all.push_back({fmt::format("Effect: {} ({})", title_of(*info), info->name), "",
                     [&to, view, info] { toggle_effect(to, view, info->name); }});
    }
    for (const auto& [name, scalar] : Named<ScalarKind>::kTable) {
      all.push_back({fmt::format("Scalar: {}", name), "", [&to, scalar = scalar] {
                       Lesson other = to.session().lesson();
                       other.scalar = scalar;
                       to.edit("numerics", std::move(other));
                     }});
    }
    for (const NamedValue& value : values_now(app))
      all.push_back({fmt::format("Value {} = {}", value.name, value.text), "",
                     [&to, name = value.name] { toggle_pin(to, name); }});
    return all;
  }

  void draw() {
    const bool entered = field(wanted, "a command, a lesson, an effect, a value");
    const std::string typed = lower(wanted);
    std::vector<Entry> found;
    for (Entry& entry : entries()) {
      if (is_spelled(typed, lower(entry.name))) found.push_back(std::move(entry));
    }
    // Files that hold the words as they were typed come first.
    std::stable_partition(found.begin(), found.end(), [&](const Entry& entry) {
      return lower(entry.name).find(typed) != std::string::npos;
    });
    const Entry* chosen = entered && !found.empty() ? &found.front() : nullptr;
    begin_list();
    if (found.empty()) ImGui::TextDisabled("Nothing is called '%s'.", wanted.c_str());
    for (const Entry& entry : found) {
      if (ImGui::Selectable(entry.name.c_str(), &entry == &found.front())) chosen = &entry;
      if (entry.key.empty()) continue;
      ImGui::SameLine(0.75f * kFieldWidth * ImGui::GetFontSize());
      ImGui::TextDisabled("%s", entry.key.c_str());
    }
    ImGui::EndChild();
    if (!chosen) {
      if (ImGui::Button("Cancel")) app.close_dialog();
      return;
    }
    app.close_dialog();
    chosen->run();
  }
};

/// A dialog whose state is a value with a function draw().
template <class State>
Dialog dialog_of(std::string title, State state) {
  return {std::move(title), [state = std::move(state)]() mutable { state.draw(); }};
}

}  // namespace

Dialog open_dialog(App& app) {
  return dialog_of("Open a lesson, a case or a folder",
                   Open{app, app.session().file().parent_path().string()});
}

Dialog save_dialog(App& app, const std::string& title, const std::string& suggestion,
                   const fs::path& own, std::function<void(const fs::path&)> save) {
  return dialog_of(title, Save{app, suggestion, own, std::move(save)});
}

Dialog export_dialog(App& app) {
  Export dialog{app, app.last_export.value_or(ExportOptions())};
  if (app.last_export) {
    dialog.folder = app.last_export->out_dir.string();
  } else {
    dialog.options.theme = app.theme_name();
  }
  return dialog_of("Export frames into a folder", std::move(dialog));
}

Dialog keys_dialog(App& app) {
  return {"Keys", [&app] { draw_keys(app); }};
}

Dialog palette_dialog(App& app) { return dialog_of("Any command", Palette{app, ""}); }

}  // namespace gjkscope
