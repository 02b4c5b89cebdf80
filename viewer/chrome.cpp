// The parts around the picture: bars, the list of lessons, the drawer, dialogs and messages.

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>  // which popups are open, and what the keyboard points at

#include <algorithm>
#include <array>

#include "app.hpp"
#include "drawers/values.hpp"
#include "files.hpp"
#include "imgui_vec.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

// Pixels at scale 1.
constexpr double kThumbnail = 64.0;  // its width
constexpr double kSpeed = 98.0;
constexpr float kDimmed = 0.75f;  // ink of lesser words: 4.5 to 1 on all that panels are made of
constexpr double kGrip = 5.0;     // of a drawer's edge

constexpr const char* kHint = "drag a vertex    → next step    / find    ? keys";

/// A panel that fills `rect`. End it with ImGui::End.
void begin_panel(const char* name, const Rect& rect, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(vec(rect.min));
  ImGui::SetNextWindowSize(vec(rect.size()));
  ImGui::Begin(name, nullptr, kFixed | more);
}

ImVec4 color_of(const Color& c) {
  return {static_cast<float>(c.r) / 255.0f, static_cast<float>(c.g) / 255.0f,
          static_cast<float>(c.b) / 255.0f, 1.0f};
}
ImVec4 between(const ImVec4& a, const ImVec4& b, float share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z), 1.0f};
}

float button_width(const char* text) {
  return ImGui::CalcTextSize(text).x + 2.0f * ImGui::GetStyle().FramePadding.x;
}

}  // namespace

double App::layout(double width, double height, double density) {
  // On a screen much larger than the usual one the picture grows, and what stands around it, too.
  constexpr double kUsualWidth = 1920.0;
  constexpr double kUsualHeight = 1080.0;
  constexpr double kSteps = 4.0;  // to a doubling, so that fonts are not built anew all the time
  const double larger =
      std::floor(kSteps * std::min(width / kUsualWidth, height / kUsualHeight)) / kSteps;
  ui_scale_ = panel_size_ * std::max(density, larger);
  width_ = width;
  height_ = height;
  density_ = density;
  // Under a hand nothing moves, nor before what it has let go is shown.
  if (!session_.is_dragging() && !session_.is_settling())
    notice_lines_ = is_presenting() ? 0 : notice_count();
  room_ =
      room_of({.width = width,
               .height = height,
               .scale = ui_scale_,
               .density = density,
               .presenting = is_presenting(),
               .notices = kNoticeRow * ui_scale_ * static_cast<double>(notice_lines_),
               .lessons = lessons_shown_,
               .drawer = drawer_ ? std::optional(drawer_width()) : std::nullopt,
               .drawer_is_chosen = drawer_ && drawer_widths_.contains(drawers_[*drawer_].name)});
  return picture_.lay_out(room_.stage, density);
}

void App::draw(const AtlasFonts& fonts, const PanelFonts& panel_fonts) {
  panel_fonts_ = panel_fonts;
  atlas_fonts_ = &fonts;
  pointed_in_panel = {};
  ImGuiIO& io = ImGui::GetIO();
  const bool by_keyboard = focused_ || dialog_ || has_popup();
  io.ConfigFlags = by_keyboard ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
  presenter_.see({io.MousePos.x, io.MousePos.y}, now_);
  picture_.draw(fonts);
  asking_.draw_on_stage(fonts);
  if (!is_presenting()) {
    draw_on_stage();
    draw_top_bar();
    draw_notices();
    if (!room_.folded) draw_transport();
    draw_drawer();
    if (has_lessons()) draw_lessons();
  }
  if (std::exchange(focus_moves_, false)) {
    ImGui::SetWindowFocus(focused_ ? focused_->c_str() : nullptr);
    if (focused_) show_focus(*focused_);
  }
  draw_dialog();
  draw_message();
  if (io.MouseClicked[0]) focused_.reset();
  picture_.take_pointer();
  for (const Drawer& drawer : drawers_) {
    if (drawer.pointed) drawer.pointed(picture_.hovered());
  }
  if (presenter_.is_black())
    ImGui::GetForegroundDrawList()->AddRectFilled({0.0f, 0.0f}, io.DisplaySize, IM_COL32_BLACK);
}

