#include "subjects/methods/lesson_trace.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "exact/instances.hpp"
#include "lesson/vocabulary.hpp"
#include "run/fields.hpp"

namespace gjkscope {
namespace {

using fields::Json;

constexpr std::array<std::string_view, 1> kPhases = {"position"};
constexpr std::array<std::string_view, 1> kAnswers = {"distance"};
constexpr std::array<PlaceholderInfo, 1> kValues = {
    {{"distance", "distance of the shapes at this position"}}};

class LessonTrace : public OutlineTrace {
 public:
  explicit LessonTrace(MethodsTrace trace)
      : OutlineTrace(trace.refusal), trace_(std::move(trace)) {}

  [[nodiscard]] const MethodsTrace& trace() const { return trace_; }
  [[nodiscard]] int steps() const override { return refusal ? 0 : 1; }
  [[nodiscard]] StepInfo info(int) const override { return {1, kPhases[0]}; }
  [[nodiscard]] double answer(std::string_view) const override {
    return refusal ? std::numeric_limits<double>::quiet_NaN() : trace_.answer.distance;
  }

 protected:
  [[nodiscard]] Json step_json(const Lesson&, int) const override {
    Json list = Json::array();
    for (const Method method : kMethods) {
      const auto i = static_cast<std::size_t>(method);
      list.push_back({{"method", name_of(method)},
                      {"steps", trace_.steps[i]},
                      {"unit", unit_of(method)},
                      {"distance", fields::number(trace_.distances[i])}});
    }
    return {{"answers", std::move(list)}};
  }
  [[nodiscard]] Json result_json(const Lesson&) const override {
    return {{"distance", fields::number(trace_.answer.distance)},
            {"overlap", trace_.answer.overlap}};
  }

 private:
  MethodsTrace trace_;
};

/// Takes notes of one method after the other.
class Asking {
 public:
  Asking(MethodsTrace& trace, const MethodsTrace* before) : trace_(trace), before_(before) {}

  void gjk(const PositionedRun& run, const Lesson& lesson) {
    const Case world = case_of(run);
    const ::gjk::Query<double, 2> query{{world.a}, {world.b}};
    ::gjk::Options options;
    options.start = lesson.options.start;
    const auto cold = ::gjk::distance(query, options);
    note(Method::gjk_cold, cold.iterations, cold.distance);
    if (before_ != nullptr) options.start = before_->simplex;
    const auto warm = before_ == nullptr ? cold : ::gjk::distance(query, options);
    note(Method::gjk_warm, warm.iterations, warm.distance);
    trace_.simplex = warm.warm();
  }

  void walk(const models::Model& x, const models::Model& y) {
    const models::WalkQuery query = models::walk_query(x, y);
    const models::RingFeature any;
    const models::WalkResult result = models::lin_canny(
        query, before_ != nullptr ? before_->on_x : any, before_ != nullptr ? before_->on_y : any);
    note(Method::lin_canny, result.steps, result.answer.distance);
    trace_.on_x = result.a;
    trace_.on_y = result.b;
  }

  void trees(const models::Model& x, const models::Model& y) {
    const auto tree_x = models::build_hierarchy<models::Box>(models::items_of(x));
    const auto tree_y = models::build_hierarchy<models::Box>(models::items_of(y));
    const Query query{x, y, tree_x, tree_y};
    models::SearchOptions options;
    const models::SearchResult cold = models::search(query, options);
    note(Method::tree_cold, cold.visits, cold.answer.distance);
    if (before_ != nullptr && before_->segments.first >= 0) options.remembered = before_->segments;
    const models::SearchResult pair = models::search(query, options);
    note(Method::tree_pair, pair.visits, pair.answer.distance);
    const models::SearchResult front = search_from_front(query, options);
    note(Method::tree_front, front.visits, front.answer.distance);
    trace_.answer = front.answer;
    trace_.segments = front.segments;
  }

 private:
  using Query = models::SearchQuery<models::Box>;

