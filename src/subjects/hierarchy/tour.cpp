#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gjk/vector.hpp"
#include "subjects/hierarchy/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::searches {

using models::SearchPhase;
using models::SearchStep;

Shown::Shown(const LessonRun& run, const Frame& frame)
    : lesson(run.lesson),
      search(*search_trace(run, frame.run)),
      over(frame.step + 1),
      step(last_step_over(search.trace.steps, frame)),
      state(step == nullptr ? search.trace.start : step->after),
      is_answer(over > static_cast<int>(search.trace.steps.size())) {}

std::string_view Shown::volumes() const {
  return trees_of(lesson).volumes == VolumeKind::boxes ? "boxes" : "circles";
}

std::string_view Shown::volume() const {
  return trees_of(lesson).volumes == VolumeKind::boxes ? "box" : "circle";
}

std::vector<NodeState> Shown::node_states(bool of_x) const {
  const std::vector<TreeNode>& tree = search.tree(of_x);
  std::vector<NodeState> states(tree.size(), NodeState::off);
  const auto state_of = [&](const models::NodePair& pair) -> NodeState& {
    return states[of_x ? pair.a : pair.b];
  };
  const int steps = std::min(over, static_cast<int>(search.trace.steps.size()));
  for (int i = 0; i < steps; ++i) {
    const SearchStep& each = search.trace.steps[i];
    if (each.phase != SearchPhase::bound) continue;
    NodeState& mark = state_of(each.after.pair);
    if (mark != NodeState::visited) mark = each.record.cut ? NodeState::cut : NodeState::visited;
  }
  for (const models::NodePair& pair : state.waiting) state_of(pair) = NodeState::waiting;
  // The pair that is visited has children to come until it is cut or measured.
  const bool is_open =
      has_pair() && (is(SearchPhase::visit) || is(SearchPhase::bound)) && !is_cut();
  if (is_open) state_of(state.pair) = NodeState::waiting;
  std::vector<bool> is_reachable(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const bool below = tree[i].parent >= 0 && is_reachable[tree[i].parent];
    is_reachable[i] = below || states[i] == NodeState::waiting;
    if (below && states[i] == NodeState::off) states[i] = NodeState::ahead;
  }
  return states;
}

std::optional<Halves> Shown::halves() const {
  if (!is(SearchPhase::descend) && !(is(SearchPhase::visit) && state.visits > 1))
    return std::nullopt;
  const SearchStep& made = is(SearchPhase::descend) ? *step : *(step - 1);
  if (made.phase != SearchPhase::descend) return std::nullopt;
  const auto& [first, second] = made.record.children;
  Halves out{!made.record.takes_b_apart, first, second};
  const std::vector<TreeNode>& tree = search.tree(out.of_x);
  const int whole = tree[out.node(true)].parent;
  out.is_left_first = tree[whole].left == out.node(true);
  if (!out.is_left_first) std::swap(out.left, out.right);
  return out;
}

std::optional<Extra> extra_of(const LessonRun& run, const Frame& frame) {
  if (frame.question >= 0) {
    const std::string& ask = run.asked(frame).ask;
    for (std::size_t i = 0; i < kExtraAsks.size(); ++i) {
      if (kExtraAsks[i]->name == ask) return static_cast<Extra>(i);
    }
  }
  return frame.part < 0 ? std::nullopt : std::optional(static_cast<Extra>(frame.part));
}

bool is_known(const LessonRun& run, const Frame& frame, Extra extra) {
  if (frame.question >= 0 &&
      run.asked(frame).ask == kExtraAsks[static_cast<std::size_t>(extra)]->name)
    return false;
  const bool is_at_end = extra >= Extra::tile_size;
  if (is_at_end) return frame.part >= static_cast<int>(extra);
  return frame.step >= 0 || frame.part >= static_cast<int>(extra);
}

NodeOnPath node_on_path(const std::vector<TreeNode>& tree) {
  NodeOnPath out{0, {0}};
  while (!tree[out.path.back()].is_leaf()) {
    const TreeNode& node = tree[out.path.back()];
    const bool left_is_larger = tree[node.left].count > tree[node.right].count;
    out.path.push_back(left_is_larger ? node.left : node.right);
  }
  out.node = out.path[std::min<std::size_t>(2, out.path.size() - 1)];
  return out;
}

