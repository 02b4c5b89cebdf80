#include "asking.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app.hpp"
#include "imgui_vec.hpp"
#include "picture/text_box.hpp"
#include "picture/words.hpp"
#include "session/pointing.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

using Kind = Subject::Kind;

constexpr double kPause = 1.2;  // seconds after a digit that may be the first of two

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool Asking::is_open() const { return app_.session().question() != nullptr; }

void Asking::follow() {
  const std::pair<long, int> now = {app_.session().version(), app_.session().index()};
  if (std::exchange(at_, now) != now) forget();
}

void Asking::forget() {
  halves_ = {};
  highlighted_ = 0;
  typed_ = 0;
}

bool Asking::has_begun() {
  follow();
  return is_open() && (halves_ != std::array<std::string, 2>{} || typed_ > 0);
}

std::vector<std::string> Asking::choices() {
  follow();
  const FrameQuestion* question = app_.session().question();
  if (!question) return {};
  if (question->pair.empty()) return question->choices;
  return question->pair[next_half()].vertices;
}

void Asking::answer(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed) {
  forget();
  app_.session().grade(choice, pointed);
  app_.picture().hand().selected = {};
}

void Asking::choose(const std::string& choice) {
  follow();
  const FrameQuestion* question = app_.session().question();
  if (!question) return;
  if (holds(question->choices, choice)) return answer(choice);
  if (!question->pair.empty()) choose_half(next_half(), choice);
}

void Asking::choose_half(std::size_t half, const std::string& name) {
  highlighted_ = typed_ = 0;
  halves_[half] = name;
  if (halves_[0].empty() || halves_[1].empty()) return;
  // Choices are all pairs, in the order of the two lists.
  const FrameQuestion& question = *app_.session().question();
  std::size_t choice = 0;
  for (std::size_t i = 0; i < halves_.size(); ++i) {
    const std::vector<std::string>& names = question.pair[i].vertices;
    const auto place = std::find(names.begin(), names.end(), halves_[i]) - names.begin();
    choice = choice * names.size() + static_cast<std::size_t>(place);
  }
  answer(question.choices[choice]);
}

void Asking::type(int digit) {
  const std::vector<std::string> offered = choices();
  const int count = static_cast<int>(offered.size());
  int number = 10 * typed_ + digit;
  if (number > count) number = digit;
  if (number == 0 || number > count) return;
  if (10 * number <= count) {
    typed_ = number;
    typed_at_ = app_.now();
    highlighted_ = number - 1;
    return;
  }
  typed_ = 0;
  choose(offered[static_cast<std::size_t>(number) - 1]);
}

void Asking::move(int by) {
  const auto count = static_cast<int>(choices().size());
  if (count > 0) highlighted_ = (highlighted_ + by + count) % count;
  typed_ = 0;
}

void Asking::enter() {
  const std::vector<std::string> offered = choices();
  if (highlighted_ < static_cast<int>(offered.size())) choose(offered[highlighted_]);
}

void Asking::tick(double now) {
  follow();
  if (typed_ > 0 && is_open() && now >= typed_at_ + kPause) enter();
}

std::optional<double> Asking::wakes_at() const {
  if (typed_ == 0 || !is_open()) return std::nullopt;
  return typed_at_ + kPause;
}

std::optional<Subject> Asking::subject_of(const std::string& choice) const {
  for (const Mark& mark : app_.session().picture().marks) {
    if (name_of(app_.session().run(), mark.subject) == choice) return mark.subject;
  }
  return std::nullopt;
}

bool Asking::click(const Subject& subject, const Point& page) {
  follow();
  const FrameQuestion* question = app_.session().question();
  const std::optional<PointedChoice> pointed =
      pointed_choice(app_.session(), app_.picture().hand(), subject, page);
  if (!pointed) return false;
  if (!pointed->half) {
    answer(pointed->choice, pointed->place);
    return true;
  }
  // The two halves come in any order.
  if (!holds(question->pair[*pointed->half].vertices, pointed->choice)) {
    app_.say(fmt::format("{} is none of the choices", pointed->choice));
    return true;
  }
  app_.picture().hand().selected = subject;
  choose_half(*pointed->half, pointed->choice);
  return true;
}

void Asking::draw() {
  follow();
  const FrameQuestion* asked = app_.session().question();
  if (!asked) return;
  const FrameQuestion question = *asked;
  std::function<void()> choose_it;
  const auto row = [&](const std::vector<std::string>& names, std::optional<std::size_t> half) {
    const bool is_now = !half || half == next_half();
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string label = is_now ? fmt::format("{}  {}", i + 1, names[i]) : names[i];
      const float width =
          ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
      if (i > 0 && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= end)
        ImGui::SameLine();
      const bool is_chosen =
          is_now ? static_cast<int>(i) == highlighted_ : names[i] == halves_[*half];
      if (is_chosen)
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
      if (ImGui::Button(fmt::format("{}##{}", label, i).c_str()))
        choose_it = [this, half, name = names[i]] {
          half ? choose_half(*half, name) : choose(name);
        };
      if (is_chosen) ImGui::PopStyleColor();
      if (!ImGui::IsItemHovered()) continue;
      if (const std::optional<Subject> subject = subject_of(names[i]))
        app_.pointed_in_panel = *subject;
    }
  };
  if (question.pair.empty()) {
    row(question.choices, {});
  } else {
    const auto width_of = [](const VertexChoice& of) {
      const ImGuiStyle& style = ImGui::GetStyle();
      float width = ImGui::CalcTextSize(of.shape.c_str()).x + style.ItemSpacing.x;
      for (const std::string& name : of.vertices)
        width += ImGui::CalcTextSize(("8  " + name).c_str()).x + 2.0f * style.FramePadding.x +
                 style.ItemSpacing.x;
      return width;
    };
    const float gap = 2.0f * ImGui::GetFontSize();
    const bool beside = width_of(question.pair[0]) + gap + width_of(question.pair[1]) <=
                        ImGui::GetContentRegionAvail().x;
    for (std::size_t half = 0; half < 2; ++half) {
      const VertexChoice& of = question.pair[half];
      ImGui::PushID(static_cast<int>(half));
      if (half == 1 && beside) ImGui::SameLine(0.0f, gap);
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(of.shape.c_str());
      ImGui::SameLine();
      row(of.vertices, half);
      ImGui::PopID();
    }
  }
  if (typed_ > 0) ImGui::TextUnformatted(fmt::format("{} … Enter", typed_).c_str());
  if (choose_it) choose_it();
}

void Asking::draw_on_stage(const AtlasFonts& fonts) {
  if (!is_open()) return;
  const std::optional<Rect> place = app_.picture().words_of_choices();
  if (!place) return;
  ImGui::SetNextWindowPos(vec(place->min), ImGuiCond_Always);
  ImGui::SetNextWindowSize(ImVec2(static_cast<float>(place->size().x()), 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  const Color paper = app_.theme().background();
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(paper.r, paper.g, paper.b, 255));
  ImGui::Begin("##question", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
  const auto& [font, scale] = fonts.font(type::kDetail);
  ImGui::PushFont(const_cast<ImFont*>(font));
  ImGui::SetWindowFontScale(static_cast<float>(scale));
  draw();
  ImGui::PopFont();
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace gjkscope
