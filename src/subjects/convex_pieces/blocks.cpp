#include <fmt/format.h>

#include "subjects/convex_pieces/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::parts {
namespace {

void listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const bool pairs = shown.is(PiecesPhase::pair);
  const bool merges = shown.is(PiecesPhase::merge);
  const bool merged = merges && shown.trace.of(shown.step->of_x).merges[shown.step->index].merged;
  blocks::listing_line(panel, "cut X, Y into triangles, ear by ear",
                       shown.is(PiecesPhase::triangle));
  blocks::listing_line(panel, "for each diagonal", merges && !merged);
  blocks::listing_line(panel, "  if both ends stay convex", false);
  blocks::listing_line(panel, "    take it away", merged);
  blocks::listing_line(panel, "δ ← ∞", false);
  blocks::listing_line(panel, "for each pair of pieces p, q", false);
  blocks::listing_line(panel, "  if their boxes are δ apart: skip", pairs && shown.run().skipped);
  blocks::listing_line(panel, "  else δ ← min(δ, GJK(p, q))", pairs && !shown.run().skipped);
  blocks::listing_line(panel, "the distance is δ", shown.is_answer);
}

void counts(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  panel.heading("Pieces");
  if (shown.trace.refusal)
    return panel.row("refused", words_of(*shown.trace.refusal, shown.lesson));
  panel.row("triangles", std::to_string(shown.over(PiecesPhase::triangle)));
  int gone = 0;
  for (const bool of_x : {true, false}) {
    const auto& merges = shown.trace.of(of_x).merges;
    for (int i = 0; i < shown.over(PiecesPhase::merge, of_x); ++i) gone += merges[i].merged ? 1 : 0;
  }
  panel.row("diagonals taken away", std::to_string(gone));
  const bool knows_fewest = shown.over(PiecesPhase::fewest) > 0;
  for (const bool of_x : {true, false}) {
    const std::size_t fewest = shown.trace.fewest_of(of_x).size();
    if (shown.over(PiecesPhase::pair) > 0 || !knows_fewest || fewest == 0) continue;
    panel.row(fmt::format("pieces of {}: found, fewest", shown.shape(of_x).name),
              fmt::format("{}, {}", shown.trace.of(of_x).pieces.size(), fewest));
  }
  int skipped = 0;
  const int pairs = shown.over(PiecesPhase::pair);
  for (int i = 0; i < pairs; ++i) skipped += shown.trace.result.runs[i].skipped ? 1 : 0;
  panel.row("runs of GJK", std::to_string(pairs - skipped));
  panel.row("pairs skipped", std::to_string(skipped));
  panel.row("δ", shown.least() == nullptr ? "∞" : panel.numbers(shown.least()->distance));
}

}  // namespace

const Block kPieces{.name = "pieces",
                    .meaning = "triangles, diagonals taken away, runs of GJK, and δ by now",
                    .write = counts,
                    .tour = "convex-pieces"};

const Listing kListing{.name = "convex-pieces",
                       .meaning = "convex pieces, and the least distance over their pairs",
                       .write = listing,
                       .tour = "convex-pieces"};

}  // namespace gjkscope::parts