void App::set_colors() const {
  if (is_dark()) {
    ImGui::StyleColorsDark();
  } else {
    ImGui::StyleColorsLight();
  }
  const ImVec4 paper = color_of(theme_.background());
  const ImVec4 ink = color_of(*theme_.style("title").fill);
  const ImVec4 card = color_of(theme_.style("card").fill.value_or(theme_.background()));
  const ImVec4 strong = color_of(*theme_.style("timeline.current").fill);
  // The ground of a listing's current line. A theme for print draws a frame there instead.
  const Color line = theme_.style("highlight").fill.value_or(Color{0, 0, 0, 0});
  const ImVec4 current = line.a == 255 ? color_of(line) : between(card, strong, 0.15f);
  ImVec4* colors = ImGui::GetStyle().Colors;
  colors[ImGuiCol_Text] = ink;
  colors[ImGuiCol_TextDisabled] = between(paper, ink, kDimmed);
  colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] = between(paper, ink, 0.05f);
  colors[ImGuiCol_Border] = between(paper, ink, 0.18f);
  colors[ImGuiCol_FrameBg] = card;
  colors[ImGuiCol_FrameBgHovered] = between(card, ink, 0.08f);
  colors[ImGuiCol_FrameBgActive] = between(card, ink, 0.14f);
  colors[ImGuiCol_Button] = card;
  colors[ImGuiCol_ButtonHovered] = between(card, ink, 0.1f);
  colors[ImGuiCol_ButtonActive] = between(card, strong, 0.35f);
  colors[ImGuiCol_Header] = current;
  colors[ImGuiCol_HeaderHovered] = between(card, ink, 0.1f);
  colors[ImGuiCol_HeaderActive] = between(card, strong, 0.35f);
  colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = colors[ImGuiCol_SliderGrabActive] =
      strong;
  colors[ImGuiCol_NavHighlight] = strong;
  colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TableHeaderBg] =
      between(paper, ink, 0.12f);
  colors[ImGuiCol_TableRowBg] = colors[ImGuiCol_WindowBg];
  colors[ImGuiCol_TableRowBgAlt] = between(paper, ink, 0.09f);
  colors[ImGuiCol_Separator] = colors[ImGuiCol_TableBorderStrong] =
      colors[ImGuiCol_TableBorderLight] = between(paper, ink, 0.15f);
}

// Buttons ----------------------------------------------------------------------------------------

void App::draw_button(std::string_view name, float width) {
  const Command& shown = *command(name);
  ImGui::BeginDisabled(!shown.is_enabled());
  const bool pressed = ImGui::Button(shown.name.c_str(), ImVec2(width, 0.0f));
  ImGui::EndDisabled();
  if (pressed) shown.run();
}

void App::draw_icon_button(Icon icon, std::string_view name, bool at_top) {
  const Command& shown = *command(name);
  const bool can = shown.is_enabled();
  const float size = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(!can);
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0f);
  const bool pressed = ImGui::Button(fmt::format("##{}", name).c_str(), ImVec2(1.25f * size, size));
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  draw_icon(*ImGui::GetWindowDrawList(), icon, {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)},
            0.72f * size, ImGui::GetColorU32(ImGuiCol_Text), ImGui::GetColorU32(ImGuiCol_WindowBg));
  ImGui::EndDisabled();
  const std::string key = shown.keys.empty() ? "" : fmt::format(" ({})", shown.keys.front());
  tip(shown.name + key, at_top ? tips::kBelow : tips::kAbove,
      ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled));
  if (pressed) shown.run();
}

void App::draw_menu_item(std::string_view name) {
  const Command& shown = *command(name);
  const char* key = shown.keys.empty() ? nullptr : shown.keys.front().c_str();
  if (ImGui::MenuItem(shown.name.c_str(), key, false, shown.is_enabled())) shown.run();
}

// Panels -----------------------------------------------------------------------------------------

bool App::draw_tab(const char* name) {
  // Menus and drawers: words without a frame.
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0f);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_WindowBg));
  const bool pressed = ImGui::Button(name);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return pressed;
}

