#include "subjects/run/subject.hpp"
#include "subjects/slab_proof/shown.hpp"

namespace gjkscope::slabs {
namespace {

using slab_proof::Phase;
using slab_proof::Reach;

void listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const bool is_empty = shown.is(Phase::slab) && shown.step->reaches.empty();
  const bool moves = shown.is(Phase::closer);
  blocks::listing_line(panel, "x, y ← any points of X, of Y",
                       shown.step == nullptr && shown.has_points());
  blocks::listing_line(panel, "loop", false);
  blocks::listing_line(panel, "  look at slab(x, y)", shown.is(Phase::slab) && !is_empty);
  blocks::listing_line(panel, "  if it is empty", false);
  blocks::listing_line(panel, "    stop: x, y are closest", is_empty || shown.is_answer);
  blocks::listing_line(panel, "  c ← deepest vertex in it", false);
  blocks::listing_line(panel, "  if c is a vertex of X", false);
  blocks::listing_line(panel, "    x ← closest to y on segment cx",
                       moves && shown.step->towards.of_x);
  blocks::listing_line(panel, "  else y ← closest to x on cy", moves && !shown.step->towards.of_x);
}

void reaches(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  panel.heading("Slab(x, y)");
  if (shown.trace.refusal)
    return panel.row("refused", words_of(*shown.trace.refusal, shown.lesson));
  if (!shown.has_points()) return panel.row("the shapes overlap", "");
  if (shown.is(Phase::closer)) {
    panel.row("width, |xy| before", panel.numbers(shown.step->before.distance()));
    return panel.row("|xy| now", panel.numbers(shown.step->after.distance()));
  }
  panel.row("width |xy|", panel.numbers(shown.state().distance()));
  if (shown.is(Phase::slab) || shown.is_answer) {
    for (const Reach& reach : shown.step->reaches)
      panel.row(shown.name(reach), panel.numbers(reach.depth) + " deep");
    if (shown.step->reaches.empty()) panel.row("vertices in it", "none");
  }
}

}  // namespace

const Block kSlabBlock{.name = "in-the-slab",
                       .meaning = "vertices that lie in the slab, how deep, and its width",
                       .write = reaches,
                       .tour = "slab-proof"};

const Listing kListing{.name = "slab-proof",
                       .meaning = "from slab to slab to the closest points (Larsen 1998)",
                       .write = listing,
                       .tour = "slab-proof"};

}  // namespace gjkscope::slabs
