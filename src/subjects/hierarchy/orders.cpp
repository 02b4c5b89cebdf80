// Both orders of children side by side, each as the tree of the pairs that were visited.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "subjects/hierarchy/shown.hpp"

namespace gjkscope::searches {
namespace {

using models::SearchPhase;
using models::SearchStep;

/// A pair that a search visited.
struct Visit {
  models::NodePair pair;
  int parent = -1;  ///< The visit that put it there.
  int depth = 0;
  double first = 0.0;  ///< Pairs without children that lie to the left, and below.
  double count = 0.0;
  bool is_cut = false;
  bool is_better = false;  ///< Its segments lowered δ.
};

/// All visits of a search, in their order. A pair's children are visited before what waited by
/// then, so this is the order of a walk through the tree.
std::vector<Visit> visits_of(const models::SearchTrace& trace) {
  std::vector<Visit> visits;
  double candidate = HUGE_VAL;
  for (const SearchStep& step : trace.steps) {
    if (step.phase == SearchPhase::visit && step.after.phase != SearchPhase::contain)
      visits.push_back({step.after.pair, step.after.pair.from});
    if (step.phase == SearchPhase::bound) visits.back().is_cut = step.record.cut;
    if (step.record.better && step.after.candidate->high < candidate) {
      candidate = step.after.candidate->high;
      visits.back().is_better = true;
    }
  }
  for (std::size_t i = visits.size(); i-- > 0;) {
    visits[i].count = std::max(visits[i].count, 1.0);
    if (visits[i].parent >= 0) visits[visits[i].parent].count += visits[i].count;
  }
  std::vector<double> next(visits.size());
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (visits[i].parent >= 0) {
      const auto parent = static_cast<std::size_t>(visits[i].parent);
      visits[i].depth = visits[parent].depth + 1;
      visits[i].first = next[parent];
      next[parent] += visits[i].count;
    }
    next[i] = visits[i].first;
  }
  return visits;
}

/// One of the two searches, as far as a frame goes.
struct Order {
  Order(const Shown& shown, bool nearer_first)
      : trace(nearer_first ? shown.search.trace : shown.search.left_first),
        visited(shown.is_answer ? trace.result.visits
                                : std::min(shown.state.visits, trace.result.visits)) {
    for (const SearchStep& step : trace.steps) {
      if (step.after.visits > visited || step.phase == SearchPhase::contain) break;
      state = &step.after;
      cuts += step.record.cut ? 1 : 0;
    }
  }

  const models::SearchTrace& trace;
  long visited = 0;
  const models::SearchState* state = nullptr;  ///< None at the start.
  long cuts = 0;

  [[nodiscard]] bool has_ended() const { return visited == trace.result.visits; }
  [[nodiscard]] const models::Nearest* candidate() const {
    return state != nullptr && state->candidate ? &*state->candidate : nullptr;
  }
};

std::string_view order_name(bool nearer_first) {
  return nearer_first ? "nearer child first" : "left child first";
}

std::string delta(const Order& order, const Numbers& numbers) {
  return order.candidate() != nullptr ? numbers(order.candidate()->high) : "∞";
}

Mark better_mark(const Point& at, double radius) { return {"tree.better", Disk{at, radius}}; }

constexpr AskInfo kAskNextPair{
    "next-pair", "which pair that waits is visited next, the nearer child first", "after visit"};
constexpr AskInfo kAskFewer{"fewer", "which order of children needs fewer visits", "after visit"};
constexpr std::array kAsks = {kAskNextPair, kAskFewer};

bool asks_for_next(const SceneBuilder& scene) {
  return scene.frame.question >= 0 && scene.run.asked(scene.frame).ask == kAskNextPair.name;
}
Subject subject_of(const models::NodePair& pair) {
  return {Subject::Kind::tree_node, pair.a, pair.b};
}

/// The pairs that wait, as a question numbers them: multiples of the golden ratio say where that
/// begins, so that no number is often the next one's.
std::vector<models::NodePair> numbered(const models::SearchState& state) {
  constexpr long kWhole = 65536;
  constexpr long kGolden = 40503;  // of it
  std::vector<models::NodePair> pairs = state.waiting;
  const long part = (state.visits + 1) * kGolden % kWhole;
  std::rotate(pairs.begin(), pairs.begin() + part * std::ssize(pairs) / kWhole, pairs.end());
  return pairs;
}

/// The number of a pair that waits, beside it.
void number(SceneBuilder& scene, const models::SearchState& state, const models::NodePair& pair,
            const Point& at) {
  const std::vector<models::NodePair> pairs = numbered(state);
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const models::NodePair& each) {
    return each.a == pair.a && each.b == pair.b;
  });
  scene.out.marks.push_back(
      {"strong", Text{at + Point(kNodeRadius + 5.0, 5.0), std::to_string(found - pairs.begin() + 1),
                      type::kStrong}});
}

