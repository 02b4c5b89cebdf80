#include <fmt/format.h>

#include <algorithm>

#include "subjects/hill_climbing/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::climbs {
namespace {

void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const bool has_step = shown.step >= 0 && !shown.is_answer && !shown.asks;
  const bool moves = has_step && shown.look().next >= 0;
  blocks::listing_line(panel, "v ← last support point", shown.step < 0);
  blocks::listing_line(panel, "loop", false);
  blocks::listing_line(panel, "  n ← farthest neighbour of v", false);
  blocks::listing_line(panel, "  if d · n ≤ d · v: stop", has_step && !moves);
  blocks::listing_line(panel, "  v ← n", moves);
}

/// The current vertex and its neighbours, the farthest first, each with its dot product and a bar
/// for how much farther it lies than the current vertex.
void products(PanelBuilder& panel, const Shown& shown) {
  constexpr std::size_t kMost = 7;
  constexpr double kName = 34.0;
  constexpr double kNumber = 74.0;
  panel.heading(fmt::format("Neighbours of {}: {} · n", shown.name(shown.look().at), shown.d()));
  const double of_now = shown.product(shown.look().at);
  std::vector<int> all = shown.neighbours();
  if (!shown.asks) {
    std::stable_sort(all.begin(), all.end(),
                     [&](int a, int b) { return shown.product(a) > shown.product(b); });
  }
  double most = 0.0;
  for (const int each : all) most = std::max(most, std::abs(shown.product(each) - of_now));
  const auto row = [&](int vertex, const std::string& role, const TextStyle& style) {
    panel.subject = shown.subject(vertex);
    panel.write(role, panel.left, shown.name(vertex), style);
    if (!shown.asks || vertex == shown.look().at) {
      if (most > 0.0 && vertex != shown.look().at)
        panel.bar(panel.left + kName, panel.right - kNumber, -most, most,
                  shown.product(vertex) - of_now, "weight.bar");
      panel.write("code.current", panel.right, panel.numbers(shown.product(vertex)),
                  vertex == shown.look().next && !shown.asks ? type::kCodeBold : type::kCode,
                  Align::right);
    }
    panel.subject = {};
    panel.y += rows::kTightRow;
  };
  for (std::size_t i = 0; i < std::min(all.size(), kMost); ++i) {
    const bool is_next = all[i] == shown.look().next && !shown.asks;
    if (is_next) panel.highlight();
    row(all[i], "body", is_next ? type::kStrong : type::kBody);
  }
  if (all.size() > kMost) panel.row(fmt::format("and {} more", all.size() - kMost), "");
  row(shown.look().at, "body.muted", type::kBody);
}

void climb(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  if (shown.step >= 0 && (!shown.is_answer || shown.asks)) {
    products(panel, shown);
    panel.rule();
  }
  panel.heading("Dot products");
  const ClimbTrace& trace = shown.trace;
  if (shown.step < 0 || shown.is_answer) {
    for (std::size_t i = 0; i < trace.climbs.size() && shown.is_answer; ++i) {
      const Climb& each = trace.climbs[i];
      const Body& body = shown.bodies[each.of_x ? 0 : 1];
      const LessonShape& shape = panel.run.lesson.bodies[each.of_x ? 0 : 1];
      panel.row(fmt::format("walk {} to {}", i + 1, shape.vertex_names[each.walk.end()]),
                fmt::format("{} of {}", each.walk.products(), body.world.size()));
      constexpr std::size_t kMost = 8;
      if (i + 1 == kMost) break;
    }
    panel.row("all walks", std::to_string(shown.is_answer ? trace.walked(trace.steps()) : 0));
    if (shown.is_answer) panel.row("all scans", std::to_string(trace.scanned));
    return;
  }
  panel.row("this walk", std::to_string(shown.products()));
  panel.row("all walks by now", std::to_string(trace.walked(shown.over())));
  panel.row("a scan", std::to_string(shown.bodies[shown.body()].world.size()));
}

}  // namespace

const Block kClimb{
    .name = "climb",
    .meaning = "in space: the neighbours that a walk looks at, and dot products of walks and scans",
    .write = climb,
    .tour = "hill-climbing",
    .shown_of = ShownOf::space};

const Listing kListing{.name = "hill-climbing",
                       .meaning = "a support point of a polyhedron, by a walk on its vertices",
                       .write = listing,
                       .tour = "hill-climbing",
                       .shown_of = ShownOf::space};

}  // namespace gjkscope::climbs
