#include <imgui.h>

#include "app.hpp"
#include "effects/penetration.hpp"
#include "lesson/names.hpp"
#include "session/edit.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

void draw_values(App& app) {
  ImGui::Checkbox("Hexadecimal", &app.hexadecimal);
  const LessonRun& run = app.session().run();
  const Frame& frame = app.session().frame();
  const gjk::State<double, 2>& state = run.state(frame);
  if (!ImGui::BeginTable("##values", 2, kRuled)) return;
  const auto value = [&](const std::string& name, double v) {
    table_row(name, {number_text(v, app.hexadecimal)});
  };
  const auto point = [&](const std::string& name, const Eigen::Vector2d& v) {
    value(name + ".x", v.x());
    value(name + ".y", v.y());
  };
  for (int i = 0; i < state.simplex.count; ++i) {
    const std::string name = run.pair_name(state.simplex.vertices[i].pair);
    point(name, state.simplex.vertices[i].w);
    if (frame.step >= 0) value("weight of " + name, state.simplex.weights[i]);
  }
  if (frame.step >= 0) {
    point("P", state.p);
    point("d", state.d);
    value("lower bound", run.bounds(frame).lower);
    value("upper bound", run.bounds(frame).upper);
  }
  if (run.act->algorithm != nullptr) {
    for (const auto& [name, text] : app.session().text().values) table_row(name, {text});
    for (const std::string_view name : run.act->algorithm->answers)
      value(std::string(name) + " in the end", run.algorithm_trace(frame).answer(name));
  }
  if (!run.has_gjk()) return ImGui::EndTable();
  const gjk::Result<double, 2>& result = run.run(frame).trace.result;
  value("distance in the end", result.distance);
  table_row("stop in the end", {std::string(name_of(result.stop))});
  table_row("verdict in the end", {std::string(name_of(result.verdict))});
  table_row("decided by", {result.settled ? "exact arithmetic" : "the run itself"});
  table_row("iterations", {std::to_string(result.iterations)});
  const depth::Result<double>* deep = depth_on_overlap(app.session().effects(), run, frame);
  if (deep != nullptr) {
    value("penetration depth", deep->depth);
    value("its lower bound", deep->lower);
    value("its upper bound", deep->upper);
    point("shortest way out of X", deep->translation);
  }
  ImGui::EndTable();
  if (deep != nullptr && run.act->algorithm == nullptr && ImGui::Button("Show how it is found")) {
    app.edit("penetration depth", edit::told_by(run.lesson, kDepthAlgorithm));
  }
}

}  // namespace

Drawer values_drawer(App& app) {
  return {"Values", "V", "All numbers of this frame", [&app] { draw_values(app); }};
}

}  // namespace gjkscope