TiledSegment longest_segment(const Shown& shown) {
  TiledSegment out;
  const std::vector<models::Segment>& segments = shown.search.x.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Eigen::Vector2d difference = segments[i].b - segments[i].a;
    const double length = gjk::length(difference);
    if (length > out.length) out = {static_cast<int>(i), length, {}};
  }
  const std::vector<TreeNode>& tree = shown.search.tree_x;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (tree[i].is_leaf() && shown.search.segments_x[tree[i].first] == out.segment)
      out.leaves.push_back(static_cast<int>(i));
  }
  return out;
}

SplitOfTiles split_of(const std::vector<TreeNode>& tree, int node) {
  SplitOfTiles out;
  std::array<std::vector<double>, 2> places;
  const int middle = tree[tree[node].right].first;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const bool is_below =
        tree[i].first >= tree[node].first && tree[i].first < tree[node].first + tree[node].count;
    if (!tree[i].is_leaf() || !is_below) continue;
    out.leaves[tree[i].first < middle ? 0 : 1].push_back(static_cast<int>(i));
    const Eigen::Vector2d& center = std::get<models::Circle>(tree[i].volume).center;
    for (const int axis : {0, 1}) places[axis].push_back(center[axis]);
  }
  for (const int axis : {0, 1}) {
    std::vector<double>& along = places[axis];
    std::sort(along.begin(), along.end());
    const std::size_t half = along.size() / 2;
    out.spread[axis] = along.back() - along.front();
    out.middle[axis] = 0.5 * (along[half - 1] + along[half]);
  }
  return out;
}

std::string segment_name(const Shown& shown, bool of_x, int index) {
  const models::Segment& segment = shown.search.model(of_x).segments[index];
  const LessonShape& shape = of_x ? shown.lesson.x() : shown.lesson.y();
  const VertexRange range = shape.ranges()[segment.outline];
  const auto name = [&](int i) { return shape.vertex_names[range.first + i % range.count]; };
  return name(segment.index) + name(segment.index + 1);
}

namespace {

/// A number that counts what is done with it.
struct Counted {
  double value = 0.0;
  int* count = nullptr;
  friend bool operator<(const Counted& a, const Counted& b) {
    ++*a.count;
    return a.value < b.value;
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    ++*a.count;
    return {a.value - b.value, a.count};
  }
  friend Counted operator+(const Counted& a, const Counted& b) {
    ++*a.count;
    return {a.value + b.value, a.count};
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    ++*a.count;
    return {a.value * b.value, a.count};
  }
  friend Counted root(const Counted& a) {
    ++*a.count;
    return {std::sqrt(a.value), a.count};
  }
};

}  // namespace

BoxTests tests_of(const models::Box& a, const models::Box& b) {
  BoxTests out;
  int* count = &out.meet;
  const auto low = [&](const models::Box& box, int axis) { return Counted{box.low[axis], count}; };
  const auto high = [&](const models::Box& box, int axis) {
    return Counted{box.high[axis], count};
  };
  for (const int axis : {0, 1}) {
    if (high(a, axis) < low(b, axis) || high(b, axis) < low(a, axis)) break;
  }
  count = &out.distance;
  const auto gap = [&](int axis) {
    return std::max(std::max(low(b, axis) - high(a, axis), low(a, axis) - high(b, axis)),
                    Counted{0.0, count});
  };
  const Counted x = gap(0);
  const Counted y = gap(1);
  root(x * x + y * y);
  return out;
}

bool ends_visit(const SearchStep& step) {
  return step.phase == SearchPhase::leaf || step.phase == SearchPhase::descend ||
         (step.phase == SearchPhase::bound && step.record.cut);
}

namespace {

constexpr std::array kCollideAsks = {kAskDescend, kAskHalf, kAskPieces, kAskPairs, kAskNode};
constexpr std::array kDistanceAsks = {kAskWin,      kAskTable,     kAskHalf,   kAskTiles,
                                      kAskSplit,    kAskFirstLeaf, kAskDearer, kAskGap,
                                      kAskTileSize, kAskVolume,    kAskWider};

/// Whether a question may be about this visit: then it has a frame of its own, before what comes of
/// it. Thus has the first.
bool is_introduced(const Lesson& lesson, long visit) {
  constexpr std::array kOfVisits = {&kAskDescend,   &kAskWin,    &kAskTable, &kAskHalf,
                                    &kAskFirstLeaf, &kAskDearer, &kAskGap};
  return visit == 1 || std::any_of(kOfVisits.begin(), kOfVisits.end(), [&](const AskInfo* ask) {
           return lesson.asks(ask->name, visit);
         });
}

/// The visit that ends with step `i` comes to the same as the next one, whose frame tells of both.
bool is_explained_with_the_next(const Lesson& lesson, const std::vector<SearchStep>& steps,
                                std::size_t i) {
  const auto next = std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(i) + 1, steps.end(),
                                 [](const SearchStep& step) { return ends_visit(step); });
  const auto is_same_again = [&](const SearchStep& step) {
    return step.phase == steps[i].phase && !step.record.better && !step.record.hit &&
           !is_introduced(lesson, step.after.visits);
  };
  return is_same_again(steps[i]) && next != steps.end() && is_same_again(*next);
}

