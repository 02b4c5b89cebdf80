#include <fmt/format.h>

#include <algorithm>

#include "subjects/difference/subject.hpp"
#include "subjects/difference/tour.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::blocks {

using namespace rows;

namespace {

void pairs(PanelBuilder& panel) {
  const PositionedRun& positioned = panel.run.run(panel.frame);
  const int per_x = static_cast<int>(positioned.y().world.size());
  const int all = static_cast<int>(positioned.x().world.size()) * per_x;
  panel.heading("Z = { y − x }: every pair");
  const BuildFrame build =
      build_frame(panel.run, panel.frame).value_or(BuildFrame{BuildPart::hull, all});
  const int newest = build.part == BuildPart::pair ? 1 : build.part == BuildPart::copy ? per_x : 0;
  constexpr int kMost = 16;
  for (int i = 0; i < std::min(all, kMost); ++i) {
    const gjk::VertexPair pair{i / per_x, i % per_x};
    const bool is_made = i < build.made;
    const bool current = is_made && i >= build.made - newest;
    if (current) panel.highlight();
    const std::string role = !is_made ? "untried" : current ? "code.current" : "code";
    const TextStyle style = current ? type::kCodeBold : type::kCode;
    panel.write(role, panel.left, panel.run.pair_name(pair), style);
    if (is_made)
      panel.write(role, panel.right,
                  panel.numbers.point(positioned.y().world[pair.y] - positioned.x().world[pair.x]),
                  style, Align::right);
    panel.y += kTightRow;
    if ((i + 1) % per_x == 0) panel.y += 6.0;
  }
  if (all > kMost) {
    panel.write("body.muted", panel.left, fmt::format("and {} more", all - kMost), type::kBody);
    panel.y += kRow;
  }
}

}  // namespace

const Block kPairs{
    .name = "pairs", .meaning = "the pairs of vertices and their differences", .write = pairs};

namespace {

using State = LineView::State;

/// Catto 2010, slide "Building the Minkowski difference".
void minkowski_listing(PanelBuilder& panel) {
  const PositionedRun& positioned = panel.run.run(panel.frame);
  const int per_x = static_cast<int>(positioned.y().world.size());
  const auto [part, made] = *build_frame(panel.run, panel.frame);
  const bool is_pair = part == BuildPart::pair;
  const bool is_copy = part == BuildPart::copy;
  const gjk::VertexPair pair{(made - 1) / per_x, (made - 1) % per_x};
  const Lesson& lesson = panel.run.lesson;
  write_line(panel, "points ← none", {part == BuildPart::start ? State::current : State::past});
  write_line(panel, "for each vertex x of X",
             {State::past, {}, is_pair || is_copy ? lesson.x().vertex_names[pair.x] : ""});
  write_line(panel, "  for each vertex y of Y",
             {State::past,
              {},
              is_pair   ? lesson.y().vertex_names[pair.y]
              : is_copy ? "all"
                        : ""});
  write_line(panel, "    add y − x to the points",
             {is_pair || is_copy ? State::current : State::past,
              {},
              is_pair ? panel.run.pair_name(pair) : ""});
  write_line(panel, "Z ← convex hull of the points",
             {part == BuildPart::hull  ? State::current
              : part > BuildPart::hull ? State::past
                                       : State::idle});
}

}  // namespace

}  // namespace gjkscope::blocks

namespace gjkscope::listings {

const Listing kMinkowski{.name = "minkowski",
                         .meaning = "Minkowski difference, pair by pair",
                         .write = blocks::minkowski_listing,
                         .tour = "pairs"};

}  // namespace gjkscope::listings
