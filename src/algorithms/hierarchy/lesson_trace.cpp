#include "algorithms/hierarchy/lesson_trace.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "lesson/names.hpp"
#include "lesson/vocabulary.hpp"
#include "trace/fields.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using fields::line;
using models::Goal;
using models::SearchPhase;
using models::SearchStop;

constexpr std::array<std::string_view, 5> kPhases = {"visit", "bound", "leaf", "descend",
                                                     "contain"};
constexpr std::array<std::string_view, 2> kCollideAnswers = {"visits", "tests"};
constexpr std::array<std::string_view, 3> kDistanceAnswers = {"distance", "visits", "tests"};
constexpr std::array<PlaceholderInfo, 3> kValues = {
    {{"visits", "pairs of volumes that were visited by now"},
     {"tests", "pairs of segments that were tested by now"},
     {"pairs", "pairs of segments that there are"}}};

class Told : public AlgorithmTrace {
 public:
  explicit Told(SearchTold search) : search_(std::move(search)) {}

  [[nodiscard]] const SearchTold& search() const { return search_; }
  [[nodiscard]] int steps() const override { return static_cast<int>(search_.trace.steps.size()); }
  [[nodiscard]] StepInfo info(int index) const override {
    const models::SearchStep& step = search_.trace.steps[static_cast<std::size_t>(index)];
    return {static_cast<int>(step.after.visits), name_of(step.phase),
            is_candidate(step) || step.after.stop != SearchStop::running};
  }
  [[nodiscard]] double answer(std::string_view name) const override {
    const models::SearchResult& result = search_.trace.result;
    if (steps() == 0) return std::numeric_limits<double>::quiet_NaN();
    if (name == "visits") return static_cast<double>(result.visits);
    return name == "tests" ? static_cast<double>(result.measured) : result.answer.distance;
  }
  [[nodiscard]] Json json(const Lesson& lesson, const PositionedRun&) const override {
    Json out;
    if (steps() == 0) {
      out["refused"] = words_of(*search_.refusal, lesson);
      return out;
    }
    const models::SearchResult& result = search_.trace.result;
    out["stop"] = name_of(result.stop);
    out["volumes"] = name_of(lesson.volumes);
    out["visits"] = result.visits;
    out["tests"] = result.measured;
    for (const bool of_x : {true, false}) {
      Json& tree = out[of_x ? "tree_x" : "tree_y"] = Json::array();
      for (const TreeNode& node : search_.tree(of_x)) tree.push_back(node_json(node));
    }
    out["steps"] = Json::array();
    for (int i = 0; i < steps(); ++i) out["steps"].push_back(step_json(i));
    out["distance"] = fields::number(result.answer.distance);
    out["overlap"] = result.answer.overlap;
    out["closest_x"] = fields::point<2>(result.answer.a);
    out["closest_y"] = fields::point<2>(result.answer.b);
    return out;
  }
  [[nodiscard]] std::string text(const Lesson& lesson, const PositionedRun&) const override {
    std::string out = "\nhierarchy\n";
    if (steps() == 0) return out + line("refused", words_of(*search_.refusal, lesson));
    for (int i = 0; i < steps(); ++i) out += step_text(lesson, i);
    const models::SearchResult& result = search_.trace.result;
    out += "\nhierarchy, result\n" + line("stop", name_of(result.stop));
    out += line("visits", std::to_string(result.visits));
    out += line("tests", fmt::format("{} of {}", result.measured, search_.pairs()));
    if (std::isnan(result.answer.distance)) return out;
    out += line("distance", fields::number_text(lesson.scalar, result.answer.distance));
    out += line("on " + lesson.x().name, fields::point_text<2>(lesson.scalar, result.answer.a));
    return out +
           line("on " + lesson.y().name, fields::point_text<2>(lesson.scalar, result.answer.b));
  }