void draw_order(SceneBuilder& scene, const Order& order, bool nearer_first, const Rect& area,
                double leaves, int depth) {
  const std::vector<Visit> visits = visits_of(order.trace);
  const auto place = [&](const Visit& visit) {
    const double along = (visit.first + 0.5 * visit.count) / leaves;
    return Point(area.min + Point(along * area.size().x(),
                                  area.size().y() * visit.depth / std::max(depth, 1)));
  };
  const double radius = std::clamp(0.45 * area.size().x() / leaves, 2.0, kNodeRadius);
  const auto visited = static_cast<std::size_t>(order.visited);
  const auto is_there = [&](std::size_t i) {
    return i < visited || static_cast<std::size_t>(visits[i].parent) < visited;
  };
  for (std::size_t i = 1; i < visits.size(); ++i) {
    if (!is_there(i)) continue;
    const Visit& parent = visits[visits[i].parent];
    scene.out.marks.push_back({"tree.link", Polyline{{place(parent), place(visits[i])}}});
  }
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (i > 0 && !is_there(i)) continue;
    const Point at = place(visits[i]);
    const bool is_current = i + 1 == visited && !order.has_ended();
    scene.out.marks.push_back(is_current            ? current_mark(at, visits[i].is_cut)
                              : i >= visited        ? node_mark(NodeState::waiting, at, radius)
                              : visits[i].is_cut    ? node_mark(NodeState::cut, at, radius)
                              : visits[i].is_better ? better_mark(at, radius)
                                                    : node_mark(NodeState::visited, at, radius));
    if (!nearer_first) continue;
    scene.out.marks.back().subject = subject_of(visits[i].pair);
    if (i >= visited && order.state != nullptr && asks_for_next(scene))
      number(scene, *order.state, visits[i].pair, at);
  }
  scene.out.marks.push_back({"strong", Text{{area.min.x(), area.min.y() - 13.0},
                                            std::string(order_name(nearer_first)),
                                            type::kStrong}});
  scene.out.marks.push_back({"body.muted", Text{{area.max.x(), area.min.y() - 13.0},
                                                fmt::format("{} visits", order.visited),
                                                type::kBody,
                                                Align::right}});
}

bool fill_orders(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot) return false;
  const Shown& shown = shown_in<Shown>(scene);
  if (shown.is_refused()) return true;
  const std::array<Order, 2> orders = {Order(shown, true), Order(shown, false)};
  double leaves = 1.0;
  int depth = 0;
  for (const Order& order : orders) {
    const std::vector<Visit> visits = visits_of(order.trace);
    leaves = std::max(leaves, visits.front().count);
    for (const Visit& visit : visits) depth = std::max(depth, visit.depth);
  }
  const std::array<Rect, 2> areas = tree_areas(scene.map.area());
  draw_order(scene, orders[0], true, areas[0], leaves, depth);
  draw_order(scene, orders[1], false, areas[1], leaves, depth);
  constexpr std::array<KeyEntry, 5> kEntries = {
      {{[](const Point& at) { return current_mark(at); }, "last visit"},
       {[](const Point& at) { return node_mark(NodeState::waiting, at, kNodeRadius); }, "waits"},
       {[](const Point& at) { return better_mark(at, kNodeRadius); }, "lower δ"},
       {[](const Point& at) { return node_mark(NodeState::visited, at, kNodeRadius); }, "visited"},
       {[](const Point& at) { return node_mark(NodeState::cut, at, kNodeRadius); }, "cut"}}};
  key(scene, fonts, kEntries);
  return true;
}