/// Opened by a click, or by the pointer while another one is open.
void App::draw_menu(const char* name, const std::vector<std::string_view>& items) {
  const bool pressed = draw_tab(name);
  const ImVec2 min = ImGui::GetItemRectMin();
  const ImVec2 max = ImGui::GetItemRectMax();
  const bool is_open = ImGui::IsPopupOpen(name);
  const bool another_is_open = menu_open_ && *menu_open_ != name && has_popup();
  if (pressed || (another_is_open && ImGui::IsMouseHoveringRect(min, max, false))) {
    ImGui::OpenPopup(name);
    menu_open_ = name;
  } else if (menu_open_ == name && !is_open) {
    menu_open_.reset();
  }
  ImGui::SetNextWindowPos(ImVec2(min.x, max.y));
  if (!ImGui::BeginPopup(name)) return;
  for (const std::string_view item : items) {
    if (item.empty()) {
      ImGui::Separator();
    } else {
      draw_menu_item(item);
    }
  }
  ImGui::EndPopup();
}

void App::draw_top_bar() {
  begin_panel("##top", {{0.0, 0.0}, {width_, room_.bar}},
              ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const ImGuiStyle& style = ImGui::GetStyle();
  draw_menu("File", {"Open", "Save", "Save as", "Revert to what is saved", "", "Export frames", "",
                     "Copy as case", "Copy the frame as SVG text", "Copy the frame in words",
                     "Copy the code of the listing", "Paste a case", "", "Quit"});
  ImGui::SameLine();
  draw_menu("View", {"Lessons", "Presenter mode", "Fit", "Grid and axes", "Snap to round numbers",
                     "Next language of the listing", "", "Next theme", "Larger panels",
                     "Smaller panels", "", "Any command", "Where to begin", "Keys"});
  ImGui::SameLine();
  if (room_.folded) {
    std::vector<std::string_view> names;
    for (const Drawer& drawer : drawers_) names.push_back(drawer.name);
    names.insert(names.end(), {"", "Undo", "Redo"});
    draw_menu("Panels", names);
    ImGui::SameLine();
    draw_steps();
    return ImGui::End();
  }
  for (const auto& [drawn, name] :
       {std::pair(Icon::undo, "Undo"), {Icon::redo, "Redo"}, {Icon::fit, "Fit"}}) {
    draw_icon_button(drawn, name, true);
    ImGui::SameLine();
  }
  // Drawers at the right end, over the one that is open.
  float tabs = 0.0f;
  for (const Drawer& drawer : drawers_)
    tabs += button_width(drawer.name.c_str()) + style.ItemSpacing.x;
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(),
                                ImGui::GetWindowContentRegionMax().x - tabs + style.ItemSpacing.x));
  for (std::size_t i = 0; i < drawers_.size(); ++i) {
    const Drawer& drawer = drawers_[i];
    if (i > 0) ImGui::SameLine();
    const bool is_open = drawer_ == i;
    if (draw_tab(drawer.name.c_str())) toggle_drawer(i);
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    tip(fmt::format("{} ({})", drawer.help, drawer.key), tips::kBelow,
        ImGui::IsItemHovered() && !is_open);
    if (!is_open) continue;
    const auto line = static_cast<float>(3.0 * ui_scale_);
    ImGui::GetWindowDrawList()->AddRectFilled({min.x, max.y - line}, max,
                                              ImGui::GetColorU32(ImGuiCol_CheckMark));
  }
  ImGui::End();
}

