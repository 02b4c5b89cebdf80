#include <fmt/format.h>

#include "subjects/faces_of_difference/shown.hpp"

namespace gjkscope::zfaces {
namespace {

using sums_in_space::Kind;
using Phase = FacesTrace::Phase;

/// The numbers at the end of the plot.
void growth(PanelBuilder& panel, Growing growing) {
  if (panel.frame.question >= 0) return;
  if (growing == Growing::general) {
    const GrowthQuestion question =
        question_of(growing, panel.effects.get<FaceGrowth>(panel.frame));
    panel.heading(fmt::format("n = {}", question.vertices));
    for (const GrowthChoice& choice : question.choices)
      panel.row(choice.name, grouped(choice.ratio));
    return;
  }
  const FaceGrowth::Sample& last = panel.effects.get<FaceGrowth>(panel.frame).back();
  panel.heading(fmt::format("n = {}", last.vertices));
  panel.row("n · n differences", grouped(1.0 * last.vertices * last.vertices));
  panel.row("faces of Z, spheres", grouped(last.of_spheres));
  if (growing == Growing::faces) panel.row("faces of Z, lenses", grouped(last.of_lenses));
  panel.row("support points for the distance", std::to_string(last.asked_of_spheres));
  if (growing == Growing::depth)
    panel.row("support points for the depth", std::to_string(last.asked_for_depth));
}

/// The faces of Z that a frame has counted by then.
void face_kinds(PanelBuilder& panel) {
  if (const auto growing = growth_of(panel.run, panel.frame)) return growth(panel, *growing);
  const Shown shown(panel.run, panel.frame);
  panel.heading("Faces of Z");
  const FacesTrace& trace = shown.trace;
  const std::string& x = panel.run.lesson.x().name;
  const std::string& y = panel.run.lesson.y().name;
  const int over = shown.asks ? shown.step - 1 : shown.step;
  const auto is_counted = [&](Kind kind) {
    for (int i = 0; i <= over; ++i) {
      const FacesTrace::Step& step = trace.all[i];
      if (step.phase == Phase::all) return true;
      if (step.kind == kind && (step.phase == Phase::kind || trace.count(kind) == 1)) return true;
    }
    return false;
  };
  const auto row = [&](Kind kind, const std::string& name) {
    const bool is_now = over >= 0 && trace.all[over].kind == kind &&
                        trace.all[over].phase != Phase::all && !shown.asks;
    if (is_now) panel.highlight();
    panel.row(name, is_counted(kind) ? std::to_string(trace.count(kind)) : "");
  };
  row(Kind::of_y, fmt::format("faces of {}", y));
  row(Kind::of_x, fmt::format("faces of −{}", x));
  row(Kind::of_edges, "pairs of edges");
  if (trace.count(Kind::of_several) > 0) row(Kind::of_several, "of several");
  const bool has_all = over >= 0 && trace.all[over].phase == Phase::all;
  panel.row("in all", has_all ? std::to_string(trace.faces.size()) : "");
  panel.rule();
  panel.heading(fmt::format("{} and {} have", y, x));
  const auto& [of_x, of_y] = trace.hulls;
  panel.row("faces", fmt::format("{} and {}", of_y.faces.size(), of_x.faces.size()));
  panel.row("edges", fmt::format("{} and {}", of_y.edges.size(), of_x.edges.size()));
  panel.row("pairs of edges", std::to_string(of_y.edges.size() * of_x.edges.size()));
  if (!shown.is_answer || shown.asks) return;
  panel.rule();
  panel.heading("GJK");
  panel.row("support points", std::to_string(trace.support_points));
}

}  // namespace

const Block kFaceKinds{.name = "face-kinds",
                       .meaning = "in space: faces of Z by what they come from",
                       .write = face_kinds,
                       .tour = "faces-of-the-difference",
                       .shown_of = ShownOf::space};

}  // namespace gjkscope::zfaces
