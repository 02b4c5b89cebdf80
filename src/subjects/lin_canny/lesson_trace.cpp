#include "subjects/lin_canny/lesson_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "lesson/vocabulary.hpp"
#include "outlines/brute.hpp"
#include "run/fields.hpp"
#include "run/outline_trace.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using fields::line;
using models::WalkPhase;
using models::WalkStop;

constexpr std::array<std::string_view, 3> kPhases = {"closest", "regions", "swap"};
constexpr std::array<std::string_view, 2> kAnswers = {"distance", "swaps"};
constexpr std::array<std::string_view, 6> kStops = {"running", "closest", "local-minimum",
                                                    "overlap", "refused", "pair-cap"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"distance", "distance of the closest features, once the walk has stopped"},
     {"swaps", "features that the walk has swapped by now"}}};

class LessonTrace : public AlgorithmTrace {
 public:
  explicit LessonTrace(TracedWalk walk) : walk_(std::move(walk)) {}

  [[nodiscard]] const TracedWalk& walk() const { return walk_; }
  [[nodiscard]] int steps() const override { return static_cast<int>(walk_.trace.steps.size()); }
  [[nodiscard]] StepInfo info(int index) const override {
    const models::WalkStep& step = walk_.trace.steps[index];
    const bool is_swap = step.phase == WalkPhase::swap;
    return {step.after.swaps + (is_swap ? 0 : 1), name_of(step.phase),
            is_swap || step.after.stop != WalkStop::running};
  }
  [[nodiscard]] double answer(std::string_view name) const override {
    if (walk_.trace.result.stop == WalkStop::refused)
      return std::numeric_limits<double>::quiet_NaN();
    return name == "swaps" ? walk_.trace.result.steps - 1 : walk_.trace.result.answer.distance;
  }
  [[nodiscard]] std::string_view stop() const override { return name_of(walk_.trace.result.stop); }
  [[nodiscard]] Json json(const Lesson& lesson, const PositionedRun&) const override {
    Json out;
    out["stop"] = name_of(walk_.trace.result.stop);
    if (!walk_.query) {
      out["flaw"] = models::name_of(walk_.trace.result.flaw.fault);
      return out;
    }
    out["steps"] = Json::array();
    for (int i = 0; i < steps(); ++i) out["steps"].push_back(step_json(lesson, i));
    const models::Answer& answer = walk_.trace.result.answer;
    out["distance"] = fields::number(answer.distance);
    out["overlap"] = answer.overlap;
    out["closest_x"] = fields::point(answer.a);
    out["closest_y"] = fields::point(answer.b);
    return out;
  }

 private:
  [[nodiscard]] Json step_json(const Lesson& lesson, int index) const {
    const models::WalkStep& step = walk_.trace.steps[index];
    const StepInfo at = info(index);
    Json out = {{"phase", at.phase},
                {"iteration", at.iteration},
                {"x", feature_name(lesson, *walk_.query, true, step.after.a)},
                {"y", feature_name(lesson, *walk_.query, false, step.after.b)}};
    if (step.phase == WalkPhase::closest) {
      out["distance_low"] = fields::number(step.after.pair.low);
      out["distance_high"] = fields::number(step.after.pair.high);
    }
    if (step.phase == WalkPhase::regions) {
      out["tests"] = Json::array();
      for (const models::RegionTest& test : step.tests)
        out["tests"].push_back(
            {{"neighbour", feature_name(lesson, *walk_.query, test.of_a, test.neighbour)},
             {"behind", test.behind},
             {"crossed", test.crossed}});
    }
    out["stop"] = name_of(step.after.stop);
    return out;
  }

  TracedWalk walk_;
};

