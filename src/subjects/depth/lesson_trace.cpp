#include "subjects/depth/lesson_trace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

#include "lesson/vocabulary.hpp"
#include "run/fields.hpp"
#include "run/query.hpp"
#include "subjects/depth/names.hpp"
#include "subjects/depth/widen.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using fields::line;
using fields::number;
using fields::point;

class JsonWriter {
 public:
  JsonWriter(const Lesson& lesson, const PositionedRun& run) : lesson_(lesson), run_(run) {}

  [[nodiscard]] Json write(const DepthTrace& trace) const {
    Json out;
    out["initial"] = state(trace.initial);
    out["steps"] = Json::array();
    for (const depth::Step<double>& each : trace.steps) out["steps"].push_back(step(each));
    const depth::Result<double>& result = trace.result;
    Json& answer = out["result"];
    answer["stop"] = name_of(result.stop);
    answer["verdict"] = name_of(result.verdict);
    answer["settled"] = result.settled;
    answer["depth"] = number(result.depth);
    answer["lower"] = number(result.lower);
    answer["upper"] = number(result.upper);
    answer["direction"] = point(result.direction);
    answer["translation"] = point(result.translation);
    answer["contact_x"] = point(result.x);
    answer["contact_y"] = point(result.y);
    answer["iterations"] = result.iterations;
    return out;
  }

 private:
  [[nodiscard]] Json vertex(const gjk::SupportPoint<double, 2>& value) const {
    return fields::vertex(in_space(value),
                          pair_name(lesson_.x().vertex_names, lesson_.y().vertex_names, value.pair),
                          run_);
  }

  static Json edge(const depth::Edge<double>& value) {
    return {{"corners", {value.from, value.to}}, {"distance_sq", number(value.distance_sq)}};
  }

  [[nodiscard]] Json state(const depth::State<double>& value) const {
    Json out;
    out["next_phase"] =
        value.stop == depth::StopReason::running ? Json(name_of(value.phase)) : Json();
    out["iteration"] = value.iteration;
    out["corners"] = Json::array();
    for (const depth::Corner<double>& corner : value.polygon.corners)
      out["corners"].push_back(vertex(corner.point));
    out["polygon"] = Json::array();
    if (value.polygon.count > 0) {
      for (const depth::Edge<double>& each : edges_in_order(value.polygon))
        out["polygon"].push_back(each.from);
    }
    out["edge"] = edge(value.edge);
    out["n"] = point(value.n);
    out["stop"] = name_of(value.stop);
    return out;
  }

  [[nodiscard]] Json step(const depth::Step<double>& step) const {
    Json out;
    out["phase"] = name_of(step.phase);
    out["iteration"] = step.iteration;
    const depth::Record<double>& record = step.record;
    switch (step.phase) {
      case depth::Phase::nearest:
        out["edges"] = Json::array();
        for (const depth::Edge<double>& each : record.edges) out["edges"].push_back(edge(each));
        break;
      case depth::Phase::support:
        out["scan_x"] = fields::scan(record.scan_x, lesson_.x().vertex_names);
        out["scan_y"] = fields::scan(record.scan_y, lesson_.y().vertex_names);
        out["support"] = vertex(step.after.support);
        break;
      case depth::Phase::stop:
        out["stop_tests"] = Json::array();
        for (const depth::StopTest<double>& test : record.stop_tests) {
          out["stop_tests"].push_back({{"test", name_of(test.reason)},
                                       {"tried", test.tried},
                                       {"holds", test.holds},
                                       {"left", number(test.left)},
                                       {"right", number(test.right)}});
        }
        break;
      case depth::Phase::expand:
        out["outgrown"] = record.outgrown;
        break;
    }
    out["after"] = state(step.after);
    out["lower"] = number(step.bounds.lower);
    out["upper"] = number(step.bounds.upper);
    return out;
  }

  const Lesson& lesson_;
  const PositionedRun& run_;
};

