// Lines above the picture, to be known or answered, that stay while their cause does.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app.hpp"
#include "lesson/load.hpp"
#include "lesson/problem.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

constexpr std::size_t kMostLines = 3;

std::size_t next_character(const std::string& text, std::size_t at) {
  do {
    ++at;
  } while (at < text.size() && !starts_character(text[at]));
  return at;
}

}  // namespace

std::vector<Notice> App::notices() const {
  std::vector<Notice> all = all_notices();
  std::erase_if(all, [&](const Notice& each) {
    return each.can_be_closed && closed_.contains(each.cause + each.text);
  });
  return all;
}

std::vector<Notice> App::all_notices() const {
  std::vector<Notice> all;
  const std::string file = session_.file().filename().string();
  const bool is_gone = gone_since_ && now_ >= *gone_since_ + kGoneAfter;
  if (outside_ && outside_->file == session_.file() && !(is_gone && !outside_->lesson)) {
    Notice asked{.cause = "outside", .text = {}, .answers = {"Keep mine"}, .can_be_closed = false};
    if (outside_->lesson) {
      asked.text = fmt::format("{} has changed outside, and here. Which one shall stay?", file);
      asked.details =
          "Either way undo brings back the other one. Until you choose, nothing is saved.";
      asked.answers.push_back("Take the file's");
    } else {
      asked.text = fmt::format("{} (as it was before is shown)", in_one_line(outside_->problems));
      asked.details = to_string(outside_->problems);
      asked.can_be_closed = true;
    }
    all.push_back(std::move(asked));
  }
  if (is_gone) {
    all.push_back({.cause = "gone",
                   .text = fmt::format("{} is gone; Save writes it anew.", file),
                   .details = session_.file().string(),
                   .answers = {"Save"}});
  }
  if (opening_) {
    all.push_back({.cause = "opening",
                   .text = fmt::format("{} is being opened…", opening_->file.filename().string()),
                   .is_error = false,
                   .answers = {"Cancel opening"},
                   .can_be_closed = false});
  }
  if (session_.is_settling()) {
    all.push_back({.cause = "settling",
                   .text = "The run of these large shapes is being made…",
                   .is_error = false,
                   .answers = {"Cancel the change"},
                   .can_be_closed = false});
  }
  if (is_exporting() && now_ >= export_began_ + kLongExport) {
    const auto [done, count] = exported();
    all.push_back(
        {.cause = "exporting",
         .text = count == 0 ? fmt::format("Frames are exported into {}…", export_folder_.string())
                            : fmt::format("{} of {} frames are exported into {}…", done, count,
                                          export_folder_.string()),
         .is_error = false,
         .answers = {"Cancel the export"},
         .can_be_closed = false});
  }
  if (!error_.empty()) all.push_back({.cause = "deed", .text = error_, .details = error_details_});
  const std::string& not_kept = not_kept_.empty() ? unsaved_.problem() : not_kept_;
  if (!not_kept.empty()) {
    all.push_back({.cause = "not kept",
                   .text = fmt::format(
                       "Unsaved work cannot be kept here: save before you quit ({}).", not_kept),
                   .details = not_kept});
  }
  if (!missing_.second.empty()) {
    all.push_back(
        {.cause = "characters",
         .text = fmt::format("The stage's fonts have no {}: it is shown as �.", missing_.second),
         .is_error = false});
  }
  const auto is_offered = [](const LeftWork& each) { return !each.is_discarded; };
  const auto left = std::find_if(left_.begin(), left_.end(), is_offered);
  if (left != left_.end()) {
    const auto count = std::count_if(left_.begin(), left_.end(), is_offered);
    const std::string of = left->work.file.empty() ? "a case" : left->work.file.stem().string();
    all.push_back({.cause = "left",
                   .text = count == 1 ? fmt::format("There is unsaved work, of {}.", of)
                                      : fmt::format("There are {} pieces of unsaved work, the last "
                                                    "of {}.",
                                                    count, of),
                   .is_error = false,
                   .answers = {"Open unsaved work", "Discard unsaved work"}});
  }
  return all;
}

