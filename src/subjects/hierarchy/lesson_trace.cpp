#include "subjects/hierarchy/lesson_trace.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "lesson/names.hpp"
#include "lesson/vocabulary.hpp"
#include "outlines/sphere_tree.hpp"
#include "run/fields.hpp"
#include "subjects/hierarchy/table.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using models::Goal;
using models::SearchPhase;
using models::SearchStop;

constexpr std::array<std::string_view, 5> kPhases = {"visit", "bound", "leaf", "descend",
                                                     "contain"};
constexpr std::array<std::string_view, 2> kCollideAnswers = {"visits", "tests"};
constexpr std::array<std::string_view, 4> kDistanceAnswers = {"distance", "visits", "tests",
                                                              "looked-up"};
constexpr std::array<std::string_view, 4> kStops = {"running", "meet", "contained", "apart"};
constexpr std::array<PlaceholderInfo, 4> kValues = {
    {{"visits", "pairs of volumes that were visited by now"},
     {"tests", "pairs of segments that were tested by now"},
     {"looked up", "pairs of tiles whose segments were in the table by now"},
     {"pairs", "pairs of segments that there are"}}};

/// The tiles of a segment: finer tiles would make trees that nobody can look at.
constexpr int kMostTiles = 64;

class LessonTrace : public OutlineTrace {
 public:
  LessonTrace(std::optional<Refusal> refused, TracedSearch search)
      : OutlineTrace(refused), search_(std::move(search)) {}

  [[nodiscard]] const TracedSearch& search() const { return search_; }
  [[nodiscard]] int steps() const override { return static_cast<int>(search_.trace.steps.size()); }
  [[nodiscard]] StepInfo info(int index) const override {
    const models::SearchStep& step = search_.trace.steps[index];
    return {static_cast<int>(step.after.visits), name_of(step.phase),
            is_candidate(step) || step.after.stop != SearchStop::running};
  }
  [[nodiscard]] double answer(std::string_view name) const override {
    const models::SearchResult& result = search_.trace.result;
    if (refusal) return std::numeric_limits<double>::quiet_NaN();
    if (name == "visits") return static_cast<double>(result.visits);
    if (name == "looked-up") return static_cast<double>(result.hits);
    return name == "tests" ? static_cast<double>(result.measured) : result.answer.distance;
  }

 protected:
  [[nodiscard]] std::string_view stop() const override {
    return refusal ? std::string_view() : name_of(search_.trace.result.stop);
  }
  [[nodiscard]] Json step_json(const Lesson&, int index) const override {
    const models::SearchStep& step = search_.trace.steps[index];
    const models::SearchState& after = step.after;
    switch (step.phase) {
      case SearchPhase::visit:
        if (after.phase == SearchPhase::contain) break;
        return {{"x", node_json(true, after.pair.a)}, {"y", node_json(false, after.pair.b)}};
      case SearchPhase::bound:
        return {{"bound", fields::number(after.pair.bound)},
                {"limit", fields::number(step.record.limit)},
                {"cut", step.record.cut}};
      case SearchPhase::leaf:
        if (step.record.hit)
          return {{"segments", {step.record.segments.first, step.record.segments.second}},
                  {"looked_up", true}};
        return {{"segments", {step.record.segments.first, step.record.segments.second}},
                {"distance", fields::number(step.record.measured->high)},
                {"candidate", is_candidate(step)}};
      case SearchPhase::descend:
        return {{"into", step.record.takes_b_apart ? "y" : "x"}, {"waiting", after.waiting.size()}};
      case SearchPhase::contain:
        return {{"inside", after.inside.has_value()}};
    }
    return {{"waiting", 0}};
  }
  [[nodiscard]] Json result_json(const Lesson& lesson) const override {
    const models::SearchResult& result = search_.trace.result;
    return {{"stop", name_of(result.stop)},
            {"volumes", name_of(trees_of(lesson).volumes)},
            {"visits", result.visits},
            {"tests", result.measured},
            {"looked_up", result.hits},
            {"pairs", search_.pairs()},
            {"distance", fields::number(result.answer.distance)},
            {"overlap", result.answer.overlap},
            {"closest_x", fields::point(result.answer.a)},
            {"closest_y", fields::point(result.answer.b)}};
  }

 private:
  /// True when the step found a new candidate; there is none if only collision is asked.
  [[nodiscard]] bool is_candidate(const models::SearchStep& step) const {
    return search_.options.goal == Goal::distance && step.record.better;
  }
  [[nodiscard]] Json node_json(bool of_x, int index) const {
    const TreeNode& node = search_.tree(of_x)[index];
    return {{"node", index}, {"segments", node.count}};
  }

  TracedSearch search_;
};

template <class V>
std::vector<TreeNode> tree_nodes(const models::Hierarchy<V>& tree) {
  std::vector<TreeNode> out;
  out.reserve(tree.nodes.size());
  for (const models::Node<V>& node : tree.nodes)
    out.push_back({node.volume, node.parent, node.left, node.right, node.first, node.count});
  return out;
}