/// A frame for the start, one for what comes of each visit, or of several in a row that come to the
/// same, one for what follows them; of a long search those alone that find a better candidate or
/// are the first that are looked up, and some in between.
void add_frames(LessonRun& run, int index) {
  constexpr long kBetween = 8;
  constexpr long kMostHits = 2;
  const auto add = [&](int over, int part = -1) {
    run.frames.push_back({.run = index, .step = over - 1, .part = part});
  };
  const models::SearchTrace& trace = search_trace(run, index)->trace;
  add(0);
  if (trace.steps.empty()) return;
  const auto add_extra = [&](int over, Extra extra) {
    const auto part = static_cast<std::size_t>(extra);
    const bool fits = extra < Extra::tiles || trees_of(run.lesson).volumes == VolumeKind::tiles;
    if (index == 0 && fits && run.lesson.asks(kExtraAsks[part]->name))
      add(over, static_cast<int>(part));
  };
  for (const Extra extra : {Extra::pieces, Extra::pairs, Extra::node, Extra::tiles, Extra::split})
    add_extra(0, extra);
  const long visits = trace.result.visits;
  const bool is_long = visits > kMostVisits;
  for (int i = 0; i < static_cast<int>(trace.steps.size()); ++i) {
    const SearchStep& step = trace.steps[i];
    const long visit = step.after.visits;
    const bool begins_visit =
        step.phase == SearchPhase::visit && step.after.phase != SearchPhase::contain;
    const bool is_new_hit = step.record.hit && step.after.hits <= kMostHits;
    const bool is_between = is_long && visit % (visits / kBetween) != 0 && !step.record.better &&
                            !is_new_hit && !run.lesson.asks(kAskHalf.name, visit + 1);
    const bool is_explained_later =
        !is_long &&
        is_explained_with_the_next(run.lesson, trace.steps, static_cast<std::size_t>(i));
    if (step.phase == SearchPhase::contain || (begins_visit && is_introduced(run.lesson, visit)) ||
        (ends_visit(step) && !is_between && !is_explained_later))
      add(i + 1);
  }
  const int over = static_cast<int>(trace.steps.size()) + 1;
  add(over);
  for (const Extra extra : {Extra::tile_size, Extra::volume}) add_extra(over, extra);
}

/// Both halves are drawn as nodes, and for a distance one of them is nearer, as a reader can see.
bool can_ask_about(const Shown& shown, const Halves& halves) {
  constexpr double kSeen = 0.05;  // of the larger distance
  const std::vector<int> depths = depths_of(shown.search.tree(halves.of_x));
  if (depths[halves.node(true)] > kMostDepth) return false;
  const auto [near, far] = std::minmax(halves.left.bound, halves.right.bound);
  return !shown.is_distance() || far - near > kSeen * far;
}

/// Pairs of two leaves are not asked about: they have no children that could be cut.
int answering_step(const LessonRun& run, const Frame& before, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, before);
  if (shown.is_refused()) return -1;
  for (std::size_t i = 0; i < kExtraAsks.size(); ++i) {
    if (question.ask == kExtraAsks[i]->name) return frame.part == static_cast<int>(i) ? 0 : -1;
  }
  if (question.ask == kAskWider.name)
    return !shown.is_answer && frame.part < 0 && Shown(run, frame).is_answer ? frame.step : -1;
  if (question.ask == kAskTable.name) {
    const Shown after(run, frame);
    const bool answers =
        after.is(SearchPhase::leaf) && after.has_tiles() &&
        question.at.value_or(static_cast<int>(after.state.visits)) == after.state.visits;
    return answers ? after.over - 1 : -1;
  }
  if (question.ask == kAskHalf.name) {
    const Shown after(run, frame);
    const std::optional<Halves> halves = after.halves();
    const bool answers =
        shown.is(SearchPhase::descend) && after.is(SearchPhase::visit) && halves &&
        question.at.value_or(static_cast<int>(after.state.visits)) == after.state.visits &&
        can_ask_about(after, *halves);
    return answers ? after.over - 1 : -1;
  }
  if (shown.is_answer || !shown.is(SearchPhase::visit)) return -1;
  if (question.at && *question.at != shown.state.visits) return -1;
  const SearchStep& bound = shown.search.trace.steps[shown.over];
  const bool has_candidate = shown.state.candidate.has_value();
  const bool are_boxes = trees_of(run.lesson).volumes == VolumeKind::boxes;
  const bool is_open = question.ask == kAskFirstLeaf.name
                           ? !has_candidate && shown.state.pair.bound > 0.0
                       : question.ask == kAskDearer.name ? are_boxes
                       : question.ask == kAskGap.name ? !are_boxes && shown.state.pair.bound > 0.0
                       : shown.is_distance()          ? has_candidate
                                                      : !shown.are_leaves();
  return is_open && frame.step >= shown.over && bound.phase == SearchPhase::bound ? shown.over : -1;
}

