#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

void counters(PanelBuilder& panel, const Shown& shown, bool has_room = true) {
  panel.heading("Search");
  if (shown.is_refused())
    return panel.row("refused", words_of(*shown.search.refusal, shown.lesson));
  const auto count = [](long value) { return grouped(static_cast<double>(value)); };
  panel.row(fmt::format("pairs of {} visited", shown.volumes()), count(shown.state.visits));
  if (has_room) panel.row("pairs that wait", count(static_cast<long>(shown.state.waiting.size())));
  const bool hides_pairs =
      shown.lesson.asks(kAskPairs.name) && !is_known(panel.run, panel.frame, Extra::pairs);
  panel.row("pairs of segments tested",
            fmt::format("{} of {}", count(shown.state.measured),
                        hides_pairs ? "?" : count(shown.search.pairs())));
}

void collide_counters(PanelBuilder& panel) { counters(panel, Shown(panel.run, panel.frame)); }

void candidate(PanelBuilder& panel, const Shown& shown) {
  panel.row("candidate δ",
            shown.state.candidate ? panel.numbers(shown.state.candidate->high) : "∞");
}

/// The other order only where the search has ended: what it costs is the point of the end.
void distance_counters(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  counters(panel, shown);
  if (shown.is_refused()) return;
  candidate(panel, shown);
  if (shown.has_tiles())
    return panel.row("pairs looked up", grouped(static_cast<double>(shown.state.hits)));
  const models::SearchResult& other = shown.search.left_first.result;
  panel.row("visits with the left child first",
            shown.is_answer ? grouped(static_cast<double>(other.visits)) : "–");
}

std::string operations(int count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Tests of the boxes that are visited, but where a question asks for them; at the end the visits
/// of a search that makes the first test alone.
void box_tests(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  counters(panel, shown, false);
  if (shown.is_refused()) return;
  candidate(panel, shown);
  if (shown.is_answer)
    return panel.row("visits of collide",
                     grouped(static_cast<double>(shown.search.collide.result.visits)));
  const bool has_boxes = shown.has_pair() && !shown.is(SearchPhase::visit) &&
                         std::holds_alternative<models::Box>(shown.node(true).volume);
  BoxTests tests;
  if (has_boxes)
    tests = tests_of(std::get<models::Box>(shown.node(true).volume),
                     std::get<models::Box>(shown.node(false).volume));
  panel.row("meet? a.high < b.low, …", has_boxes ? operations(tests.meet, "comparison") : "–");
  panel.row("far? √(dx · dx + dy · dy)", has_boxes ? operations(tests.distance, "operation") : "–");
}

/// The pairs of segments that were measured: the newest ones, as many as there is room for.
void table(PanelBuilder& panel) {
  constexpr std::size_t kMost = 2;
  const Shown& shown = shown_in<Shown>(panel);
  counters(panel, shown, false);
  if (shown.is_refused()) return;
  panel.row("pairs looked up", grouped(static_cast<double>(shown.state.hits)));
  std::vector<std::pair<std::string, double>> kept;
  const int steps = std::min(shown.over, static_cast<int>(shown.search.trace.steps.size()));
  for (int i = 0; i < steps; ++i) {
    const models::SearchStep& step = shown.search.trace.steps[i];
    if (step.phase != SearchPhase::leaf || step.record.hit) continue;
    kept.emplace_back(
        fmt::format("in the table: {}, {}", segment_name(shown, true, step.record.segments.first),
                    segment_name(shown, false, step.record.segments.second)),
        step.record.measured->high);
  }
  if (kept.empty()) panel.row("in the table", "no pair yet");
  for (std::size_t i = kept.size() > kMost ? kept.size() - kMost : 0; i < kept.size(); ++i)
    panel.row(kept[i].first, panel.numbers(kept[i].second));
}

}  // namespace

const Block kBoxTests{.name = "box-tests",
                      .meaning =
                          "pairs visited and measured, the candidate, and what it takes to tell "
                          "whether two boxes meet, and how far apart they are",
                      .write = box_tests,
                      .tour = "hierarchy-distance"};

const Block kTable{
    .name = "pair-table",
    .meaning = "pairs visited, measured and looked up, and the table of those measured",
    .write = table,
    .tour = "hierarchy-distance"};

const Block kCollideCounters{.name = "collide-counters",
                             .meaning =
                                 "pairs of volumes visited and waiting, and pairs of segments "
                                 "tested for a meeting",
                             .write = collide_counters,
                             .tour = "hierarchy-collide"};

const Block kDistanceCounters{.name = "distance-counters",
                              .meaning =
                                  "pairs of volumes visited and waiting, pairs of segments "
                                  "measured, the candidate, and what the other order costs",
                              .write = distance_counters,
                              .tour = "hierarchy-distance"};

const Listing kCollideListing{.name = "collide",
                              .meaning = "Recursive-Collide on two trees of volumes (Larsen 1998)",
                              .write = collide_listing,
                              .tour = "hierarchy-collide"};

const Listing kDistanceListing{.name = "distance",
                               .meaning = "the distance by two trees of volumes (Larsen 1998)",
                               .write = distance_listing,
                               .tour = "hierarchy-distance"};

}  // namespace gjkscope::searches
