#include "drawers/values.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app.hpp"
#include "lesson/names.hpp"
#include "session/edit.hpp"
#include "subjects/depth/penetration.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

void draw_values(App& app) {
  wrapped_text("Click a value to keep it in sight below the picture, whatever else is open.");
  ImGui::Checkbox("Hexadecimal", &app.hexadecimal);
  const LessonRun& run = app.session().run();
  ImGui::TextDisabled(run.point_query() ? "Points where they stand in the world"
                                        : "Points of Z = Y − X, measured from O");
  if (ImGui::BeginTable("##values", 2, kRuled)) {
    for (const NamedValue& value : values_now(app)) {
      ImGui::TableNextColumn();
      const bool is_pinned =
          std::find(app.pinned.begin(), app.pinned.end(), value.name) != app.pinned.end();
      if (ImGui::Selectable(value.name.c_str(), is_pinned, ImGuiSelectableFlags_SpanAllColumns))
        toggle_pin(app, value.name);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(value.text.c_str());
    }
    ImGui::EndTable();
  }
  if (run.tour->algorithm == &kGjkAlgorithm &&
      depth_on_overlap(app.session().effects(), run, app.session().frame()) != nullptr &&
      ImGui::Button("Show how it is found"))
    show_depth(app);
}

}  // namespace

std::vector<NamedValue> values_now(App& app) {
  const LessonRun& run = app.session().run();
  const Frame& frame = app.session().frame();
  const WideState& state = run.state(frame);
  const bool is_under_way = run.gjk_step(frame) >= 0;
  std::vector<NamedValue> values;
  const auto text = [&](std::string name, std::string written) {
    values.push_back({std::move(name), std::move(written)});
  };
  const auto value = [&](const std::string& name, double v) {
    text(name, number_text(v, app.hexadecimal));
  };
  const auto point = [&](const std::string& name, const Eigen::Vector3d& v) {
    for (int i = 0; i < run.lesson.dimension; ++i)
      value(fmt::format("{}.{}", name, "xyz"[i]), v[i]);
  };
  // As on the stage: a point query's points stand in the world, those of two shapes are
  // differences.
  const Eigen::Vector3d origin =
      run.point_query() ? run.run(frame).x().world[0] : Eigen::Vector3d(0.0, 0.0, 0.0);
  for (int i = 0; i < state.simplex.count; ++i) {
    const std::string name = run.pair_name(state.simplex.vertices[i].pair);
    point(name, state.simplex.vertices[i].w + origin);
    if (is_under_way) value("weight of " + name, state.simplex.weights[i]);
  }
  if (is_under_way) {
    point("P", state.p + origin);
    point("d", state.d);
    value("lower bound", run.bounds(frame).lower);
    value("upper bound", run.bounds(frame).upper);
  }
  if (run.tour->algorithm != &kGjkAlgorithm) {
    for (const auto& [name, written] : app.session().text().values) text(name, written);
    for (const std::string_view name : run.tour->algorithm->answers)
      value(std::string(name) + " in the end", run.algorithm_trace(frame).answer(name));
  }
  const WideTrace& trace = run.run(frame).trace;
  if (trace.is_empty()) return values;
  const WideResult& result = trace.result;
  value("distance in the end", result.distance);
  text("stop in the end", std::string(name_of(result.stop)));
  text("verdict in the end", std::string(name_of(result.verdict)));
  text("decided by", result.settled ? "exact arithmetic" : "the run itself");
  text("iterations", std::to_string(result.iterations));
  const DepthResult* deep = depth_on_overlap(app.session().effects(), run, frame);
  if (deep != nullptr) {
    value("penetration depth", deep->depth);
    value("its lower bound", deep->lower);
    value("its upper bound", deep->upper);
    point("shortest way out of X", deep->translation);
  }
  return values;
}

void show_depth(App& app) {
  Lesson lesson = edit::with_tour(app.session().lesson(), kDepthAlgorithm);
  const bool in_space = lesson.dimension == 3;
  const char* polygon = in_space ? "polytope" : "polygon";
  const char* edge = in_space ? "face" : "edge";
  lesson.title =
      fmt::format("Penetration depth: a {} expands until its nearest {} lies on Z", polygon, edge);
  lesson.prose = fmt::format(
      "GJK has found that the shapes overlap. From its last simplex a {} grows inside Z. When its "
      "nearest {} lies on Z's boundary, the way there is the shortest one out.",
      polygon, edge);
  lesson.source = "van den Bergen 2001";
  app.edit("penetration depth", std::move(lesson));
}

void toggle_pin(App& app, const std::string& name) {
  if (std::erase(app.pinned, name) == 0) app.pinned.push_back(name);
}

Drawer values_drawer(App& app) {
  return {"Values", "V", "All numbers of this frame", [&app] { draw_values(app); }};
}

}  // namespace gjkscope