void App::draw_transport() {
  const Rect& area = picture_.area();
  begin_panel("##transport", {{area.min.x(), area.max.y()}, {area.max.x(), height_}},
              ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_steps();
  if (room_.has_status) draw_status();
  ImGui::End();
}

/// The buttons that step, and around them what else has room: the place in the run, the speed, the
/// next lesson at the end of this one.
void App::draw_steps() {
  constexpr std::array<std::pair<Icon, const char*>, 7> kButtons = {
      {{Icon::first, "First frame"},
       {Icon::back_far, "Iteration before"},
       {Icon::back, "Step before"},
       {Icon::play, "Play or pause"},
       {Icon::forth, "Next step"},
       {Icon::forth_far, "Next iteration"},
       {Icon::last, "Last frame"}}};
  const ImGuiStyle& style = ImGui::GetStyle();
  const float gap = style.ItemSpacing.x;
  const float buttons = kButtons.size() * (1.25f * ImGui::GetFrameHeight() + gap);
  const float begin = ImGui::GetCursorPosX();
  const float end = ImGui::GetWindowContentRegionMax().x;
  // The number of steps would give answers away.
  const std::string place =
      session_.last_open() + 1 == session_.frame_count()
          ? fmt::format("{} of {}", session_.index() + 1, session_.frame_count())
          : "";
  const float place_width = ImGui::CalcTextSize(place.c_str()).x + gap;
  const auto speed_width = static_cast<float>(kSpeed * ui_scale_);
  const bool at_end =
      session_.index() + 1 == session_.frame_count() && command("Next lesson")->is_enabled();
  // From what matters most: the buttons, the way on, the place, the speed.
  float room = end - begin - buttons;
  const auto takes = [&](float width) {
    if (width > room) return false;
    room -= width;
    return true;
  };
  const bool has_next = at_end && takes(button_width("Next lesson") + gap);
  const bool has_place = !place.empty() && takes(place_width);
  const bool has_speed = takes(speed_width + gap);
  const float left = has_place ? place_width : 0.0f;
  const float right = (has_next ? button_width("Next lesson") + gap : 0.0f) +
                      (has_speed ? speed_width + gap : 0.0f);
  if (has_place) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", place.c_str());
    ImGui::SameLine();
  }
  const float middle = 0.5f * (begin + end - buttons);
  ImGui::SetCursorPosX(
      std::clamp(middle, begin + left, std::max(end - right - buttons, begin + left)));
  for (const auto& [icon, name] : kButtons) {
    draw_icon_button(icon == Icon::play && playing_ ? Icon::pause : icon, name, room_.folded);
    ImGui::SameLine();
  }
  if (has_speed) {
    ImGui::SetNextItemWidth(speed_width);
    auto speed = static_cast<float>(frames_per_second_);
    if (ImGui::DragFloat("##speed", &speed, 0.02f, 0.25f, 16.0f,
                         speed == 1.0f ? "%.2g step/s" : "%.2g steps/s",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
      frames_per_second_ = speed;
    tip("Frames a second: drag, or press [ and ]", room_.folded ? tips::kBelow : tips::kAbove,
        ImGui::IsItemHovered());
    ImGui::SameLine();
  }
  if (has_next) {
    draw_button("Next lesson");
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

void App::draw_lessons() {
  // Beside the stage, or over it where it has no room.
  const double width =
      room_.lessons > 0.0 ? room_.lessons : std::min(kLessonsWidth * ui_scale_, 0.9 * width_);
  begin_panel("##lessons", {{0.0, room_.stage.min.y()}, {width, height_}});
  const auto draw_progress = [](const Progress& count) {
    if (count.done == 0) return;
    const std::string text = fmt::format("{}/{}", count.done, count.of);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextDisabled("%s", text.c_str());
    tip(fmt::format("{} of {} lessons were stepped to their end", count.done, count.of),
        tips::kRight, ImGui::IsItemHovered());
  };
  heading(*this, "Lessons");
  draw_progress(progress());
  int chapter = -1;
  for (const ListedLesson& lesson : lessons_) {
    if (lesson.chapter != chapter) {
      chapter = lesson.chapter;
      const auto title = chapters_.find(chapter);
      ImGui::Dummy(ImVec2(0.0f, 0.4f * ImGui::GetFontSize()));
      heading(*this,
              title == chapters_.end() ? "Other" : fmt::format("{}  {}", chapter, title->second));
      draw_progress(progress(chapter));
    }
    ImGui::PushID(lesson.file.c_str());
    const std::string path = lesson.file.string();
    const bool is_open = session_.lesson().path == path;
    draw_lesson(lesson, is_open);
    ImGui::PopID();
    if (is_open && std::exchange(listed_, path) != path && !ImGui::IsItemVisible())
      ImGui::SetScrollHereY();
  }
  ImGui::End();
}

/// Its picture, its title on as many lines as that takes, and a check mark when it was stepped to
/// its end.
void App::draw_lesson(const ListedLesson& lesson, bool is_open) {
  const bool is_good = lesson.problem.empty();
  const double scale = kThumbnail * ui_scale_ / thumbnails::kWidth;
  const ImVec2 picture =
      has_thumbnails ? vec(scale * Point(thumbnails::kWidth, thumbnails::kHeight))
                     : ImVec2(ImGui::GetFontSize(), ImGui::GetFontSize());  // room for the sign
  const float left = picture.x + ImGui::GetStyle().ItemSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x - left;
  const ImVec2 size = ImGui::CalcTextSize(lesson.title.c_str(), nullptr, false, width);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed =
      ImGui::Selectable("##title", is_open, 0, ImVec2(0.0f, std::max(size.y, picture.y)));
  const bool is_seen = ImGui::IsItemVisible();
  tip(lesson.problem, tips::kRight, ImGui::IsItemHovered() && !is_good);
  if (pressed && is_good) {
    open_path(lesson.file);
    lessons_over_ = false;
  }
  if (!is_seen) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + picture.x, at.y + picture.y);
  if (has_thumbnails) draw_small_picture(is_good ? lesson.file : "", at, picture);
  const ImU32 ink = ImGui::GetColorU32(is_good ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  if (!is_good || memory_.finished.contains(lesson.id)) {
    const char* const sign = is_good ? "✓" : "!";
    list.AddText({end.x - ImGui::CalcTextSize(sign).x - 2.0f, end.y - ImGui::GetFontSize()},
                 is_good ? ImGui::GetColorU32(ImGuiCol_CheckMark) : ink, sign);
  }
  list.AddText(nullptr, 0.0f, {at.x + left, at.y}, ink, lesson.title.c_str(), nullptr, width);
}

void App::draw_small_picture(const std::filesystem::path& file, const ImVec2& at,
                             const ImVec2& size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  list.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
  if (const Picture* marks = file.empty() || !has_thumbnails ? nullptr : thumbnails_.of(file)) {
    list.PushClipRect(at, end, true);
    (void)paint_marks(
        list, *marks, 0, theme_, *atlas_fonts_,
        {Point(at.x, at.y), size.x / thumbnails::kWidth, ImGui::GetIO().Fonts->TexID});
    list.PopClipRect();
  }
  list.AddRect(at, end, ImGui::GetColorU32(ImGuiCol_Border), 3.0f);
}

void App::draw_drawer() {
  if (!drawer_) return;
  const double left = width_ - room_.drawer;
  const double grip = kGrip * ui_scale_;
  // Padding would leave nothing of it to take hold of.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  begin_panel("##edge", {{left, room_.stage.min.y()}, {left + grip, height_}},
              ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar(2);
  drag_edge();
  ImGui::End();
  begin_panel("##drawer", {{left + grip, room_.stage.min.y()}, {width_, height_}});
  const Drawer& open = drawers_[*drawer_];
  ImGui::AlignTextToFramePadding();
  heading(*this, open.name);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 1.25f * ImGui::GetFrameHeight());
  draw_icon_button(Icon::close, open.name);
  ImGui::Separator();
  open.draw();
  ImGui::End();
}

void App::draw_dialog() {
  // As large as what it holds; in a window that is too small for it the wheel moves it.
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoScrollbar;
  if (dialog_drawn_ && dialog_drawn_ != dialog_) {
    if (ImGui::BeginPopupModal(dialog_drawn_->title.c_str(), nullptr, kFlags)) {
      ImGui::CloseCurrentPopup();
      ImGui::EndPopup();
    }
    dialog_drawn_.reset();
  }
  if (!dialog_) return;
  const std::shared_ptr<Dialog> shown = dialog_;
  if (!dialog_drawn_) ImGui::OpenPopup(shown->title.c_str());
  dialog_drawn_ = shown;
  ImGui::SetNextWindowPos(vec({0.5 * width_, 0.5 * height_}), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), vec({0.95 * width_, 0.95 * height_}));
  bool open = true;
  const auto padding = static_cast<float>(16.0 * ui_scale_);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding, padding));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(padding, 0.5f * padding));  // of the title
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
  const bool is_drawn = ImGui::BeginPopupModal(shown->title.c_str(), &open, kFlags);
  ImGui::PopStyleVar(3);
  if (is_drawn) {
    shown->draw();
    ImGui::EndPopup();
  }
  if (!open) close_dialog();
}

