#include "picture/blocks/blocks.hpp"

#include "algorithms/lin_canny/pictures/shown.hpp"

namespace gjkscope::walks {
namespace {

using blocks::LineView;
using models::WalkPhase;
using models::WalkStop;
using namespace rows;

/// Lin and Canny 1991; Larsen 1998, "Lin-Canny".
void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const auto write = [&](const std::string& text, bool current, std::string value = {}) {
    LineView line{current ? LineView::State::current : LineView::State::idle};
    if (current) line.value = std::move(value);
    blocks::write_line(panel, text, line);
    panel.y += kTightRow - kRow;
  };
  const bool looked = shown.is(WalkPhase::regions);
  const bool met =
      shown.state.stop == WalkStop::overlap && (shown.is_answer || shown.is(WalkPhase::closest));
  const bool crossed = looked && shown.state.found.crossed;
  const bool ended = looked && !crossed;
  write("fx, fy ← any feature of X, of Y", shown.step == nullptr && shown.walk.query);
  write("loop", false);
  write("  x, y ← closest points of fx, fy", shown.is(WalkPhase::closest) && !met,
        shown.knows_pair() ? panel.numbers(shown.closest().distance) : "");
  write("  if they meet: overlap, stop", met);
  write("  if y not in the region of fx", crossed && shown.state.found.of_a);
  write("    fx ← neighbour beyond the border",
        shown.is(WalkPhase::swap) && shown.state.found.of_a);
  write("  else if x not in that of fy", crossed && !shown.state.found.of_a);
  write("    fy ← neighbour beyond the border",
        shown.is(WalkPhase::swap) && !shown.state.found.of_a);
  write("  else stop: x, y are closest", ended || (shown.is_answer && !met));
}

void row(PanelBuilder& panel, const std::string& what, const std::string& value) {
  panel.write("body.muted", panel.left, what, type::kBody);
  panel.write("code.current", panel.right, value, type::kCode, Align::right);
  panel.y += kRow;
}

void features(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  panel.write("heading", panel.left, "Features", type::kHeading);
  panel.y += kRow + 2.0;
  if (!shown.walk.query)
    return row(panel, "refused", std::string(models::name_of(shown.walk.trace.result.flaw.fault)));
  row(panel, "fx", shown.name(true));
  row(panel, "fy", shown.name(false));
  row(panel, "distance", shown.knows_pair() ? panel.numbers(shown.closest().distance) : "–");
  row(panel, "swaps", std::to_string(shown.state.swaps));
  row(panel, "pairs of features there are", std::to_string(shown.walk.query->pairs()));
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
