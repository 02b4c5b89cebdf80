// Frames ask before they tell.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <memory>

#include "app.hpp"
#include "picture/words.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

using Kind = Subject::Kind;

struct Predict {
  App& app;
  int chosen = 0;  ///< Of the choices, by keyboard.
  Subject half;    ///< The first vertex that was clicked of a pair.

  [[nodiscard]] Session& session() const { return app.session(); }

  /// The name by which a question's choices call a subject; empty when they do not.
  [[nodiscard]] std::string name_of(const Subject& subject) const {
    const LessonRun& run = session().run();
    switch (subject.kind) {
      case Kind::vertex_of_x:
        return run.lesson.x().vertex_names[static_cast<std::size_t>(subject.x)];
      case Kind::vertex_of_y:
        return run.lesson.y().vertex_names[static_cast<std::size_t>(subject.y)];
      case Kind::difference_vertex:
        return run.pair_name({subject.x, subject.y});
      case Kind::region:
        return SimplexWords(run, run.state(session().frame()).simplex)
            .face(static_cast<gjk::Face>(subject.x));
      default:
        return {};
    }
  }

  void answer(const std::string& choice) {
    session().answer(choice);
    chosen = 0;
    half = {};
    const Answer& given = session().answers().back();
    app.say(given.is_right()
                ? fmt::format("Right: {}.", given.right)
                : fmt::format("Not so: the answer is {}, not {}.", given.right, given.chosen));
  }

  void choose(int number) {
    const FrameQuestion* question = session().question();
    if (question && number < static_cast<int>(question->choices.size()))
      answer(question->choices[static_cast<std::size_t>(number)]);
  }

  /// A click on a choice, or on the second of two vertices that make one.
  bool click(const Subject& subject) {
    const FrameQuestion* question = session().question();
    if (!question) return false;
    const std::vector<std::string>& choices = question->choices;
    const auto is_choice = [&](const std::string& name) {
      return !name.empty() && std::find(choices.begin(), choices.end(), name) != choices.end();
    };
    if (const std::string name = name_of(subject); is_choice(name)) {
      answer(name);
      return true;
    }
    const bool is_vertex = subject.kind == Kind::vertex_of_x || subject.kind == Kind::vertex_of_y;
    if (!is_vertex || question->ask != "support") return false;
    if (half.kind == Kind::none || half.kind == subject.kind) {
      half = subject;
      app.picture().selected = subject;
      const LessonShape& other =
          subject.kind == Kind::vertex_of_x ? session().lesson().y() : session().lesson().x();
      app.say(fmt::format("{}: now click a vertex of {}", name_of(subject), other.name));
      return true;
    }
    const Subject pair{Kind::difference_vertex, std::max(half.x, subject.x),
                       std::max(half.y, subject.y)};
    half = {};
    if (const std::string name = name_of(pair); is_choice(name)) {
      answer(name);
    } else {
      app.say(fmt::format("{} is none of the choices", name));
    }
    return true;
  }

  void draw() {
    wrapped_text(
        "Before a step is shown, say what it will do: click it on the stage, click here, press "
        "its number, or choose with Up and Down and answer with Enter. The answer is the run's, "
        "on any shapes.");
    const int asked = static_cast<int>(session().answers().size());
    ImGui::Separator();
    ImGui::Text("Score: %d of %d", session().right_answers(), asked);
    ImGui::Separator();
    if (const FrameQuestion* question = session().question()) {
      wrapped_text(session().text().caption);
      const std::vector<std::string> choices = question->choices;
      for (std::size_t i = 0; i < choices.size(); ++i) {
        const std::string label = fmt::format("{}  {}", i + 1, choices[i]);
        const bool is_chosen = static_cast<int>(i) == chosen;
        if (is_chosen)
          ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_Header));
        const bool pressed = ImGui::Button(label.c_str(), ImVec2(-1.0f, 0.0f));
        if (is_chosen) ImGui::PopStyleColor();
        if (pressed) return answer(choices[i]);
      }
    } else {
      if (asked > 0) {
        const Answer& last = session().answers().back();
        if (last.is_right()) {
          ImGui::TextColored(ImVec4(0.0f, 0.62f, 0.45f, 1.0f), "Right: %s.", last.right.c_str());
        } else {
          ImGui::TextColored(ImVec4(0.84f, 0.37f, 0.0f, 1.0f), "Not so: it was %s.",
                             last.right.c_str());
        }
      }
      app.draw_button("Next step", -1.0f);
    }
    if (asked == 0) return;
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
  const auto predict = std::make_shared<Predict>(Predict{app, 0, {}});
  Drawer drawer{"Predict", "P", "Say what a step will do before it is shown",
                [predict] { predict->draw(); }};
  drawer.toggled = [&app](bool is_open) { app.session().set_predicting(is_open); };
  drawer.clicked = [predict](const Subject& subject) { return predict->click(subject); };
  const auto is_asked = [&app] { return app.session().question() != nullptr; };
  for (int i = 0; i < 9; ++i) {
    drawer.commands.push_back({fmt::format("Answer {}", i + 1),
                               "Predict",
                               {std::to_string(i + 1)},
                               [predict, i] { predict->choose(i); },
                               is_asked});
  }
  for (const auto& [name, key, by] :
       {std::tuple("Choice below", "Down", 1), {"Choice above", "Up", -1}}) {
    drawer.commands.push_back({name,
                               "Predict",
                               {key},
                               [predict, by = by] {
                                 const auto count = static_cast<int>(
                                     predict->session().question()->choices.size());
                                 predict->chosen = (predict->chosen + by + count) % count;
                               },
                               is_asked});
  }
  drawer.commands.push_back({"Answer with the choice",
                             "Predict",
                             {"Enter"},
                             [predict] { predict->choose(predict->chosen); },
                             is_asked});
  return drawer;
}

}  // namespace gjkscope
