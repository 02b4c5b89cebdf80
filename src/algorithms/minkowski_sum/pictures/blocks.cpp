#include "picture/blocks/blocks.hpp"

#include <fmt/format.h>

#include "algorithms/minkowski_sum/pictures/shown.hpp"

namespace gjkscope::sums {
namespace {

using minkowski_sum::Phase;
using minkowski_sum::Source;
using namespace rows;

void listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const auto write = [&](const std::string& text, bool current) {
    blocks::write_line(
        panel, text, {current ? blocks::LineView::State::current : blocks::LineView::State::idle});
    panel.y += kTightRow - kRow;
  };
  const bool takes = shown.is(Phase::edge);
  write("Y − X = Y + (−X)", shown.step == nullptr);
  write("z ← lowest vertex of Y", false);
  write("    + lowest vertex of −X", shown.is(Phase::lowest));
  write("while an edge is left", false);
  write("  f, g ← next edges of Y and −X", false);
  write("  if f turns less: add f to z", takes && shown.step->source == Source::y);
  write("  else if g does: add g to z", takes && shown.step->source == Source::x);
  write("  else add both: parallel", takes && shown.step->source == Source::both);
  write("overlap ⇔ O is inside", shown.is(Phase::inside) || shown.is_answer);
}

void counts(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  panel.heading("Edges");
  const auto row = [&](const std::string& what, const std::string& value) {
    panel.write("body.muted", panel.left, what, type::kBody);
    panel.write("code.current", panel.right, value, type::kCode, Align::right);
    panel.y += kRow;
  };
  if (shown.told.refusal) return row("refused", words_of(*shown.told.refusal, shown.lesson));
  const minkowski_sum::State state =
      shown.step == nullptr ? minkowski_sum::State{} : shown.step->after;
  row("edges of Y", fmt::format("{} of {}", state.edges_of_y, shown.merge.y.size()));
  row("edges of −X", fmt::format("{} of {}", state.edges_of_x, shown.merge.x.size()));
  row("differences computed",
      std::to_string(
          shown.step == nullptr
              ? 0
              : std::min(shown.edges() + 1, static_cast<int>(shown.merge.corners.size()))));
  row("differences there are", std::to_string(shown.merge.x.size() * shown.merge.y.size()));
}

}  // namespace

const Block kMerge{
    .name = "merge",
    .meaning = "edges that the Minkowski difference has by now, and differences computed",
    .write = counts,
    .act = "minkowski-sum"};

const Listing kListing{.name = "minkowski-sum",
                       .meaning = "the Minkowski difference, edge by edge (Larsen 1998)",
                       .write = listing,
                       .act = "minkowski-sum"};

}  // namespace gjkscope::sums