std::string orders_title(const LessonRun& run) {
  return trees_of(run.lesson).volumes == VolumeKind::boxes ? "Pairs of boxes, as visited"
                                                           : "Pairs of circles, as visited";
}

/// The candidates of both searches; once they are the same one of them is enough.
void candidates(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (shown.is_refused()) return;
  const Order nearer(shown, true);
  const Order left(shown, false);
  const models::Nearest* best = nearer.candidate();
  const models::Nearest* other = left.candidate();
  if (other != nullptr && (best == nullptr || *best != *other))
    shortest_line(scene, shown.search, *other, "gap.answer", "left", "left: ");
  if (best != nullptr)
    shortest_line(scene, shown.search, *best, "closest.line", "nearer",
                  shown.is_answer ? "" : "nearer: ");
}

void add_order_frames(LessonRun& run, int index) {
  constexpr long kMostFrames = 6;
  const auto add = [&](int over) { run.frames.push_back({.run = index, .step = over - 1}); };
  const models::SearchTrace& trace = search_trace(run, index)->trace;
  add(0);
  const long stride = 1 + trace.result.visits / kMostFrames;
  for (int i = 0; i < static_cast<int>(trace.steps.size()); ++i) {
    const SearchStep& step = trace.steps[i];
    const long visits = step.after.visits;
    const bool is_asked = run.lesson.asks(kAskNextPair.name, visits) ||
                          run.lesson.asks(kAskNextPair.name, visits - 1);
    if (ends_visit(step) && (visits % stride == 0 || is_asked)) add(i + 1);
  }
  if (!trace.steps.empty()) add(static_cast<int>(trace.steps.size()) + 1);
}

/// The visit after those of the frame before, or the end of both searches.
int order_answer(const LessonRun& run, const Frame& before, const Frame& frame,
                 const LessonQuestion& question) {
  const Shown shown(run, before);
  const Shown after(run, frame);
  if (shown.is_refused()) return -1;
  const auto visits = static_cast<int>(shown.state.visits);
  if (question.ask == kAskFewer.name)
    return after.is_answer && question.at.value_or(visits) == visits ? after.over - 1 : -1;
  const bool answers = !after.is_answer && after.state.visits == visits + 1 &&
                       shown.state.waiting.size() > 1 && question.at.value_or(visits) == visits;
  return answers ? after.over - 1 : -1;
}

void order_question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  FrameQuestion& asked = text.question.emplace();
  asked.ask = story.run.asked(story.frame).ask;
  if (asked.ask == kAskFewer.name) {
    const long nearer = shown.search.trace.result.visits;
    const long left = shown.search.left_first.result.visits;
    asked.choices = {std::string(order_name(true)), std::string(order_name(false)), "as many"};
    asked.answer = asked.choices[nearer < left ? 0 : nearer > left ? 1 : 2];
    text.caption = "Question: which order of children ends after fewer visits?";
    return;
  }
  const models::NodePair& next = shown.state.waiting.back();
  for (const models::NodePair& pair : numbered(shown.state)) {
    asked.choices.push_back(fmt::format("pair {}", asked.choices.size() + 1));
    asked.subjects.push_back(subject_of(pair));
    if (pair.a == next.a && pair.b == next.b) asked.answer = asked.choices.back();
  }
  asked.refuted = "The search visits what came last, its nearer child on top: so it goes deep.";
  text.caption =
      "Question: above, the nearer child first: which pair that waits is visited next? Point at "
      "it.";
}

std::string order_position(const LessonRun& run, int index) {
  const Shown shown(run, run.frames[index]);
  if (shown.step == nullptr) return "start";
  return shown.is_answer ? "answer" : fmt::format("after {} visits", shown.state.visits);
}

