#include "picture/blocks/blocks.hpp"

#include <fmt/format.h>

#include "algorithms/hierarchy/pictures/shown.hpp"

namespace gjkscope::searches {
namespace {

using blocks::LineView;
using models::SearchPhase;
using namespace rows;

void write(PanelBuilder& panel, const std::string& text, bool current, std::string value = {}) {
  LineView line{current ? LineView::State::current : LineView::State::idle};
  if (current) line.value = std::move(value);
  blocks::write_line(panel, text, line);
  panel.y += kTightRow - kRow;
}

/// Larsen 1998, "Hierarchical Collision Detection".
void collide_listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const bool leaf = shown.is(SearchPhase::leaf);
  const bool into_a = shown.is(SearchPhase::descend) && !shown.step->record.takes_b_apart;
  const bool into_b = shown.is(SearchPhase::descend) && shown.step->record.takes_b_apart;
  write(panel, "collide(a, b)", shown.is(SearchPhase::visit));
  write(panel, "  if a, b do not meet: return", shown.is_cut());
  write(panel, "  if a and b are leaves", false);
  write(panel, "    test their segments", leaf,
        leaf && shown.step->record.measured && shown.step->record.measured->meet ? "meet" : "no");
  write(panel, "  else if a is no leaf", false);
  write(panel, "    collide(left(a), b)", into_a);
  write(panel, "    collide(right(a), b)", into_a);
  write(panel, "  else", false);
  write(panel, "    collide(a, left(b))", into_b);
  write(panel, "    collide(a, right(b))", into_b);
}

/// Larsen 1998, "Hierarchical Distance Computation".
void distance_listing(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const bool leaf = shown.is(SearchPhase::leaf);
  const bool descends = shown.is(SearchPhase::descend);
  write(panel, shown.search.options.remembered ? "δ ← that of the last pair" : "δ ← ∞",
        shown.step == nullptr);
  write(panel, "closest(a, b)", shown.is(SearchPhase::visit));
  write(panel, "  if distance of a, b > δ: return", shown.is_cut());
  write(panel, "  if a and b are leaves", false);
  if (shown.has_tiles())
    write(panel, "    if in the table: return", leaf && shown.step->record.hit);
  write(panel, "    measure their segments",
        leaf && !shown.step->record.better && !shown.step->record.hit);
  write(panel, "    if nearer: δ ← that", leaf && shown.step->record.better);
  write(panel, "  else for both children c of the", false);
  write(panel, "  larger, the nearer one first", descends);
  write(panel, "    closest(c, the other)", descends);
}

void row(PanelBuilder& panel, const std::string& what, const std::string& value) {
  panel.write("body.muted", panel.left, what, type::kBody);
  panel.write("code.current", panel.right, value, type::kCode, Align::right);
  panel.y += kRow;
}

void counters(PanelBuilder& panel, const Shown& shown) {
  panel.heading("Search");
  if (shown.is_refused())
    return row(panel, "refused", words_of(*shown.search.refusal, shown.lesson));
  const auto count = [](long value) { return grouped(static_cast<double>(value)); };
  row(panel, fmt::format("pairs of {} visited", shown.volumes()), count(shown.state.visits));
  row(panel, "pairs that wait", count(static_cast<long>(shown.state.waiting.size())));
  row(panel, "pairs of segments tested",
      fmt::format("{} of {}", count(shown.state.measured), count(shown.search.pairs())));
}

void collide_counters(PanelBuilder& panel) { counters(panel, Shown(panel.run, panel.frame)); }

/// The other order only where the search has ended: what it costs is the point of the end.
void distance_counters(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  counters(panel, shown);
  if (shown.is_refused()) return;
  row(panel, "candidate δ",
      shown.state.candidate ? panel.numbers(shown.state.candidate->high) : "∞");
  if (shown.has_tiles())
    return row(panel, "pairs looked up", grouped(static_cast<double>(shown.state.hits)));
  const models::SearchResult& other = shown.search.left_first.result;
  row(panel, "visits with the left child first",
      shown.is_answer ? grouped(static_cast<double>(other.visits)) : "–");
}

}  // namespace

const Block kCollideCounters{.name = "collide-counters",
                             .meaning =
                                 "pairs of volumes visited and waiting, and pairs of segments "
                                 "tested for a meeting",
                             .write = collide_counters,
                             .act = "hierarchy-collide"};

const Block kDistanceCounters{.name = "distance-counters",
                              .meaning =
                                  "pairs of volumes visited and waiting, pairs of segments "
                                  "measured, the candidate, and what the other order costs",
                              .write = distance_counters,
                              .act = "hierarchy-distance"};

const Listing kCollideListing{.name = "collide",
                              .meaning = "Recursive-Collide on two trees of volumes (Larsen 1998)",
                              .write = collide_listing,
                              .act = "hierarchy-collide"};

const Listing kDistanceListing{.name = "distance",
                               .meaning = "the distance by two trees of volumes (Larsen 1998)",
                               .write = distance_listing,
                               .act = "hierarchy-distance"};

}  // namespace gjkscope::searches
