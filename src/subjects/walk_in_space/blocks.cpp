#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "subjects/run/subject.hpp"
#include "subjects/walk_in_space/shown.hpp"

namespace gjkscope::space_walks {
namespace {

using v_clip::Reason;

void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const bool is_shown = shown.is_step() && !shown.asks;
  const SpaceWalk::Step step = is_shown ? shown.step() : SpaceWalk::Step{};
  const bool is_end = shown.is_answer && !shown.trace.all.empty();
  const bool meets = (is_shown || is_end) && !step.moves() &&
                     (is_end ? shown.trace.overlaps() : step.reason >= Reason::meet);
  const bool is_region = step.moves() && step.is_region;
  blocks::listing_line(panel, "fx, fy ← any feature of X, of Y", shown.index < 0);
  blocks::listing_line(panel, "loop", false);
  blocks::listing_line(panel, "  x, y ← closest points of fx, fy", shown.asks && !shown.is_path);
  blocks::listing_line(panel, "  if they meet: overlap, stop", meets);
  blocks::listing_line(panel, "  if x or y ends a feature: go there", step.moves() && !is_region);
  blocks::listing_line(panel, "  if y not in the region of fx", false);
  blocks::listing_line(panel, "    fx ← feature beyond the plane", is_region && step.body == 0);
  blocks::listing_line(panel, "  else if x not in that of fy",
                       is_shown && !meets && !step.moves() && step.body == 0);
  blocks::listing_line(panel, "    fy ← feature beyond the plane", is_region && step.body == 1);
  blocks::listing_line(panel, "  else stop: x, y are closest",
                       !meets && ((is_shown && !step.moves() && step.body == 1) || is_end));
}

/// Steps of all three methods, at this position and by now.
void on_path(PanelBuilder& panel, const Shown& shown) {
  const int over = shown.asks ? panel.frame.run : panel.frame.run + 1;
  std::array<std::array<int, 2>, 3> steps = {};
  for (int i = 0; i < over; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const SpaceWalk& trace = space_walk_trace(*panel.run.algorithm_traces[at]);
    const std::array<int, 3> here = {trace.all.empty() ? 0 : trace.pairs(),
                                     panel.run.runs[at].trace.result.iterations, trace.cold};
    for (std::size_t k = 0; k < here.size(); ++k) steps[k] = {here[k], steps[k][1] + here[k]};
  }
  constexpr std::array kNames = {"pairs of Lin-Canny", "iterations of GJK, warm",
                                 "iterations of GJK, cold"};
  const double now = panel.right - 64.0;
  panel.rule();
  if (!shown.asks) panel.write("heading", now, "now", type::kHeading, Align::right);
  panel.write("heading", panel.right, "in all", type::kHeading, Align::right);
  panel.heading("Steps");
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (!shown.asks)
      panel.write("code.current", now, std::to_string(steps[k][0]), type::kCode, Align::right);
    panel.row(kNames[k], std::to_string(steps[k][1]));
  }
}

/// The numbers at the end of the plot.
void growth(PanelBuilder& panel, WalkGrowing growing) {
  if (panel.frame.question >= 0) return;
  const SpaceWalkGrowth::Sample& last = panel.effects.get<SpaceWalkGrowth>(panel.frame).back();
  panel.heading(fmt::format("Pairs a position, n = {}", grouped(last.vertices)));
  panel.row("small moves", fixed(last.small_moves, 1));
  panel.row("one move for all n", fixed(last.pairs, 1));
  if (growing != WalkGrowing::cold) return;
  panel.row("from the first vertices", fixed(last.first_pair, 1));
  panel.row("√n", fixed(std::sqrt(last.vertices), 0));
  panel.row("n", grouped(last.vertices));
  panel.row("n²", grouped(1.0 * last.vertices * last.vertices));
}

void features(PanelBuilder& panel) {
  const auto growing = growth_of(panel.run, panel.frame);
  if (growing && *growing != WalkGrowing::beside_gjk) return growth(panel, *growing);
  const Shown shown(panel.run, panel.frame);
  if (shown.trace.all.empty()) return;
  const SpaceWalk::Step& step = shown.step();
  panel.row("fx", shown.name(0, step.at[0]));
  panel.row("fy", shown.name(1, step.at[1]));
  if (shown.is_path) return on_path(panel, shown);
  if (shown.index < 0) return;
  panel.row("distance of x, y", panel.numbers(step.distance()));
  if (shown.asks || shown.is_answer || shown.trace.overlaps()) return;
  panel.rule();
  const Eigen::Vector3d& point = step.points[1 - step.body];
  panel.heading(fmt::format("Least depths of {} in the region", step.body == 0 ? "y" : "x"));
  std::vector<cells::Border> all = shown.trace.feature(step).borders;
  std::stable_sort(all.begin(), all.end(), [&](const cells::Border& a, const cells::Border& b) {
    return a.depth(point) < b.depth(point);
  });
  constexpr std::size_t kMost = 4;
  for (std::size_t i = 0; i < std::min(all.size(), kMost); ++i) {
    if (step.moves() && all[i].beyond == shown.trace.border(step).beyond) panel.highlight();
    panel.row(all[i].beyond < 0 ? "plane of the face" : shown.short_name(step.body, all[i].beyond),
              panel.numbers(all[i].depth(point)));
  }
}

}  // namespace

const Block kFeatures{
    .name = "features-in-space",
    .meaning =
        "in space: the pair of features that the walk is at, and how deep the other's closest "
        "point lies in a region; along a path steps of the walk and of GJK",
    .write = features,
    .tour = "lin-canny-in-space",
    .shown_of = ShownOf::space};

const Listing kListing{.name = "lin-canny-in-space",
                       .meaning = "the walk on vertices, edges and faces (Lin and Canny 1991)",
                       .write = listing,
                       .tour = "lin-canny-in-space",
                       .shown_of = ShownOf::space};

}  // namespace gjkscope::space_walks
