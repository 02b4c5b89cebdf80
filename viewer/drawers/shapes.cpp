#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "app.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

using Kind = Subject::Kind;
using Eigen::Vector2d;

/// The coordinates of a vertex in two fields; where one was typed, the vertex it makes.
std::optional<Vector2d> edit_vertex(App& app, const Vector2d& vertex) {
  std::optional<Vector2d> typed;
  for (int axis = 0; axis < 2; ++axis) {
    ImGui::SameLine();
    ImGui::PushID(axis);
    ImGui::SetNextItemWidth(static_cast<float>(122.0 * app.ui_scale()));
    std::string text = number_text(vertex[axis], app.hexadecimal);
    if (ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue)) {
      if (const std::optional<double> read = read_number(text)) {
        typed = vertex;
        (*typed)[axis] = *read;
      } else {
        app.say(fmt::format("'{}' is not a number: expected one like 0.25, 1e-6 or 0x1.8p-1", text),
                true);
      }
    }
    ImGui::PopID();
  }
  return typed;
}

void draw_shape(App& app, std::size_t body) {
  const bool is_x = body == 0;
  const LessonShape& shape = app.session().lesson().bodies[body];
  ImGui::Separator();
  ImGui::Text("%s: %zu %s", shape.name.c_str(), shape.vertices.size(),
              shape.vertices.size() == 1 ? "point" : "vertices");
  if (shape.vertices.size() > edit::kMostEditable) return ImGui::TextDisabled("too many to list");
  std::optional<std::pair<std::size_t, Vector2d>> typed;
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const int index = static_cast<int>(i);
    ImGui::PushID(index);
    const Subject subject =
        is_x ? Subject{Kind::vertex_of_x, index} : Subject{Kind::vertex_of_y, -1, index};
    const auto name_width = static_cast<float>(36.0 * app.ui_scale());
    if (ImGui::Selectable(shape.vertex_names[i].c_str(), app.picture().selected == subject, 0,
                          ImVec2(name_width, 0.0f)))
      app.picture().selected = subject;
    if (ImGui::IsItemHovered()) app.pointed_in_panel = subject;
    if (const std::optional<Vector2d> vertex = edit_vertex(app, shape.vertices[i]))
      typed = {i, *vertex};
    ImGui::PopID();
  }
  if (!typed) return;
  Lesson lesson = app.session().lesson();
  lesson.bodies[body].vertices[typed->first] = typed->second;
  app.edit("type a value", std::move(lesson));
}

}  // namespace

Drawer shapes_drawer(App& app) {
  return {"Shapes", "S", "Vertices as numbers", [&app] {
            wrapped_text(
                "Drag vertices, shapes and the handle of a selected shape on the stage. Double "
                "click an edge to add a vertex. Or type: decimal, or hex like 0x1.8p-1.");
            ImGui::Checkbox("Hexadecimal", &app.hexadecimal);
            for (const std::size_t body : {0, 1}) {
              ImGui::PushID(static_cast<int>(body));
              draw_shape(app, body);
              ImGui::PopID();
            }
            ImGui::Separator();
            app.draw_button("Delete the selected vertex");
          }};
}

}  // namespace gjkscope
