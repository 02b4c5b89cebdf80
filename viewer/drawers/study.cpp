#include "drawers/study.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app.hpp"
#include "base/decimal.hpp"
#include "lesson/load.hpp"
#include "study/configuration.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using study::Arithmetic;

constexpr const char* kStudyLesson = "accuracy-cost.toml";
constexpr const char* kWorstRun = "worst-run";

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

/// The difference between the lesson's run and the configuration; empty when there is none.
std::string difference_from_lesson(const study::Configuration& configuration) {
  switch (configuration.arithmetic) {
    case Arithmetic::long_double:
    case Arithmetic::quad:
      return " Stepped in exact arithmetic: lessons have no " +
             std::string(configuration.arithmetic == Arithmetic::quad ? "quad." : "long double.");
    default:
      break;
  }
  return configuration.start == study::Start::warm ? " Stepped from a start between the centers."
                                                   : "";
}

/// Those on the front, or the first of all: as many as a lesson may introduce.
std::vector<StudyMark> marks_to_show(const std::vector<StudyDot>& family) {
  std::vector<StudyMark> marks;
  for (const StudyDot& dot : front_of(family)) marks.push_back({dot.configuration, "", "", ""});
  if (marks.empty()) marks.push_back({family.front().configuration, "", "", ""});
  if (marks.size() > LessonStudy::kMostMarks) marks.resize(LessonStudy::kMostMarks);
  return marks;
}

fs::path shipped_study(const App& app) { return app.share() / "lessons" / kStudyLesson; }

struct Study {
  App& app;
  /// The lesson and place that a worst run was opened from.
  struct Visit {
    Lesson lesson;
    fs::path file;
    bool unsaved = false;
    int index = 0;
  };
  std::optional<Visit> back;

  [[nodiscard]] Session& session() const { return app.session(); }

  /// The dots that the lesson's plot shows, by their index; empty without a study.
  [[nodiscard]] std::vector<StudyDot> dots() const {
    const LessonStudy* study = session().lesson().settings.as<LessonStudy>();
    return study ? of_family(study->dots(), study->family) : std::vector<StudyDot>();
  }

  /// The pair that a configuration answers worst, stepped as it computes.
  void open_worst_run(const StudyDot& dot) {
    const std::optional<study::Configuration> found = study::configuration_named(dot.configuration);
    if (!found)
      return app.say(fmt::format("this program has no configuration '{}'", dot.configuration),
                     true);
    Case shapes{dot.x, dot.y};
    if (found->arithmetic == Arithmetic::single_in_double) {
      for (auto* points : {&shapes.a, &shapes.b}) {
        for (Eigen::Vector2d& point : *points) point = point.cast<float>().cast<double>();
      }
    }
    ReadCase read;
    read.value = std::move(shapes);
    std::optional<Lesson> lesson =
        app.lesson_around(read, fmt::format("{}: worst of {}", dot.configuration, dot.family));
    if (!lesson) return;
    lesson->id = kWorstRun;
    lesson->prose = fmt::format("The distance is {}, the answer {}.{}", dot.distance,
                                dot.answer ? fmt::format("{}", *dot.answer) : std::string("none"),
                                difference_from_lesson(*found));
    lesson->scalar = scalar_of(found->arithmetic);
    lesson->options = found->options;
    lesson->options.start.count = found->start == study::Start::first_vertices ? 1 : 0;
    Visit from{session().lesson(), session().file(), session().is_unsaved(), session().index()};
    if (!app.show(*std::move(lesson), {}, dot.configuration)) return;
    back = std::move(from);
    app.say("B goes back to the study");
  }

  [[nodiscard]] bool can_go_back() const { return back && session().lesson().id == kWorstRun; }

  void go_back() {
    if (!can_go_back()) return app.say("there is no study to go back to");
    Visit visit = *std::exchange(back, std::nullopt);
    if (!app.show(std::move(visit.lesson), visit.file, visit.file.string(), visit.unsaved)) return;
    session().go_to(visit.index);
    app.say("");
  }

  void open_introduced() {
    const LessonStudy* study = session().lesson().settings.as<LessonStudy>();
    const StudyFrame shown = study_frame(session().run(), session().frame()).value_or(StudyFrame{});
    if (shown.stage != StudyStage::mark)
      return app.say("this frame introduces no configuration of a study");
    const StudyMark& mark = study->marks[shown.marks - 1];
    open_worst_run(study->dot(mark.configuration));
  }

