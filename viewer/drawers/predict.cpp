// Frames ask before they tell.

#include <fmt/format.h>
#include <imgui.h>

#include <memory>
#include <optional>
#include <tuple>

#include "app.hpp"
#include "session/practising.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

struct Predict {
  App& app;
  bool every_step = true;  ///< Or what the lesson asks.
  bool is_open = false;
  std::optional<Practising> practising = {};
  bool has_noted = false;  ///< The outcome of the task that is shown.

  [[nodiscard]] Session& session() const { return app.session(); }

  void ask() const {
    session().set_asking(is_open && !every_step);
    session().set_predicting(is_open && every_step);
  }

  /// Whether any frame of the run asks.
  [[nodiscard]] bool asks() const {
    for (const Frame& frame : session().run().frames) {
      if (frame.question >= 0) return true;
    }
    return false;
  }

  void show_task() {
    if (!app.show(practising->practice().task().lesson, {}, "practice")) return;
    every_step = false;
    ask();
    practising->begin(session());
    has_noted = false;
  }

  /// Goes on where the chapter was left.
  void practise(int chapter) {
    Memory::Practised& known = app.practised(chapter);
    practising.emplace(practice::Practice(chapter, known.seed, known.answers));
    show_task();
  }

  /// An answered task is not asked again where the window is closed before the next.
  void note_outcome() {
    if (has_noted || !has_answered_task()) return;
    const practice::Practice noted = practising->noted(session());
    app.practised(noted.chapter()).answers = noted.answers();
    has_noted = true;
  }

  void next_task() {
    note_outcome();
    practising->next(session());
    show_task();
  }
  [[nodiscard]] bool has_answered_task() const {
    return practising && practising->outcome(session());
  }

  void draw_practice() {
    heading(app, "Practice");
    wrapped_text(
        "Tasks about new shapes, of a chapter. Kinds that went wrong come again after one, three "
        "and seven others.");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Chapter");
    for (const int chapter : practice::chapters_with_practice()) {
      ImGui::SameLine();
      if (ImGui::Button(fmt::format("{}##practice", chapter).c_str())) practise(chapter);
      tip(fmt::format("Practise chapter {}", chapter), tips::kBelow, ImGui::IsItemHovered());
    }
    app.draw_button("Forget what was done", -1.0f);
    if (!practising) return;
    note_outcome();
    const practice::Practice& practice = practising->practice();
    if (const std::size_t answered = practice.answers().size(); answered > 0)
      wrapped_text(fmt::format("Chapter {}: {} of {} tasks right, {} to repeat", practice.chapter(),
                               practice.right(), answered, practice.repeating()));
    if (!practising->is_shown(session())) {
      if (ImGui::Button("Back to the task", {-1.0f, 0.0f})) show_task();
    } else {
      app.draw_button("Next task", -1.0f);
    }
  }

  void draw() {
    wrapped_text(
        "Before a step is shown, say what it will do: click it on the stage, click here, press "
        "its number, or choose with Up and Down and answer with Enter. The answer is the run's, "
        "on any shapes.");
    if (ImGui::RadioButton("Ask before every step", every_step)) every_step = true;
    if (ImGui::RadioButton("Ask what the lesson asks", !every_step)) every_step = false;
    ask();
    ImGui::Separator();
    const auto [right, asked] = session().score();
    ImGui::Text("Score in this lesson: %d of %d", right, asked);
    if (const int all = static_cast<int>(session().answers().size()); all > asked)
      ImGui::TextDisabled("in all lessons: %d of %d", session().right_answers(), all);
    ImGui::Separator();
    if (session().question()) {
      wrapped_text(session().text().caption);
      app.asking().draw();
    } else if (!asks()) {
      wrapped_text(every_step ? "No step of this lesson can be asked about: each has one answer."
                              : "This lesson asks nothing by itself.");
    } else {
      if (const FrameText text = session().shown_text(); text.is_right) {
        const char* const role = *text.is_right ? "caption.right" : "caption.wrong";
        const Color ink = *app.theme().style(role).fill;
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(ink.r, ink.g, ink.b, 255));
        wrapped_text(text.caption);
        ImGui::PopStyleColor();
      }
      app.draw_button("Next step", -1.0f);
    }
    ImGui::Separator();
    draw_practice();
    if (session().answers().empty()) return;
    ImGui::Separator();
    if (ImGui::Button("Save the answers as JSON")) {
      app.show_dialog(save_dialog(app, "Save the answers", "answers.json", {},
                                  [this](const std::filesystem::path& file) {
                                    app.write_text(file, session().answers_json());
                                  }));
    }
    if (ImGui::Button("Forget the answers")) session().forget_answers();
  }
};

}  // namespace

Drawer predict_drawer(App& app) {
  const auto predict = std::make_shared<Predict>(Predict{app});
  Drawer drawer{"Predict", "P", "Say what a step will do before it is shown",
                [predict] { predict->draw(); }};
  drawer.toggled = [predict](bool is_open) {
    predict->is_open = is_open;
    predict->ask();
  };
  const auto is_asked = [&app] { return app.asking().is_open(); };
  for (int i = 0; i < 10; ++i) {
    drawer.commands.push_back({fmt::format("Answer {}", i),
                               "Predict",
                               {std::to_string(i)},
                               [&app, i] { app.asking().type(i); },
                               is_asked});
  }
  for (const auto& [name, key, by] :
       {std::tuple("Choice below", "Down", 1), {"Choice above", "Up", -1}}) {
    drawer.commands.push_back(
        {name, "Predict", {key}, [&app, by = by] { app.asking().move(by); }, is_asked});
  }
  drawer.commands.push_back(
      {"Answer with the choice", "Predict", {"Enter"}, [&app] { app.asking().enter(); }, is_asked});
  for (const int chapter : practice::chapters_with_practice()) {
    drawer.commands.push_back(
        {fmt::format("Practise chapter {}", chapter), "Predict", {}, [&app, predict, chapter] {
           app.show_drawer("Predict");
           predict->practise(chapter);
         }});
  }
  drawer.commands.push_back({"Next task",
                             "Predict",
                             {"W"},
                             [predict] { predict->next_task(); },
                             [predict] { return predict->has_answered_task(); }});
  return drawer;
}

}  // namespace gjkscope