constexpr std::array<std::string_view, 7> kExtraNames = {
    "pieces?", "all pairs", "a node", "tiles", "halves", "sizes of tiles", "volumes"};

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const Shown shown(run, frame);
  const std::string where = run.runs.size() > 1 ? position_on_path(run, index) + " · " : "";
  const std::optional<Extra> extra = extra_of(run, frame);
  if (extra && frame.part >= 0)
    return where + std::string(kExtraNames[static_cast<std::size_t>(*extra)]);
  if (shown.step == nullptr) return where + "start";
  if (shown.is_answer) return where + "answer";
  if (shown.is(SearchPhase::contain)) return where + "nothing waits";
  if (asks_later(run, index)) return fmt::format("{}visit {}", where, shown.state.visits);
  return fmt::format("{}visit {} of {}", where, shown.state.visits,
                     shown.search.trace.result.visits);
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  const std::string label(frame.part < 0 ? "start" : kExtraNames[frame.part]);
  if (shown.step == nullptr)
    return {.group = group_of_position(run, frame, "start"), .label = label};
  if (shown.is_answer && frame.part >= 0)
    return {.group = group_of_position(run, frame, "answer"), .label = label};
  if (shown.is_answer)
    return {.group = group_of_position(run, frame, "answer"),
            .label = "answer",
            .short_label = "end",
            .event = true};
  const StepInfo at = run.info(frame);
  const std::string group =
      shown.is(SearchPhase::contain) ? "inside?" : fmt::format("visit {}", shown.state.visits);
  return {.group = group_of_position(run, frame, group),
          .label = shown.is_cut() ? "cut" : std::string(at.phase),
          .event = at.is_event};
}

Tour tour_of(std::string_view name, std::string_view meaning, std::span<const AskInfo> asks,
             const Algorithm& algorithm) {
  return {
      .name = name,
      .meaning = meaning,
      .needs = {.settings = &LessonTrees::kKind,
                .settings_are_optional = true,
                .why_no_until = "frames show how the search ends"},
      .add_frames = add_frames,
      .asks = asks,
      .answering_step = answering_step,
      .algorithm = &algorithm,
      .position = position,
      .tick = tick,
      .words = words,
      .stage = stage,
      .question = question,
      .values = values,
      .fill = trees,
      .plot_title = trees_title,
  };
}

const Tour kCollide =
    tour_of("hierarchy-collide",
            "visit of a pair of volumes, in search of segments that meet, and what "
            "comes of it; then the answer",
            kCollideAsks, kHierarchyCollide);
const Tour kDistance =
    tour_of("hierarchy-distance",
            "visit of a pair of volumes, in search of the closest segments, and what "
            "comes of it; then the answer",
            kDistanceAsks, kHierarchyDistance);

}  // namespace
}  // namespace gjkscope::searches

namespace gjkscope {

const SubjectParts subjects::hierarchy{
    .tours = {&searches::kCollide, &searches::kDistance, &searches::kOrders},
    .blocks = {&searches::kCollideCounters, &searches::kDistanceCounters, &searches::kBoxTests,
               &searches::kTable, &searches::kOrderCounters},
    .listings = {&searches::kCollideListing, &searches::kDistanceListing},
    .legend = {{"volume.child", "volumes of the children"},
               {"volume.band", "nearer to a than δ"},
               {"volume.segment", "the two segments compared"},
               {"volume.bounded", "segments that the box bounds"},
               {"volume.tile.marked", "tiles asked about"},
               {"volume.half", "one half of the tiles"},
               {"volume.split", "line that halves the tiles"},
               {"volume.centers", "way between centers, with radii"},
               {"region.hatch", "cut off, with all in it"},
               {"gap.exact", "shortest way between volumes"}},
};

}  // namespace gjkscope
