// The study of accuracy in the window: its dots, and the runs behind them.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "app.hpp"
#include "effects/registry.hpp"
#include "lesson/load.hpp"
#include "lesson/schema.hpp"
#include "picture/registry.hpp"
#include "study/configuration.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using study::Arithmetic;

constexpr const char* kStudyLesson = "accuracy-cost.toml";

std::string error_of(const StudyDot& dot) { return dot.error ? error_text(*dot.error) : "none"; }

ScalarKind scalar_of(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::half:
      return ScalarKind::half;
    case Arithmetic::single:
      return ScalarKind::single;
    case Arithmetic::single_in_double:
    case Arithmetic::double_:
      return ScalarKind::double_;
    case Arithmetic::long_double:
    case Arithmetic::quad:
    case Arithmetic::exact:
      break;
  }
  return ScalarKind::exact;
}

/// What a lesson steps otherwise than the configuration; empty when nothing.
std::string told_apart(const study::Configuration& configuration) {
  switch (configuration.arithmetic) {
    case Arithmetic::long_double:
    case Arithmetic::quad:
      return " Stepped in exact arithmetic: lessons have no " +
             std::string(configuration.arithmetic == Arithmetic::quad ? "quad." : "long double.");
    default:
      break;
  }
  return configuration.start == study::Start::warm ? " Stepped from a start between the centres."
                                                   : "";
}

/// Those on the front, or the first of all: as many as a lesson may introduce.
std::vector<StudyMark> marks_to_show(const std::vector<StudyDot>& family) {
  std::vector<StudyMark> marks;
  for (const StudyDot& dot : front_of(family)) marks.push_back({dot.configuration, "", "", ""});
  if (marks.empty()) marks.push_back({family.front().configuration, "", "", ""});
  if (marks.size() > limits::kMarks) marks.resize(limits::kMarks);
  return marks;
}

}  // namespace

std::vector<StudyDot> App::dots() const {
  const auto& study = session_.lesson().study;
  return study ? of_family(study->dots, study->family) : std::vector<StudyDot>();
}

void App::open_results(std::string_view json, const fs::path& file) {
  LessonStudy study;
  study.results = fs::absolute(file).string();
  try {
    StudyResults results = parse_study_results(json);
    study.processor = std::move(results.processor);
    study.dots = std::move(results.dots);
  } catch (const std::runtime_error& error) {
    return say(fmt::format("{}: {}", file.string(), error.what()), true);
  }
  LoadedLesson loaded = load_lesson(paths_.share / "lessons" / kStudyLesson, vocabulary());
  if (!loaded.lesson) return say(to_string(loaded.problems.front()), true);
  Lesson lesson = std::move(*loaded.lesson);
  const std::vector<std::string> families = families_in(study.dots);
  const bool has_family =
      std::find(families.begin(), families.end(), lesson.study->family) != families.end();
  study.family = has_family ? lesson.study->family : families.front();
  study.marks = marks_to_show(of_family(study.dots, study.family));
  lesson.study = std::move(study);
  if (show(std::move(lesson), {}, file.string())) drawer_ = Drawer::study;
}

void App::open_worst_run(const StudyDot& dot) {
  const std::optional<study::Configuration> found = study::configuration_named(dot.configuration);
  if (!found)
    return say(fmt::format("this program has no configuration '{}'", dot.configuration), true);
  Case shapes{dot.x, dot.y};
  if (found->arithmetic == Arithmetic::single_in_double) {
    for (auto* points : {&shapes.a, &shapes.b}) {
      for (Eigen::Vector2d& point : *points) point = point.cast<float>().cast<double>();
    }
  }
  std::optional<Lesson> lesson =
      lesson_around(shapes, fmt::format("{}: worst of {}", dot.configuration, dot.family));
  if (!lesson) return;
  lesson->id = "worst-run";
  lesson->prose = fmt::format("The distance is {}, the answer {}.{}", dot.distance,
                              dot.answer ? fmt::format("{}", *dot.answer) : std::string("none"),
                              told_apart(*found));
  lesson->scalar = scalar_of(found->arithmetic);
  lesson->options = found->options;
  lesson->options.start.count = found->start == study::Start::first_vertices ? 1 : 0;
  if (!is_sound(*lesson)) return;
  Visit from{session_.lesson(), session_.file(), session_.is_unsaved(), session_.index()};
  if (!show(*std::move(lesson), {}, dot.configuration)) return;
  back_ = std::move(from);
  say("B goes back to the study");
}