bool App::has_lessons() const { return room_.lessons > 0.0 || lessons_over_; }

double App::drawer_width() const {
  const Drawer& drawer = drawers_[*drawer_];
  const auto chosen = drawer_widths_.find(drawer.name);
  if (chosen != drawer_widths_.end()) return chosen->second;
  // A drawer wider than there is room for makes do with the usual width.
  const double wanted = drawer.width ? drawer.width() : kDrawerWidth;
  const double room = (width_ - kStageWidth * density_) / ui_scale_;
  return wanted > room ? kDrawerWidth : std::max(wanted, kDrawerWidth);
}

/// The left edge of the drawer follows the hand, and is where it was left at the next start.
void App::drag_edge() {
  ImGui::SetCursorPos({0.0f, 0.0f});
  ImGui::InvisibleButton("##grip", ImGui::GetWindowSize());
  const bool is_held = ImGui::IsItemActive();
  if (is_held || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                              ImGui::GetColorU32(ImGuiCol_CheckMark));
  }
  if (!is_held) return;
  const double wanted = (width_ - ImGui::GetIO().MousePos.x) / ui_scale_;
  drawer_widths_[drawers_[*drawer_].name] =
      std::clamp(wanted, kNarrowestDrawer, std::max(kNarrowestDrawer, width_ / ui_scale_));
}