std::string text(const Json& document, const Json& trace) {
  const fields::Values values(document);
  const auto words = [](const Json& name) { return name.get<std::string>(); };
  std::string out = "\nlin-canny\n";
  if (trace.contains("flaw"))
    return out + line("stop", words(trace["stop"]) + ": " + words(trace["flaw"]));
  for (const Json& step : trace["steps"]) {
    const std::string phase = words(step["phase"]);
    const std::string pair = words(step["x"]) + " and " + words(step["y"]);
    if (phase == "closest") {
      out += fmt::format("\nlin-canny, iteration {}\n", step["iteration"].get<int>());
      out += line(phase, pair + ", distance = " + values.number(step["distance_high"]));
    } else if (phase == "swap") {
      out += line(phase, pair);
    } else {
      for (const Json& test : step["tests"])
        out += line("region?",
                    fmt::format("{}{}: {}", test["behind"] ? "behind " : "towards ",
                                words(test["neighbour"]), test["crossed"] ? "crossed" : "no"));
    }
  }
  out += "\nlin-canny, result\n" + line("stop", words(trace["stop"]));
  out += line("distance", values.number(trace["distance"]));
  out += line("on " + values.x, values.point(trace["closest_x"]));
  return out + line("on " + values.y, values.point(trace["closest_y"]));
}

const TracedWalk& walk_of(const AlgorithmTrace& trace) {
  return static_cast<const LessonTrace&>(trace).walk();
}

/// The vertex of an outline as a feature of its ring.
models::RingFeature vertex_of(const models::Ring& ring, int vertex) {
  const auto found = std::find(ring.index.begin(), ring.index.end(), vertex);
  return {true, found == ring.index.end() ? 0 : static_cast<int>(found - ring.index.begin())};
}

/// Convex polygons are walked on in any case; others, too: the walk says where it is stuck.
std::shared_ptr<const AlgorithmTrace> run_walk(const Lesson& lesson, const PositionedRun& run,
                                               const AlgorithmTrace* before) {
  TracedWalk walk;
  const auto [x, y] = outlines_of(lesson, run);
  for (const models::Model* model : {&x, &y}) {
    models::Flaw flaw = models::check(model->outlines, models::Needs::simple);
    if (flaw.fault == models::Fault::none && model->outlines.size() > 1)
      flaw = {models::Fault::several_outlines, 1};
    if (flaw.fault == models::Fault::none) continue;
    walk.trace.result.stop = WalkStop::refused;
    walk.trace.result.flaw = flaw;
    walk.trace.result.flaw_in_b = model == &y;
    return std::make_shared<const LessonTrace>(std::move(walk));
  }
  walk.query = models::walk_query(x, y);
  const gjk::VertexPair start = lesson.options.start.pairs[0];
  models::RingFeature a = vertex_of(walk.query->a, start.x);
  models::RingFeature b = vertex_of(walk.query->b, start.y);
  if (lesson.warm_start && before != nullptr && walk_of(*before).query) {
    a = walk_of(*before).trace.result.a;
    b = walk_of(*before).trace.result.b;
  }
  walk.trace = models::trace_walk(*walk.query, a, b);
  if (walk.trace.result.stop == WalkStop::local_minimum) walk.truth = models::brute(x, y).answer;
  return std::make_shared<const LessonTrace>(std::move(walk));
}

}  // namespace

std::string_view name_of(models::WalkPhase phase) {
  return kPhases[static_cast<std::size_t>(phase)];
}

std::string_view name_of(models::WalkStop stop) { return kStops[static_cast<std::size_t>(stop)]; }

std::string feature_name(const Lesson& lesson, const models::WalkQuery& query, bool of_x,
                         const models::RingFeature& feature) {
  const LessonShape& shape = of_x ? lesson.x() : lesson.y();
  const models::Ring& ring = of_x ? query.a : query.b;
  const auto name = [&](int i) { return shape.vertex_names[ring.index[i]]; };
  if (feature.is_vertex) return fmt::format("vertex {} of {}", name(feature.index), shape.name);
  return fmt::format("edge {}{} of {}", name(feature.index), name(ring.next(feature.index)),
                     shape.name);
}

const Algorithm kLinCannyAlgorithm{.name = "lin-canny",
                                   .phases = kPhases,
                                   .answers = kAnswers,
                                   .values = kValues,
                                   .run = run_walk,
                                   .takes_outlines = true,
                                   .stops = std::span(kStops).subspan(1),
                                   .text = text};

const TracedWalk* walk_trace(const LessonRun& run, int index) {
  if (run.tour->algorithm != &kLinCannyAlgorithm) return nullptr;
  return &walk_of(*run.algorithm_traces[index]);
}

}  // namespace gjkscope
