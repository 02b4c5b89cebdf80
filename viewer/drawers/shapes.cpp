#include "drawers/shapes.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "app.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Kit {
  int corners = 6;
  std::uint64_t pairs = 0;  ///< Random ones so far.
};

struct NamedShape {
  const char* name;
  std::vector<Vector2d> unit;  ///< As edit::reshape takes it.
};
const std::vector<NamedShape>& named_shapes() {
  static const std::vector<NamedShape> shapes = {
      {"point", {{0, 0}}},
      {"segment", {{-1, 0}, {1, 0}}},
      {"box", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}},
  };
  return shapes;
}

std::string becomes(std::size_t body, std::string_view name) {
  return fmt::format("{} becomes a {}", kBodyKeys[body], name);
}

void reshape(App& app, std::size_t body, const char* name, const std::vector<Vector2d>& unit) {
  Lesson lesson = app.session().lesson();
  edit::reshape(lesson, body, unit);
  if (app.edit(becomes(body, name), std::move(lesson))) app.picture().hand().selected = {};
}

void make_random_pair(App& app, std::uint64_t seed) {
  Session& session = app.session();
  Lesson lesson = session.lesson();
  edit::make_random_pair(lesson, session.run().run(session.frame()), seed);
  if (!app.edit("random pair", std::move(lesson))) return;
  app.session().fit();  // nobody has chosen where these are looked at from
  app.picture().hand().selected = {};
}

/// Describes a shape, with buttons that make it another one.
void draw_kit(App& app, std::size_t body, Kit& kit) {
  const LessonShape& now = app.session().lesson().bodies[body];
  ImGui::Text("%s: %zu %s", now.name.c_str(), now.vertices.size(),
              now.vertices.size() == 1 ? "point" : "vertices");
  for (const NamedShape& shape : named_shapes()) {
    if (ImGui::Button(shape.name)) reshape(app, body, shape.name, shape.unit);
    ImGui::SameLine();
  }
  if (ImGui::Button("regular")) make_regular(app, body, kit.corners);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(static_cast<float>(96.0 * app.ui_scale()));
  ImGui::InputInt("##corners", &kit.corners);
  kit.corners = std::clamp(kit.corners, kFewestCorners, kMostCorners);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("corners of a regular polygon");
}

/// A number in a field; the one that was typed, once it was.
std::optional<double> edit_number(App& app, double value, float width) {
  ImGui::SetNextItemWidth(width);
  std::string text = number_text(value, app.hexadecimal);
  if (!ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue)) return {};
  const std::optional<double> read = read_number(text);
  if (!read) {
    app.say(fmt::format("'{}' is not a number: expected one like 0.25, 1e-6 or 0x1.8p-1", text),
            true);
  }
  return read;
}

/// Typed, or in round steps; only where frames tell what comes of it.
void draw_radius(App& app, std::size_t body) {
  if (!app.session().run().tour->needs.takes_radius) return;
  const double now = app.session().lesson().bodies[body].radius;
  ImGui::PushID("radius");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("radius");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("the shape is all points within the radius of the polygon");
  ImGui::SameLine();
  std::optional<double> typed = edit_number(app, now, static_cast<float>(96.0 * app.ui_scale()));
  const double step = app.picture().hand().round_step(0).y();
  for (const auto& [sign, by] : {std::pair("-", -step), {"+", step}}) {
    ImGui::SameLine();
    if (ImGui::Button(sign, ImVec2(ImGui::GetFrameHeight(), 0.0f))) typed = std::max(now + by, 0.0);
  }
  ImGui::PopID();
  if (!typed || *typed == now) return;
  Lesson lesson = app.session().lesson();
  lesson.bodies[body].radius = *typed;
  app.edit(fmt::format("radius of {}", kBodyKeys[body]), std::move(lesson));
}

/// Whether fields beside each other, one for each coordinate, show all digits.
bool fit_beside(const App& app, const std::vector<Vector3d>& vertices, int dimension, float room) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto count = static_cast<float>(dimension);
  const float field =
      (room - (count - 1.0f) * style.ItemSpacing.x) / count - 2.0f * style.FramePadding.x;
  return std::all_of(vertices.begin(), vertices.end(), [&](const Vector3d& vertex) {
    return std::all_of(vertex.begin(), vertex.begin() + dimension, [&](double value) {
      return ImGui::CalcTextSize(number_text(value, app.hexadecimal).c_str()).x <= field;
    });
  });
}