template <class V>
void run_search(TracedSearch& traced, const models::Hierarchy<V>& tree_x,
                const models::Hierarchy<V>& tree_y) {
  const models::SearchQuery<V> query{traced.x, traced.y, tree_x, tree_y};
  traced.trace = models::trace_search(query, traced.options);
  traced.tree_x = tree_nodes(tree_x);
  traced.tree_y = tree_nodes(tree_y);
  for (const models::Item& item : tree_x.items) traced.segments_x.push_back(item.segment);
  if (traced.options.goal == Goal::collide) return;
  models::SearchOptions left_first = traced.options;
  left_first.nearer_first = false;
  traced.left_first = models::trace_search(query, left_first);
  models::SearchOptions collide = traced.options;
  collide.goal = Goal::collide;
  collide.remembered.reset();
  traced.collide = models::trace_search(query, collide);
}

/// Searches for the distance with tiles from an eighth of the lesson's size to eight times, and
/// without.
void compare_tiles(TracedSearch& traced, double radius) {
  for (double share = 0.125; share <= 8.0; share *= 2.0) {
    const auto tree = [&](const models::Model& model) {
      return models::build_hierarchy<models::Circle>(
          models::tiles_of(model, share * radius, kMostTiles));
    };
    const auto tree_x = tree(traced.x);
    const auto tree_y = tree(traced.y);
    traced.tile_sizes.push_back(
        {share * radius,
         models::search<models::Circle>({traced.x, traced.y, tree_x, tree_y}, traced.options)});
  }
  traced.of_boxes = models::search<models::Box>(traced.x, traced.y);
  traced.of_circles = models::search<models::Circle>(traced.x, traced.y);
}

std::shared_ptr<const AlgorithmTrace> search_shapes(const Lesson& lesson, const PositionedRun& run,
                                                    const AlgorithmTrace* before, Goal goal) {
  TracedSearch traced;
  OutlinesOfRun outlines = outlines_of(lesson, run);
  const std::optional<Refusal> refused = refusal_of(outlines, models::Needs::segments);
  traced.x = std::move(outlines.x);
  traced.y = std::move(outlines.y);
  traced.refusal = refused;
  if (refused) return std::make_shared<const LessonTrace>(refused, std::move(traced));
  traced.options.goal = goal;
  // Larsen's listing descends into A first, left child first.
  traced.options.nearer_first = goal == Goal::distance;
  traced.options.larger_first = goal == Goal::distance;
  if (lesson.warm_start && before != nullptr) {
    const models::SearchTrace& last = static_cast<const LessonTrace&>(*before).search().trace;
    if (last.result.segments.first >= 0) traced.options.remembered = last.result.segments;
  }
  const LessonTrees trees = trees_of(lesson);
  const auto search = [&]<class V>(std::type_identity<V>, const auto& items) {
    run_search<V>(traced, models::build_hierarchy<V>(items(traced.x)),
                  models::build_hierarchy<V>(items(traced.y)));
  };
  const auto tiles = [&](const models::Model& model) {
    return models::tiles_of(model, trees.tile, kMostTiles);
  };
  switch (trees.volumes) {
    case VolumeKind::boxes:
      search(std::type_identity<models::Box>{}, models::items_of);
      break;
    case VolumeKind::circles:
      search(std::type_identity<models::Circle>{}, models::items_of);
      break;
    case VolumeKind::tiles:
      traced.options.table = true;
      traced.options.relative_error = lesson.options.tolerance;
      search(std::type_identity<models::Circle>{}, tiles);
      compare_tiles(traced, trees.tile);
      break;
  }
  return std::make_shared<const LessonTrace>(std::nullopt, std::move(traced));
}

template <Goal goal>
std::shared_ptr<const AlgorithmTrace> search_for(const Lesson& lesson, const PositionedRun& run,
                                                 const AlgorithmTrace* before) {
  return search_shapes(lesson, run, before, goal);
}

}  // namespace

std::string_view name_of(SearchPhase phase) { return kPhases[static_cast<std::size_t>(phase)]; }

std::string_view name_of(SearchStop stop) { return kStops[static_cast<std::size_t>(stop)]; }

const Algorithm kHierarchyCollide{.name = "hierarchy-collide",
                                  .phases = kPhases,
                                  .answers = kCollideAnswers,
                                  .values = kValues,
                                  .run = search_for<Goal::collide>,
                                  .takes_outlines = true,
                                  .stops = std::span(kStops).subspan(1)};

const Algorithm kHierarchyDistance{.name = "hierarchy-distance",
                                   .phases = kPhases,
                                   .answers = kDistanceAnswers,
                                   .values = kValues,
                                   .run = search_for<Goal::distance>,
                                   .takes_outlines = true,
                                   .stops = std::span(kStops).subspan(1)};

const TracedSearch* search_trace(const LessonRun& run, int index) {
  if (run.tour->algorithm != &kHierarchyCollide && run.tour->algorithm != &kHierarchyDistance)
    return nullptr;
  return &static_cast<const LessonTrace&>(*run.algorithm_traces[index]).search();
}

}  // namespace gjkscope