void App::go_back() {
  if (!back_) return say("there is no study to go back to");
  const Visit visit = *std::exchange(back_, std::nullopt);
  release();
  if (!session_.open(visit.lesson, visit.file, visit.unsaved)) return say(session_.problem(), true);
  session_.go_to(visit.index);
  selected_ = {};
  playing_ = false;
  say("");
}

void App::draw_dot_tooltip() const {
  if (hovered_.kind != Subject::Kind::study_dot) return;
  const std::vector<StudyDot> family = dots();
  const auto index = static_cast<std::size_t>(hovered_.x);
  if (index >= family.size()) return;
  const StudyDot& dot = family[index];
  ImGui::SetTooltip(
      "%s\n%s, %.2f x the time of double\nlargest error seen %s%s\nclick: step "
      "through its worst run",
      dot.configuration.c_str(), time_text(dot.ns).c_str(), dot.ratio, error_of(dot).c_str(),
      dot.on_front ? ", on the front" : "");
}

void App::draw_study() {
  ImGui::Text("Study");
  if (back_ && ImGui::Button("Back to the study (B)")) return go_back();
  const auto& study = session_.lesson().study;
  if (!study) {
    ImGui::TextWrapped(
        "Error against time of every way to run GJK. Open the accuracy.json that "
        "`gjkscope study accuracy --out DIR` writes, or:");
    if (ImGui::Button("Open the shipped study"))
      open_lesson(paths_.share / "lessons" / kStudyLesson);
    return;
  }
  std::string family = study->family;
  if (ImGui::BeginCombo("family", family.c_str())) {
    for (const std::string& name : families_in(study->dots)) {
      if (ImGui::Selectable(name.c_str(), name == family)) family = name;
    }
    ImGui::EndCombo();
  }
  if (family != study->family) {
    const auto choose = [&](Lesson& lesson) {
      lesson.study->family = family;
      lesson.study->marks = marks_to_show(of_family(lesson.study->dots, family));
    };
    if (!session_.change("family", choose)) say(session_.problem(), true);
    return;
  }
  ImGui::TextWrapped(
      "Each line opens the worst run behind it. * is on the front: nothing takes less time and "
      "errs no "
      "more.");
  std::vector<StudyDot> family_dots = dots();
  std::vector<std::size_t> order(family_dots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return family_dots[a].ns < family_dots[b].ns;
  });
  if (!ImGui::BeginTable(
          "##dots", 3,
          ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit)) {
    return;
  }
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("configuration", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("time");
  ImGui::TableSetupColumn("error");
  ImGui::TableHeadersRow();
  for (const std::size_t i : order) {
    const StudyDot& dot = family_dots[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = fmt::format("{}{}", dot.on_front ? "* " : "  ", dot.configuration);
    const Subject subject{Subject::Kind::study_dot, static_cast<int>(i)};
    const bool pressed =
        ImGui::Selectable(label.c_str(), hovered_ == subject, ImGuiSelectableFlags_SpanAllColumns);
    if (ImGui::IsItemHovered()) pointed_in_panel_ = subject;
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(time_text(dot.ns).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(error_of(dot).c_str());
    if (pressed) {
      ImGui::EndTable();
      return open_worst_run(dot);
    }
  }
  ImGui::EndTable();
}

}  // namespace gjkscope