/// The coordinates of a vertex in fields, side by side or one below the other; where one was typed,
/// the vertex it makes.
std::optional<Vector3d> edit_vertex(App& app, const Vector3d& vertex, int dimension, bool beside) {
  std::optional<Vector3d> typed;
  ImGui::SameLine();
  const float begin = ImGui::GetCursorPosX();
  for (int axis = 0; axis < dimension; ++axis) {
    if (axis > 0 && beside) ImGui::SameLine();
    if (axis > 0 && !beside) ImGui::SetCursorPosX(begin);
    ImGui::PushID(axis);
    const float rest = ImGui::GetContentRegionAvail().x;
    const auto left = static_cast<float>(beside ? dimension - axis : 1);  // fields on this line
    const float width = (rest - (left - 1.0f) * ImGui::GetStyle().ItemSpacing.x) / left;
    if (const std::optional<double> read = edit_number(app, vertex[axis], width)) {
      typed = vertex;
      (*typed)[axis] = *read;
    }
    ImGui::PopID();
  }
  return typed;
}

void draw_shape(App& app, std::size_t body, Kit& kit) {
  const bool is_x = body == 0;
  ImGui::Separator();
  draw_kit(app, body, kit);
  draw_radius(app, body);
  const LessonShape& shape = app.session().lesson().bodies[body];
  if (shape.vertices.size() > edit::kMostEditable) return ImGui::TextDisabled("too many to list");
  const int dimension = app.session().lesson().dimension;
  std::optional<std::pair<std::size_t, Vector3d>> typed;
  const auto name_width = static_cast<float>(36.0 * app.ui_scale());
  const bool beside =
      fit_beside(app, shape.vertices, dimension,
                 ImGui::GetContentRegionAvail().x - name_width - ImGui::GetStyle().ItemSpacing.x);
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const int index = static_cast<int>(i);
    ImGui::PushID(index);
    const Subject subject = vertex_of(body, index);
    const Color ink = app.theme().style(is_x ? "shape.x.label" : "shape.y.label").fill.value();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(ink.r, ink.g, ink.b, 255));
    if (ImGui::Selectable(shape.vertex_names[i].c_str(), app.picture().hand().selected == subject,
                          0, ImVec2(name_width, 0.0f)))
      app.picture().hand().selected = subject;
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) app.pointed_in_panel = subject;
    if (const std::optional<Vector3d> vertex =
            edit_vertex(app, shape.vertices[i], dimension, beside))
      typed = {i, *vertex};
    ImGui::PopID();
  }
  if (!typed) return;
  Lesson lesson = app.session().lesson();
  lesson.bodies[body].vertices[typed->first] = typed->second;
  app.edit("type a value", std::move(lesson));
}

}  // namespace

void make_regular(App& app, std::size_t body, int corners) {
  reshape(app, body, "regular polygon", edit::regular_polygon(corners));
}

Drawer shapes_drawer(App& app) {
  const auto kit = std::make_shared<Kit>();
  Drawer drawer{"Shapes", "S", "Shapes by name, and their vertices as numbers", [&app, kit] {
                  wrapped_text(
                      "Drag vertices, shapes and the handle of a selected shape on the stage. "
                      "Double click an edge to add a vertex. Or type: decimal, or hex like "
                      "0x1.8p-1.");
                  ImGui::Checkbox("Hexadecimal", &app.hexadecimal);
                  app.draw_button("Random pair");
                  for (const std::size_t body : {0, 1}) {
                    ImGui::PushID(static_cast<int>(body));
                    draw_shape(app, body, *kit);
                    ImGui::PopID();
                  }
                  ImGui::Separator();
                  app.draw_button("Delete the selected vertex");
                }};
  for (const std::size_t body : {0, 1}) {
    for (const NamedShape& shape : named_shapes()) {
      drawer.commands.push_back({becomes(body, shape.name), "Edit", {}, [&app, body, &shape] {
                                   reshape(app, body, shape.name, shape.unit);
                                 }});
    }
    drawer.commands.push_back({becomes(body, "regular polygon"), "Edit", {}, [&app, body, kit] {
                                 make_regular(app, body, kit->corners);
                               }});
  }
  drawer.commands.push_back(
      {"Random pair", "Edit", {}, [&app, kit] { make_random_pair(app, ++kit->pairs); }});
  return drawer;
}

}  // namespace gjkscope
