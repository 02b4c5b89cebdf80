#include <fmt/format.h>

#include "subjects/hierarchy/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::searches {
namespace {

using models::SearchPhase;

/// Larsen 1998, "Hierarchical Collision Detection".
void collide_listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const bool leaf = shown.is(SearchPhase::leaf);
  const bool into_a = shown.is(SearchPhase::descend) && !shown.step->record.takes_b_apart;
  const bool into_b = shown.is(SearchPhase::descend) && shown.step->record.takes_b_apart;
  blocks::listing_line(panel, "collide(a, b)", shown.is(SearchPhase::visit));
  blocks::listing_line(panel, "  if a, b do not meet: return", shown.is_cut());
  blocks::listing_line(panel, "  if a and b are leaves", false);
  blocks::listing_line(
      panel, "    test their segments", leaf,
      leaf && shown.step->record.measured && shown.step->record.measured->meet ? "meet" : "no");
  blocks::listing_line(panel, "  else if a is no leaf", false);
  blocks::listing_line(panel, "    collide(left(a), b)", into_a);
  blocks::listing_line(panel, "    collide(right(a), b)", into_a);
  blocks::listing_line(panel, "  else", false);
  blocks::listing_line(panel, "    collide(a, left(b))", into_b);
  blocks::listing_line(panel, "    collide(a, right(b))", into_b);
}

/// Larsen 1998, "Hierarchical Distance Computation".
void distance_listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const bool leaf = shown.is(SearchPhase::leaf);
  const bool descends = shown.is(SearchPhase::descend);
  const bool nearer = leaf && shown.step->record.better && !shown.is_tie();
  blocks::listing_line(panel,
                       shown.search.options.remembered ? "δ ← that of the last pair" : "δ ← ∞",
                       shown.step == nullptr);
  blocks::listing_line(panel, "closest(a, b)", shown.is(SearchPhase::visit));
  blocks::listing_line(panel, "  if distance of a, b > δ: return", shown.is_cut());
  blocks::listing_line(panel, "  if a and b are leaves", false);
  if (shown.has_tiles())
    blocks::listing_line(panel, "    if in the table: return", leaf && shown.step->record.hit);
  blocks::listing_line(panel, "    measure their segments",
                       leaf && !nearer && !shown.step->record.hit);
  blocks::listing_line(panel, "    if nearer: δ ← that", nearer);
  blocks::listing_line(panel, "  else for both children c of the", false);
  blocks::listing_line(panel, "  larger, the nearer one first", descends);
  blocks::listing_line(panel, "    closest(c, the other)", descends);
}

void counters(PanelBuilder& panel, const Shown& shown) {
  panel.heading("Search");
  if (shown.is_refused())
    return panel.row("refused", words_of(*shown.search.refusal, shown.lesson));
  const auto count = [](long value) { return grouped(static_cast<double>(value)); };
  panel.row(fmt::format("pairs of {} visited", shown.volumes()), count(shown.state.visits));
  panel.row("pairs that wait", count(static_cast<long>(shown.state.waiting.size())));
  panel.row("pairs of segments tested",
            fmt::format("{} of {}", count(shown.state.measured), count(shown.search.pairs())));
}

void collide_counters(PanelBuilder& panel) { counters(panel, Shown(panel.run, panel.frame)); }

/// The other order only where the search has ended: what it costs is the point of the end.
void distance_counters(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  counters(panel, shown);
  if (shown.is_refused()) return;
  panel.row("candidate δ",
            shown.state.candidate ? panel.numbers(shown.state.candidate->high) : "∞");
  if (shown.has_tiles())
    return panel.row("pairs looked up", grouped(static_cast<double>(shown.state.hits)));
  const models::SearchResult& other = shown.search.left_first.result;
  panel.row("visits with the left child first",
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