std::string text(const Json& document, const Json& trace) {
  const fields::Values values(document);
  const auto words = [](const Json& name) { return name.get<std::string>(); };
  const auto corner = [&](const Json& state, const Json& index) {
    return words(state["corners"][index.get<std::size_t>()]["name"]);
  };
  const auto polygon = [&](const Json& state) {
    std::vector<std::string> names;
    for (const Json& index : state["polygon"]) names.push_back(corner(state, index));
    return fmt::format("{}", fmt::join(names, " "));
  };
  const Json& result = trace["result"];
  if (trace["steps"].empty()) return "\ndepth\n" + line("stop", words(result["stop"]));
  std::string out = "\ndepth\n" + line("polygon", polygon(trace["initial"]));
  for (const Json& step : trace["steps"]) {
    const Json& after = step["after"];
    const std::string phase = words(step["phase"]);
    if (phase == "nearest") {
      const Json& ends = after["edge"]["corners"];
      out += fmt::format("\ndepth, iteration {}\n", step["iteration"].get<int>());
      out += line("nearest",
                  fmt::format("{} {}, distance^2 = {}, n = {}", corner(after, ends[0]),
                              corner(after, ends[1]), values.number(after["edge"]["distance_sq"]),
                              values.point(after["n"])));
    } else if (phase == "support") {
      const Json& support = step["support"];
      out += line("scan", values.scan(values.y, step["scan_y"], support["pair"][1]));
      out += line("", values.scan(values.x, step["scan_x"], support["pair"][0]));
      out += line("support", words(support["name"]) + " = " + values.point(support["w"]));
    } else if (phase == "stop") {
      for (const Json& test : step["stop_tests"]) out += line("stop?", values.stop_test(test));
      out += line("bounds", values.bounds(step));
    } else {
      out += line("expand", "polygon " + polygon(after));
    }
  }
  out += "\ndepth, result\n" + line("stop", words(result["stop"]));
  out += line("verdict", values.verdict(result));
  out += line("depth", values.number(result["depth"]));
  out += line("bounds", values.bounds(result));
  out += line("move", fmt::format("{} by {}", values.x, values.point(result["translation"])));
  out += line("on " + values.x, values.point(result["contact_x"]));
  return out + line("on " + values.y, values.point(result["contact_y"]));
}

class Told : public AlgorithmTrace {
 public:
  explicit Told(DepthTrace trace) : trace_(std::move(trace)) {}

  [[nodiscard]] const DepthTrace& trace() const { return trace_; }
  [[nodiscard]] int steps() const override { return static_cast<int>(trace_.steps.size()); }
  [[nodiscard]] StepInfo info(int step) const override {
    const depth::Step<double>& shown = trace_.steps[static_cast<std::size_t>(step)];
    return {shown.iteration, name_of(shown.phase),
            shown.after.stop != depth::StopReason::running || !shown.record.outgrown.empty()};
  }
  [[nodiscard]] double answer(std::string_view) const override { return trace_.result.depth; }
  [[nodiscard]] Json json(const Lesson& lesson, const PositionedRun& run) const override {
    return JsonWriter(lesson, run).write(trace_);
  }

 private:
  DepthTrace trace_;
};

std::shared_ptr<const AlgorithmTrace> run_depth(const Lesson& lesson, const PositionedRun& run,
                                                const AlgorithmTrace*) {
  return with_scalar(lesson.scalar, [&]<class S>(std::type_identity<S>) {
    return with_query_in<S, 2>(lesson, placements_of(run), [&](const gjk::Query<S, 2>& query) {
      return std::make_shared<const Told>(
          widened(depth::trace<S>(query, started_as(run, lesson.options))));
    });
  });
}

constexpr std::array<std::string_view, depth::kPhaseCount> kPhases = {
    name_of(depth::Phase::nearest), name_of(depth::Phase::support), name_of(depth::Phase::stop),
    name_of(depth::Phase::expand)};
constexpr std::array<std::string_view, 1> kAnswers = {"depth"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"depth", "penetration depth, once it is known"},
     {"t", "the shortest translation of X that parts the shapes, once it is known"}}};

}  // namespace

const Algorithm kDepthAlgorithm{.name = "depth",
                                .phases = kPhases,
                                .answers = kAnswers,
                                .values = kValues,
                                .run = run_depth,
                                .text = text};

const DepthTrace* depth_trace(const LessonRun& run, int index) {
  if (run.act->algorithm != &kDepthAlgorithm) return nullptr;
  return &static_cast<const Told&>(*run.algorithm_traces[static_cast<std::size_t>(index)]).trace();
}

DepthTrace depth_of(const PositionedRun& run, const gjk::Options& options, ScalarKind scalar) {
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    const std::vector<gjk::Vec<S, 2>> x = narrowed_all<S, 2>(run.x().world);
    const std::vector<gjk::Vec<S, 2>> y = narrowed_all<S, 2>(run.y().world);
    return widened(depth::trace<S>(gjk::Query<S, 2>{{x}, {y}}, options));
  });
}

}  // namespace gjkscope