 private:
  /// Where only collision is asked, no pair is a candidate.
  [[nodiscard]] bool is_candidate(const models::SearchStep& step) const {
    return search_.options.goal == Goal::distance && step.record.better;
  }
  [[nodiscard]] static Json node_json(const TreeNode& node) {
    Json out = {{"parent", node.parent},
                {"left", node.left},
                {"right", node.right},
                {"segments", node.count}};
    if (const auto* box = std::get_if<models::Box>(&node.volume)) {
      out["low"] = fields::point<2>(box->low);
      out["high"] = fields::point<2>(box->high);
    } else {
      const auto& circle = std::get<models::Circle>(node.volume);
      out["centre"] = fields::point<2>(circle.centre);
      out["radius"] = fields::number(circle.radius);
    }
    return out;
  }
  [[nodiscard]] Json step_json(int index) const {
    const models::SearchStep& step = search_.trace.steps[static_cast<std::size_t>(index)];
    const models::SearchState& after = step.after;
    Json out = {{"phase", name_of(step.phase)}, {"iteration", after.visits}};
    switch (step.phase) {
      case SearchPhase::visit:
        if (after.phase == SearchPhase::contain) break;
        out["x"] = after.pair.a;
        out["y"] = after.pair.b;
        break;
      case SearchPhase::bound:
        out["bound"] = fields::number(after.pair.bound);
        out["limit"] = fields::number(step.record.limit);
        out["cut"] = step.record.cut;
        break;
      case SearchPhase::leaf:
        out["segments"] = {step.record.segments.first, step.record.segments.second};
        out["distance"] = fields::number(step.record.measured->high);
        out["better"] = is_candidate(step);
        break;
      case SearchPhase::descend:
        out["children"] = Json::array();
        for (const models::NodePair& child : step.record.children)
          out["children"].push_back({child.a, child.b});
        break;
      case SearchPhase::contain:
        break;
    }
    out["waiting"] = after.waiting.size();
    out["stop"] = name_of(after.stop);
    return out;
  }
  [[nodiscard]] std::string step_text(const Lesson& lesson, int index) const {
    const models::SearchStep& step = search_.trace.steps[static_cast<std::size_t>(index)];
    const models::SearchState& after = step.after;
    const auto number = [&](double value) { return fields::number_text(lesson.scalar, value); };
    switch (step.phase) {
      case SearchPhase::visit:
        if (after.phase == SearchPhase::contain) return "";
        return fmt::format("\nhierarchy, visit {}\n", after.visits) +
               line("pair", fmt::format("{} {} and {} {}", lesson.x().name, after.pair.a,
                                        lesson.y().name, after.pair.b));
      case SearchPhase::bound:
        return line("bound",
                    fmt::format("{}, limit {}: {}", number(after.pair.bound),
                                number(step.record.limit), step.record.cut ? "cut" : "no"));
      case SearchPhase::leaf:
        return line("leaf",
                    fmt::format("segments {} and {}, distance {}{}", step.record.segments.first,
                                step.record.segments.second, number(step.record.measured->high),
                                is_candidate(step) ? ": candidate" : ""));
      case SearchPhase::descend:
        return line("descend",
                    fmt::format("into {}, {} wait",
                                step.record.takes_b_apart ? lesson.y().name : lesson.x().name,
                                after.waiting.size()));
      case SearchPhase::contain:
        return line("contain", after.inside ? "yes" : "no");
    }
    return "";
  }

  SearchTold search_;
};

template <class V>
std::vector<TreeNode> told_nodes(const models::Hierarchy<V>& tree) {
  std::vector<TreeNode> out;
  out.reserve(tree.nodes.size());
  for (const models::Node<V>& node : tree.nodes)
    out.push_back({node.volume, node.parent, node.left, node.right, node.first, node.count});
  return out;
}

template <class V>
void run_search(SearchTold& told) {
  const auto tree_x = models::build_hierarchy<V>(models::items_of(told.x));
  const auto tree_y = models::build_hierarchy<V>(models::items_of(told.y));
  const models::SearchQuery<V> query{told.x, told.y, tree_x, tree_y};
  told.trace = models::trace_search(query, told.options);
  told.tree_x = told_nodes(tree_x);
  told.tree_y = told_nodes(tree_y);
  if (told.options.goal == Goal::collide) return;
  models::SearchOptions left_first = told.options;
  left_first.nearer_first = false;
  told.left_first = models::trace_search(query, left_first);
}

std::shared_ptr<const AlgorithmTrace> search_shapes(const Lesson& lesson, const PositionedRun& run,
                                                    const AlgorithmTrace* before, Goal goal) {
  SearchTold told;
  OutlinesOfRun outlines = outlines_of(lesson, run);
  told.refusal = refusal_of(outlines, models::Needs::segments);
  told.x = std::move(outlines.x);
  told.y = std::move(outlines.y);
  if (told.refusal) return std::make_shared<const Told>(std::move(told));
  told.options.goal = goal;
  // Larsen's listing descends into A first, left child first.
  told.options.nearer_first = goal == Goal::distance;
  told.options.larger_first = goal == Goal::distance;
  if (lesson.warm_start && before != nullptr) {
    const models::SearchTrace& last = static_cast<const Told&>(*before).search().trace;
    if (last.result.segments.first >= 0) told.options.remembered = last.result.segments;
  }
  if (lesson.volumes == VolumeKind::circles) {
    run_search<models::Circle>(told);
  } else {
    run_search<models::Box>(told);
  }
  return std::make_shared<const Told>(std::move(told));
}

template <Goal goal>
std::shared_ptr<const AlgorithmTrace> search_for(const Lesson& lesson, const PositionedRun& run,
                                                 const AlgorithmTrace* before) {
  return search_shapes(lesson, run, before, goal);
}

}  // namespace

std::string_view name_of(SearchPhase phase) { return kPhases[static_cast<std::size_t>(phase)]; }

std::string_view name_of(SearchStop stop) {
  constexpr std::array<std::string_view, 4> kNames = {"running", "meet", "contained", "apart"};
  return kNames[static_cast<std::size_t>(stop)];
}

const Algorithm kHierarchyCollide{.name = "hierarchy-collide",
                                  .phases = kPhases,
                                  .answers = kCollideAnswers,
                                  .values = kValues,
                                  .run = search_for<Goal::collide>,
                                  .has_volumes = true};

const Algorithm kHierarchyDistance{.name = "hierarchy-distance",
                                   .phases = kPhases,
                                   .answers = kDistanceAnswers,
                                   .values = kValues,
                                   .run = search_for<Goal::distance>,
                                   .has_volumes = true};

const SearchTold* search_told(const LessonRun& run, int index) {
  if (run.act->algorithm != &kHierarchyCollide && run.act->algorithm != &kHierarchyDistance)
    return nullptr;
  return &static_cast<const Told&>(*run.algorithm_traces[static_cast<std::size_t>(index)]).search();
}

}  // namespace gjkscope
