#include <fmt/format.h>

#include "subjects/lin_canny/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::walks {
namespace {

using models::WalkPhase;
using models::WalkStop;
using namespace rows;

/// Lin and Canny 1991; Larsen 1998, "Lin-Canny".
void listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const bool looked = shown.is(WalkPhase::regions);
  const bool met =
      shown.state.stop == WalkStop::overlap && (shown.is_answer || shown.is(WalkPhase::closest));
  const bool crossed = looked && shown.state.found.crossed;
  const bool ended = looked && !crossed;
  // Behind an edge no border is crossed.
  const std::string nearest = shown.step != nullptr && shown.step->asked > 0 ? "nearest edge" : "";
  blocks::listing_line(panel,
                       panel.frame.run == 0 ? "fx, fy ← any feature of X, of Y"
                                            : "fx, fy ← where the last walk ended",
                       shown.step == nullptr && shown.walk.query);
  blocks::listing_line(panel, "loop", false);
  blocks::listing_line(panel, "  x, y ← closest points of fx, fy",
                       shown.is(WalkPhase::closest) && !met,
                       shown.knows_pair() ? panel.numbers(shown.closest().distance) : "");
  blocks::listing_line(panel, "  if they meet: overlap, stop", met);
  blocks::listing_line(panel, "  if y not in the region of fx", crossed && shown.state.found.of_a);
  blocks::listing_line(panel, "    fx ← neighbour beyond the border",
                       shown.is(WalkPhase::swap) && shown.state.found.of_a, nearest);
  blocks::listing_line(panel, "  else if x not in that of fy", crossed && !shown.state.found.of_a);
  blocks::listing_line(panel, "    fy ← neighbour beyond the border",
                       shown.is(WalkPhase::swap) && !shown.state.found.of_a, nearest);
  blocks::listing_line(panel, "  else stop: x, y are closest", ended || (shown.is_answer && !met));
}

/// "y beyond edge CD"
std::string beyond(const Shown& shown, bool of_x, const Border& border) {
  const bool is_back = border.neighbour == shown.feature(of_x);
  const std::string name = shown.name(of_x, border.neighbour);
  return fmt::format("{} {} {}", of_x ? "y" : "x", is_back ? "behind" : "beyond",
                     name.substr(0, name.rfind(" of ")));
}

void features(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  panel.write("heading", panel.left, "Features", type::kHeading);
  panel.y += kRow + 2.0;
  if (!shown.walk.query)
    return panel.row("refused", std::string(models::name_of(shown.walk.trace.result.flaw.fault)));
  panel.row("fx", shown.name(true));
  panel.row("fy", shown.name(false));
  panel.row("swaps", std::to_string(shown.state.swaps));
  if (!shown.is(WalkPhase::regions)) return;
  for (const bool of_x : {true, false}) {
    for (const Border& border : shown.borders(of_x)) {
      if (border.neighbour == shown.feature(of_x) && !shown.walk.query->convex) continue;
      panel.row(beyond(shown, of_x, border),
                panel.numbers(border.beyond(of_x ? shown.closest().b : shown.closest().a)));
    }
  }
}

}  // namespace

const Block kFeatures{
    .name = "features",
    .meaning =
        "the pair of features that the walk is at, swaps, and how far each closest point lies "
        "beyond the borders of the other's region",
    .write = features,
    .tour = "lin-canny"};

const Listing kListing{.name = "lin-canny",
                       .meaning = "the walk on features (Lin and Canny 1991)",
                       .write = listing,
                       .tour = "lin-canny"};

}  // namespace gjkscope::walks
