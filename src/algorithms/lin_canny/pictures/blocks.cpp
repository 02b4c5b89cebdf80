#include "picture/blocks/blocks.hpp"

#include "algorithms/lin_canny/pictures/shown.hpp"

namespace gjkscope::walks {
namespace {

using models::WalkPhase;
using models::WalkStop;
using namespace rows;

/// Lin and Canny 1991; Larsen 1998, "Lin-Canny".
void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const bool looked = shown.is(WalkPhase::regions);
  const bool met =
      shown.state.stop == WalkStop::overlap && (shown.is_answer || shown.is(WalkPhase::closest));
  const bool crossed = looked && shown.state.found.crossed;
  const bool ended = looked && !crossed;
  blocks::listing_line(panel, "fx, fy ← any feature of X, of Y",
                       shown.step == nullptr && shown.walk.query);
  blocks::listing_line(panel, "loop", false);
  blocks::listing_line(panel, "  x, y ← closest points of fx, fy",
                       shown.is(WalkPhase::closest) && !met,
                       shown.knows_pair() ? panel.numbers(shown.closest().distance) : "");
  blocks::listing_line(panel, "  if they meet: overlap, stop", met);
  blocks::listing_line(panel, "  if y not in the region of fx", crossed && shown.state.found.of_a);
  blocks::listing_line(panel, "    fx ← neighbour beyond the border",
                       shown.is(WalkPhase::swap) && shown.state.found.of_a);
  blocks::listing_line(panel, "  else if x not in that of fy", crossed && !shown.state.found.of_a);
  blocks::listing_line(panel, "    fy ← neighbour beyond the border",
                       shown.is(WalkPhase::swap) && !shown.state.found.of_a);
  blocks::listing_line(panel, "  else stop: x, y are closest", ended || (shown.is_answer && !met));
}

void features(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  panel.write("heading", panel.left, "Features", type::kHeading);
  panel.y += kRow + 2.0;
  if (!shown.walk.query)
    return panel.row("refused", std::string(models::name_of(shown.walk.trace.result.flaw.fault)));
  panel.row("fx", shown.name(true));
  panel.row("fy", shown.name(false));
  panel.row("distance", shown.knows_pair() ? panel.numbers(shown.closest().distance) : "–");
  panel.row("swaps", std::to_string(shown.state.swaps));
  panel.row("pairs of features there are", std::to_string(shown.walk.query->pairs()));
}

}  // namespace

const Block kFeatures{
    .name = "features",
    .meaning = "the pair of features that the walk is at, their distance, and swaps",
    .write = features,
    .act = "lin-canny"};

const Listing kListing{.name = "lin-canny",
                       .meaning = "the walk on features (Lin and Canny 1991)",
                       .write = listing,
                       .act = "lin-canny"};

}  // namespace gjkscope::walks