void App::find_missing_character() {
  if (missing_.first == session_.version() || session_.is_dragging()) return;
  missing_ = {session_.version(), ""};
  will_show(session_.file().string());
  const std::vector<LessonText> texts = texts_of(session_.lesson());
  for (const LessonText& each : texts) will_show(each.text);
  for (const LessonText& each : texts) {
    const char32_t character = Fonts::first_missing(each.text);
    if (character == 0) continue;
    std::size_t begin = 0;
    for (const char32_t c : code_points(each.text)) {
      if (c == character) break;
      begin = next_character(each.text, begin);
    }
    missing_.second =
        fmt::format("'{}' (in {})",
                    each.text.substr(begin, next_character(each.text, begin) - begin), each.key);
    return;
  }
}

void App::forget_closed() {
  // A notice that comes back is shown again.
  const std::vector<Notice> all = all_notices();
  std::erase_if(closed_, [&](const std::string& closed) {
    return std::none_of(all.begin(), all.end(),
                        [&](const Notice& each) { return each.cause + each.text == closed; });
  });
}

std::size_t App::notice_count() const { return std::min(notices().size(), kMostLines); }

void App::close_notice(const std::string& cause) {
  for (const Notice& each : notices()) {
    if (each.cause != cause || !each.can_be_closed) continue;
    if (cause == "deed") {
      error_.clear();
    } else {
      closed_.insert(each.cause + each.text);
    }
    return;
  }
}

void App::draw_notices() {
  std::vector<Notice> all = notices();
  // The stage, which stands still, says what goes on with a shape that was let go.
  const bool on_stage = session_.is_settling();
  const std::size_t lines = notice_lines_ + (on_stage ? 1 : 0);
  all.resize(std::min({all.size(), kMostLines, lines}));
  if (all.empty()) return;
  const Rect& area = picture_.area();
  const auto row = static_cast<float>(kNoticeRow * ui_scale_);
  const auto top = static_cast<float>(area.min.y()) - row * static_cast<float>(notice_lines_);
  const double left = on_stage ? area.min.x() : 0.0;
  const double width = on_stage ? area.size().x() : width_;
  ImGui::SetNextWindowPos({static_cast<float>(left), top});
  ImGui::SetNextWindowSize({static_cast<float>(width), row * static_cast<float>(lines)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(10.0f * static_cast<float>(ui_scale_), 0.0f));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_TableHeaderBg));
  ImGui::Begin("##notices", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float middle = 0.5f * (row - ImGui::GetFrameHeight());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Notice& notice = all[i];
    ImGui::PushID(notice.cause.c_str());
    ImGui::SetCursorPos({style.WindowPadding.x, static_cast<float>(i) * row + middle});
    float buttons = notice.can_be_closed ? ImGui::GetFrameHeight() + style.ItemSpacing.x : 0.0f;
    for (const std::string_view answer : notice.answers) {
      const std::string name(answer);
      buttons +=
          ImGui::CalcTextSize(name.c_str()).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - buttons;
    ImGui::PushClipRect(at, {std::max(end, at.x), at.y + row}, true);
    ImGui::AlignTextToFramePadding();
    if (notice.is_error) ImGui::PushStyleColor(ImGuiCol_Text, error_ink());
    ImGui::TextUnformatted(notice.text.c_str(), notice.text.c_str() + notice.text.size());
    if (notice.is_error) ImGui::PopStyleColor();
    ImGui::PopClipRect();
    const bool is_cut = at.x + ImGui::CalcTextSize(notice.text.c_str()).x > end;
    if (ImGui::IsItemHovered() && (is_cut || !notice.details.empty())) {
      ImGui::BeginTooltip();
      ImGui::PushTextWrapPos(40.0f * ImGui::GetFontSize());
      if (is_cut) ImGui::TextUnformatted(notice.text.c_str());
      if (notice.details != notice.text) ImGui::TextUnformatted(notice.details.c_str());
      ImGui::PopTextWrapPos();
      ImGui::EndTooltip();
    }
    ImGui::SetCursorScreenPos({std::max(end + style.ItemSpacing.x, at.x), at.y});
    for (const std::string_view answer : notice.answers) {
      draw_button(answer);
      ImGui::SameLine();
    }
    if (notice.can_be_closed) {
      const float size = ImGui::GetFrameHeight();
      const ImVec2 corner = ImGui::GetCursorScreenPos();
      if (ImGui::Button("##close", ImVec2(size, size))) close_notice(notice.cause);
      draw_icon(*ImGui::GetWindowDrawList(), Icon::close,
                {corner.x + 0.5f * size, corner.y + 0.5f * size}, 0.72f * size,
                ImGui::GetColorU32(ImGuiCol_Text), ImGui::GetColorU32(ImGuiCol_Button));
    }
    ImGui::PopID();
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace gjkscope
