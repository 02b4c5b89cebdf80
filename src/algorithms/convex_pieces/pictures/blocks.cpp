#include "picture/blocks/blocks.hpp"

#include "algorithms/convex_pieces/pictures/shown.hpp"

namespace gjkscope::parts {
namespace {

using namespace rows;

void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const auto write = [&](const std::string& text, bool current) {
    blocks::write_line(
        panel, text, {current ? blocks::LineView::State::current : blocks::LineView::State::idle});
    panel.y += kTightRow - kRow;
  };
  const bool pairs = shown.is(PiecesPhase::pair);
  const bool merges = shown.is(PiecesPhase::merge);
  const bool merged =
      merges &&
      shown.told.of(shown.step->of_x).merges[static_cast<std::size_t>(shown.step->index)].merged;
  write("cut X, Y into triangles, ear by ear", shown.is(PiecesPhase::triangle));
  write("for each diagonal", merges && !merged);
  write("  if both ends stay convex", false);
  write("    take it away", merged);
  write("δ ← ∞", false);
  write("for each pair of pieces p, q", false);
  write("  if their boxes are δ apart: skip", pairs && shown.run().skipped);
  write("  else δ ← min(δ, GJK(p, q))", pairs && !shown.run().skipped);
  write("the distance is δ", shown.is_answer);
}

void counts(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  panel.heading("Pieces");
  const auto row = [&](const std::string& what, const std::string& value) {
    panel.write("body.muted", panel.left, what, type::kBody);
    panel.write("code.current", panel.right, value, type::kCode, Align::right);
    panel.y += kRow;
  };
  if (shown.told.refusal) return row("refused", words_of(*shown.told.refusal, shown.lesson));
  row("triangles", std::to_string(shown.over(PiecesPhase::triangle)));
  int gone = 0;
  for (const bool of_x : {true, false}) {
    const auto& merges = shown.told.of(of_x).merges;
    for (int i = 0; i < shown.over(PiecesPhase::merge, of_x); ++i)
      gone += merges[static_cast<std::size_t>(i)].merged ? 1 : 0;
  }
  row("diagonals taken away", std::to_string(gone));
  int skipped = 0;
  const int pairs = shown.over(PiecesPhase::pair);
  for (int i = 0; i < pairs; ++i)
    skipped += shown.told.result.runs[static_cast<std::size_t>(i)].skipped ? 1 : 0;
  row("runs of GJK", std::to_string(pairs - skipped));
  row("pairs skipped", std::to_string(skipped));
  row("δ", shown.least() == nullptr ? "∞" : panel.numbers(shown.least()->distance));
}

}  // namespace

const Block kPieces{.name = "pieces",
                    .meaning = "triangles, diagonals taken away, runs of GJK, and δ by now",
                    .write = counts,
                    .act = "convex-pieces"};

const Listing kListing{.name = "convex-pieces",
                       .meaning = "convex pieces, and the least distance over their pairs",
                       .write = listing,
                       .act = "convex-pieces"};

}  // namespace gjkscope::parts
