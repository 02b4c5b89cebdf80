#include <fmt/format.h>

#include "subjects/feature_regions/shown.hpp"

namespace gjkscope::cells {
namespace {

using Phase = RegionsTrace::Phase;

/// The planes of a region, and how deep a point lies inside of each; of many regions their number.
void region_planes(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  if (shown.step < 0 || shown.asks) return;
  const RegionsTrace::Step& at = shown.at();
  const bool has_point = shown.is(Phase::query) || shown.is(Phase::region);
  if (has_point || shown.is(Phase::one)) {
    if (shown.feature_index() < 0) return;
    if (has_point)
      panel.write("heading", panel.right, "depth inside", type::kHeading, Align::right);
    panel.heading(fmt::format("Region of {}", shown.name(shown.feature_index())));
    for (const Border& border : shown.trace.borders(at)) {
      const double depth = border.depth(shown.trace.point(at));
      if (has_point && depth < 0.0) panel.highlight();
      panel.row(border.beyond < 0 ? "plane of the face" : "plane at " + shown.name(border.beyond),
                has_point ? panel.numbers(depth) : "");
    }
  } else if (!shown.is_query) {
    panel.heading("The pair x, y");
    panel.row("distance", panel.numbers(shown.pair().distance()));
  } else {
    panel.heading("Regions");
    constexpr std::array<const char*, kKinds> kNames = {"of faces", "of edges", "of vertices"};
    for (int i = 0; i < kKinds; ++i) {
      const bool is_shown = shown.is(Phase::all) || i <= static_cast<int>(at.kind);
      panel.row(kNames[i], is_shown ? std::to_string(shown.trace.count(static_cast<Kind>(i))) : "");
    }
    if (shown.is(Phase::all)) panel.row("in all", std::to_string(shown.trace.features[1].size()));
  }
}

}  // namespace

const Block kRegionPlanes{
    .name = "region-planes",
    .meaning = "in space: the planes of a region, and how deep a point lies inside",
    .write = region_planes,
    .tour = "feature-regions",
    .shown_of = ShownOf::space};

}  // namespace gjkscope::cells
