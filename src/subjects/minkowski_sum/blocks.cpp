#include <fmt/format.h>

#include "subjects/minkowski_sum/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::sums {
namespace {

using minkowski_sum::Phase;
using minkowski_sum::Source;

void listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const bool takes = shown.is(Phase::edge);
  blocks::listing_line(panel, "Y − X = Y + (−X)", shown.step == nullptr);
  blocks::listing_line(panel, "z ← lowest vertex of Y", false);
  blocks::listing_line(panel, "    + lowest vertex of −X", shown.is(Phase::lowest));
  blocks::listing_line(panel, "while an edge is left", false);
  blocks::listing_line(panel, "  f, g ← next edges of Y and −X", false);
  blocks::listing_line(panel, "  if f turns less: add f to z",
                       takes && shown.step->source == Source::y);
  blocks::listing_line(panel, "  else if g does: add g to z",
                       takes && shown.step->source == Source::x);
  blocks::listing_line(panel, "  else add both: parallel",
                       takes && shown.step->source == Source::both);
  blocks::listing_line(panel, "overlap ⇔ O is inside", shown.is(Phase::inside) || shown.is_answer);
}

void counts(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  panel.heading("Edges");
  if (shown.trace.refusal)
    return panel.row("refused", words_of(*shown.trace.refusal, shown.lesson));
  const minkowski_sum::State state =
      shown.step == nullptr ? minkowski_sum::State{} : shown.step->after;
  panel.row("edges of Y", fmt::format("{} of {}", state.edges_of_y, shown.merge.y.size()));
  panel.row("edges of −X", fmt::format("{} of {}", state.edges_of_x, shown.merge.x.size()));
  panel.row("differences computed",
            std::to_string(
                shown.step == nullptr
                    ? 0
                    : std::min(shown.edges() + 1, static_cast<int>(shown.merge.corners.size()))));
  panel.row("differences there are", std::to_string(shown.merge.x.size() * shown.merge.y.size()));
}

}  // namespace

const Block kMerge{
    .name = "merge",
    .meaning = "edges that the Minkowski difference has by now, and differences computed",
    .write = counts,
    .tour = "minkowski-sum"};

const Listing kListing{.name = "minkowski-sum",
                       .meaning = "the Minkowski difference, edge by edge (Larsen 1998)",
                       .write = listing,
                       .tour = "minkowski-sum"};

}  // namespace gjkscope::sums
