#include "picture/blocks/blocks.hpp"

#include "algorithms/slab_proof/pictures/shown.hpp"

namespace gjkscope::slabs {
namespace {

using slab_proof::Phase;
using slab_proof::Reach;
using namespace rows;

void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const auto write = [&](const std::string& text, bool current) {
    blocks::write_line(
        panel, text, {current ? blocks::LineView::State::current : blocks::LineView::State::idle});
    panel.y += kTightRow - kRow;
  };
  const bool is_empty = shown.is(Phase::slab) && shown.step->reaches.empty();
  const bool moves = shown.is(Phase::closer);
  write("x, y ← any points of X, of Y", shown.step == nullptr && shown.has_points());
  write("loop", false);
  write("  look at slab(x, y)", shown.is(Phase::slab) && !is_empty);
  write("  if it is empty", false);
  write("    stop: x, y are closest", is_empty || shown.is_answer);
  write("  c ← deepest vertex in it", false);
  write("  if c is a vertex of X", false);
  write("    x ← closest to y on segment cx", moves && shown.step->towards.of_x);
  write("  else y ← closest to x on cy", moves && !shown.step->towards.of_x);
}

void reaches(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  panel.heading("Slab(x, y)");
  const auto row = [&](const std::string& what, const std::string& value) {
    panel.write("body.muted", panel.left, what, type::kBody);
    panel.write("code.current", panel.right, value, type::kCode, Align::right);
    panel.y += kRow;
  };
  if (shown.told.refusal) return row("refused", words_of(*shown.told.refusal, shown.lesson));
  if (!shown.has_points()) return row("the shapes overlap", "");
  row("width |xy|", panel.numbers(shown.state().distance()));
  if (shown.is(Phase::slab) || shown.is_answer) {
    for (const Reach& reach : shown.step->reaches)
      row(shown.name(reach), panel.numbers(reach.depth) + " deep");
    if (shown.step->reaches.empty()) row("vertices in it", "none");
  }
}

}  // namespace

const Block kSlabBlock{.name = "in-the-slab",
                       .meaning = "vertices that lie in the slab, how deep, and its width",
                       .write = reaches,
                       .act = "slab-proof"};

const Listing kListing{.name = "slab-proof",
                       .meaning = "from slab to slab to the closest points (Larsen 1998)",
                       .write = listing,
                       .act = "slab-proof"};

}  // namespace gjkscope::slabs