bool App::has_popup() const {
  const int own = dialog_drawn_ ? 1 : 0;
  return ImGui::GetCurrentContext()->OpenPopupStack.Size > own;
}

void App::show_focus(const std::string& panel) {
  ImGuiWindow* window = ImGui::FindWindowByName(panel.c_str());
  if (!window) return;
  ImGui::NavInitWindow(window, true);
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.NavDisableHighlight = false;
  context.NavDisableMouseHover = true;
}

const std::string& App::said() const {
  // While a hand holds a shape where no run can be shown, that is what there is to say.
  return session_.is_dragging() && !session_.problem().empty() ? session_.problem() : message_;
}

bool App::fits_status(const std::string& text) const {
  if (!room_.has_status) return false;
  const double room = picture_.area().size().x() - 2.0 * ImGui::GetStyle().WindowPadding.x;
  return text.find('\n') == std::string::npos && ImGui::CalcTextSize(text.c_str()).x <= room;
}

std::string App::pinned_text() {
  if (pinned.empty()) return "";
  const std::vector<NamedValue> values = values_now(*this);
  std::string text;
  for (const std::string& name : pinned) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const NamedValue& value) { return value.name == name; });
    text += fmt::format("{}{} = {}", text.empty() ? "" : "    ", name,
                        found == values.end() ? "–" : found->text);
  }
  return text;
}

/// Values that stay in sight, at the right end of a line whose text ends at `begin`.
void App::draw_pinned(float begin) {
  const std::string text = pinned_text();
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float at = end - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SameLine(0.0f, 0.0f);
  ImGui::SetCursorScreenPos(
      {std::max(at, begin + ImGui::GetFontSize()), ImGui::GetCursorScreenPos().y});
  ImGui::TextUnformatted(text.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
}

/// The last message, or the lesson's file.
void App::draw_status() {
  const std::string& text = said();
  if (!text.empty() && fits_status(text)) {
    if (&text != &message_) {
      ImGui::TextColored(error_ink(), "%s", text.c_str());
    } else {
      ImGui::TextUnformatted(text.c_str());
    }
    if (ImGui::IsItemClicked()) message_.clear();
  } else {
    const std::string compared = compared_with_case();
    ImGui::TextDisabled("%s%s%s%s",
                        session_.file().empty() ? "in no file" : session_.file().filename().c_str(),
                        session_.is_unsaved() ? ", not saved" : "", compared.empty() ? "" : "    ",
                        compared.c_str());
    const float begin = ImGui::GetItemRectMax().x + ImGui::GetFontSize();
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float at = end - ImGui::CalcTextSize(kHint).x;
    if (pinned.empty() && at > begin) {
      ImGui::SameLine(0.0f, 0.0f);
      ImGui::SetCursorScreenPos({at, ImGui::GetCursorScreenPos().y});
      ImGui::TextDisabled("%s", kHint);
    }
  }
  if (!pinned.empty()) draw_pinned(ImGui::GetItemRectMax().x);
}

/// Draws the last message if it is too long for the line below.
void App::draw_message() {
  const std::string& text = said();
  if (text.empty() || is_presenting() || fits_status(text)) return;
  const Rect& area = picture_.area();
  const double right = area.max.x() - 8.0 * ui_scale_;
  const double below = area.max.y();
  ImGui::SetNextWindowPos(vec({right, below - 6.0 * ui_scale_}), ImGuiCond_Always,
                          ImVec2(1.0f, 1.0f));
  ImGui::Begin("##message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  ImGui::PushTextWrapPos(
      static_cast<float>(std::clamp(area.size().x() - 40.0, 80.0, 640.0 * ui_scale_)));
  const bool is_error = &text != &message_;
  if (is_error) ImGui::PushStyleColor(ImGuiCol_Text, error_ink());
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  if (is_error) ImGui::PopStyleColor();
  if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) message_.clear();
  ImGui::PopTextWrapPos();
  ImGui::End();
}

}  // namespace gjkscope