Tick order_tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (shown.step == nullptr)
    return {.group = group_of_position(run, frame, "start"), .label = "start"};
  if (shown.is_answer)
    return {.group = group_of_position(run, frame, "answer"), .label = "answer", .event = true};
  return {.group = group_of_position(run, frame, "visits"),
          .label = std::to_string(shown.state.visits)};
}

void tell_orders(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  if (shown.is_refused()) return words(story, text);
  const Order nearer(shown, true);
  const Order left(shown, false);
  if (shown.is_answer) {
    text.caption =
        fmt::format("Nearer first needs {} visits, left first {}: both say {}.", nearer.visited,
                    left.visited, story.numbers(shown.search.trace.result.answer.distance));
    text.detail =
        fmt::format("They measured {} and {} of {} pairs of segments.",
                    nearer.trace.result.measured, left.trace.result.measured, shown.search.pairs());
  } else if (shown.step == nullptr) {
    text.caption = fmt::format("Which of two pairs of {} that wait comes first?", shown.volumes());
    text.detail =
        "Any order gives the true distance. But δ falls sooner when the nearer pair comes first.";
  } else {
    text.caption =
        fmt::format("After {} visits: nearer first has δ = {}, left first δ = {}.",
                    shown.state.visits, delta(nearer, story.numbers), delta(left, story.numbers));
    text.detail =
        nearer.cuts + left.cuts == 0
            ? fmt::format("Nothing was cut yet: {} are cut that are farther apart than δ.",
                          shown.volumes())
            : fmt::format(
                  "A smaller δ cuts more: by now nearer first has cut {} pair{} of {}, left "
                  "first {}.",
                  nearer.cuts, nearer.cuts == 1 ? "" : "s", shown.volumes(), left.cuts);
  }
}

void order_counters(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  if (shown.is_refused()) return panel.heading("Refused");
  const std::array<Order, 2> orders = {Order(shown, true), Order(shown, false)};
  const double second = panel.right;
  const double first = panel.right - 96.0;
  const auto row = [&](const std::string& what, const auto& value, bool is_heading = false) {
    panel.write(is_heading ? "heading" : "body.muted", panel.left, what,
                is_heading ? type::kHeading : type::kBody);
    panel.write(is_heading ? "heading" : "code.current", first, value(orders[0]),
                is_heading ? type::kHeading : type::kCode, Align::right);
    panel.write(is_heading ? "heading" : "code.current", second, value(orders[1]),
                is_heading ? type::kHeading : type::kCode, Align::right);
    panel.y += rows::kRow;
  };
  row(
      "Which child first?",
      [&](const Order& order) { return &order == &orders[0] ? "nearer" : "left"; }, true);
  row("pairs visited", [](const Order& order) { return std::to_string(order.visited); });
  row("pairs cut", [](const Order& order) { return std::to_string(order.cuts); });
  row("pairs that wait", [](const Order& order) {
    if (order.has_ended()) return std::string("0");
    return std::to_string(order.state == nullptr ? 1 : order.state->waiting.size());
  });
  row("pairs of segments measured", [](const Order& order) {
    return std::to_string(order.state != nullptr ? order.state->measured : 0);
  });
  row("candidate δ", [&](const Order& order) { return delta(order, panel.numbers); });
  row("", [](const Order& order) { return order.has_ended() ? "done" : ""; });
}

}  // namespace

const Block kOrderCounters{.name = "order-counters",
                           .meaning = "visits, cuts and candidates of both orders of children",
                           .write = order_counters,
                           .tour = "hierarchy-orders"};

const Tour kOrders{
    .name = "hierarchy-orders",
    .meaning =
        "number of visits of two searches for the distance, of which one takes the "
        "nearer child first and one the left one; then the answer",
    .needs = {.settings = &LessonTrees::kKind,
              .settings_are_optional = true,
              .why_no_until = "frames show how both searches end"},
    .add_frames = add_order_frames,
    .asks = kAsks,
    .answering_step = order_answer,
    .algorithm = &kHierarchyDistance,
    .position = order_position,
    .tick = order_tick,
    .words = tell_orders,
    .stage = candidates,
    .question = order_question,
    .values = values,
    .fill = fill_orders,
    .plot_title = orders_title,
};

}  // namespace gjkscope::searches