  bool click(const Subject& subject) {
    if (subject.kind != Subject::Kind::study_dot) return false;
    open_worst_run(dots()[subject.x]);
    return true;
  }

  void draw_tooltip(const Subject& subject) const {
    if (subject.kind != Subject::Kind::study_dot) return;
    const std::vector<StudyDot> family = dots();
    const auto index = static_cast<std::size_t>(subject.x);
    if (index >= family.size()) return;
    const StudyDot& dot = family[index];
    ImGui::SetTooltip(
        "%s\n%s, %.2f x the time of double\nlargest error seen %s%s\nclick: step "
        "through its worst run",
        dot.configuration.c_str(), time_text(dot.ns).c_str(), dot.ratio, error_of(dot).c_str(),
        dot.on_front ? ", on the front" : "");
  }

  void draw() {
    if (can_go_back() && ImGui::Button("Back to the study (B)")) return go_back();
    const LessonStudy* study = session().lesson().settings.as<LessonStudy>();
    if (!study) {
      ImGui::TextWrapped(
          "Error against time of every way to run GJK. Open the accuracy.json that "
          "`gjkscope study accuracy --out DIR` writes, or:");
      if (ImGui::Button("Open the shipped study")) app.open_lesson(shipped_study(app));
      return;
    }
    std::string family = study->family;
    if (ImGui::BeginCombo("family", family.c_str())) {
      for (const std::string& name : families_in(study->dots())) {
        if (ImGui::Selectable(name.c_str(), name == family)) family = name;
      }
      ImGui::EndCombo();
    }
    if (family != study->family) {
      Lesson lesson = session().lesson();
      LessonStudy& shown = lesson.settings.edit<LessonStudy>();
      shown.family = family;
      shown.marks = marks_to_show(of_family(shown.dots(), family));
      app.edit("family", std::move(lesson));
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
      const bool pressed = ImGui::Selectable(label.c_str(), app.picture().hovered() == subject,
                                             ImGuiSelectableFlags_SpanAllColumns);
      if (ImGui::IsItemHovered()) app.pointed_in_panel = subject;
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
};

}  // namespace

void open_results(App& app, std::string_view json, const fs::path& file) {
  LessonStudy study;
  try {
    study.results = std::make_shared<const StudyResults>(parse_study_results(json));
  } catch (const std::runtime_error& error) {
    return app.say(fmt::format("{}: {}", file.string(), error.what()), true);
  }
  LoadedLesson loaded = load_lesson(shipped_study(app), vocabulary());
  if (!loaded.lesson) return app.say(to_string(loaded.problems.front()), true);
  Lesson lesson = std::move(*loaded.lesson);
  const std::vector<std::string> families = families_in(study.dots());
  const std::string& shipped = lesson.settings.as<LessonStudy>()->family;
  const bool has_family = std::find(families.begin(), families.end(), shipped) != families.end();
  study.family = has_family ? shipped : families.front();
  study.marks = marks_to_show(of_family(study.dots(), study.family));
  lesson.settings = TourSettings(std::move(study));
  lesson.settings.file = {fs::absolute(file).string(), std::make_shared<const std::string>(json)};
  if (app.show(std::move(lesson), {}, file.string())) app.show_drawer("Study");
}

Drawer study_drawer(App& app) {
  const auto study = std::make_shared<Study>(Study{app, std::nullopt});
  Drawer drawer{"Study", "A", "Error against time of every way to run GJK",
                [study] { study->draw(); }};
  drawer.clicked = [study](const Subject& subject) { return study->click(subject); };
  drawer.pointed = [study](const Subject& subject) { study->draw_tooltip(subject); };
  drawer.commands = {{"Worst run of the configuration",
                      "Study",
                      {"Enter"},
                      [study] { study->open_introduced(); },
                      [&app] {
                        return app.session().lesson().settings.as<LessonStudy>() &&
                               !app.session().question();
                      }},
                     {"Back to the study", "Study", {"B"}, [study] { study->go_back(); }}};
  return drawer;
}

}  // namespace gjkscope