  /// A front only moves down, and trees that are built anew have other segments in their nodes. It
  /// is given up when a search from it costs more than three quarters of one from the roots, but
  /// not after the first search, which starts at the roots.
  [[nodiscard]] static bool is_cheap(const MethodsTrace& trace) {
    const long visits = trace.at(Method::tree_front);
    return visits == trace.from_roots || 4 * visits <= 3 * trace.from_roots;
  }

  /// Starts with the pairs at which the last search ended, the nearest on top (FCL calls them the
  /// front). Trees of as many segments have the same nodes, so below these pairs lie all pairs of
  /// leaves, as below the roots.
  models::SearchResult search_from_front(const Query& query, const models::SearchOptions& options) {
    models::SearchState state = models::start(query, options);
    const bool starts_at_front =
        before_ != nullptr && !before_->front.empty() && is_cheap(*before_);
    if (starts_at_front) {
      state.waiting.clear();
      for (const models::NodePair& pair : before_->front)
        state.waiting.push_back(models::detail::node_pair(query, pair.a, pair.b, -1));
      std::stable_sort(state.waiting.begin(), state.waiting.end(),
                       [](const auto& p, const auto& q) { return p.bound > q.bound; });
    }
    while (state.stop == models::SearchStop::running) {
      const models::SearchPhase phase = state.phase;
      models::SearchRecord record;
      models::step(state, query, options, record);
      if (record.cut || phase == models::SearchPhase::leaf) trace_.front.push_back(state.pair);
    }
    trace_.from_roots = starts_at_front ? before_->from_roots : state.visits;
    // A search that found segments that meet leaves pairs behind.
    if (state.stop == models::SearchStop::meet) trace_.front.clear();
    return models::result_of(state, query, options);
  }

  void note(Method method, long steps, double distance) {
    trace_.steps[static_cast<std::size_t>(method)] = steps;
    trace_.distances[static_cast<std::size_t>(method)] = distance;
  }

  MethodsTrace& trace_;
  const MethodsTrace* before_;
};

std::shared_ptr<const AlgorithmTrace> run_methods(const Lesson& lesson, const PositionedRun& run,
                                                  const AlgorithmTrace* before) {
  MethodsTrace trace;
  const OutlinesOfRun outlines = outlines_of(lesson, run);
  trace.refusal = refusal_of(outlines, models::Needs::convex);
  if (trace.refusal) return std::make_shared<const LessonTrace>(std::move(trace));
  const MethodsTrace* last =
      before == nullptr ? nullptr : &static_cast<const LessonTrace&>(*before).trace();
  Asking asking(trace, last != nullptr && !last->is_refused() ? last : nullptr);
  asking.gjk(run, lesson);
  asking.walk(outlines.x, outlines.y);
  asking.trees(outlines.x, outlines.y);
  return std::make_shared<const LessonTrace>(std::move(trace));
}

}  // namespace

std::string_view name_of(Method method) {
  constexpr std::array<std::string_view, kMethods.size()> kNames = {
      "GJK",   "GJK, last simplex", "Lin-Canny, last features",
      "trees", "trees, last pair",  "trees, last front"};
  return kNames[static_cast<std::size_t>(method)];
}

std::string_view unit_of(Method method) {
  constexpr std::array<std::string_view, kMethods.size()> kUnits = {
      "iterations",     "iterations",     "pairs of features",
      "pairs of boxes", "pairs of boxes", "pairs of boxes"};
  return kUnits[static_cast<std::size_t>(method)];
}

const Algorithm kMethodsAlgorithm{.name = "methods",
                                  .phases = kPhases,
                                  .answers = kAnswers,
                                  .values = kValues,
                                  .run = run_methods,
                                  .takes_outlines = true};

const MethodsTrace* methods_trace(const LessonRun& run, int index) {
  if (run.tour->algorithm != &kMethodsAlgorithm) return nullptr;
  return &static_cast<const LessonTrace&>(*run.algorithm_traces[index]).trace();
}

}  // namespace gjkscope
