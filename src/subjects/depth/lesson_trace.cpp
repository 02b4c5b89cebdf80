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

std::string corner_name(const Lesson& lesson, const depth::State<double>& state, int corner) {
  return pair_name(lesson.x().vertex_names, lesson.y().vertex_names,
                   state.polygon.corners[static_cast<std::size_t>(corner)].point.pair);
}

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

class TextWriter {
 public:
  explicit TextWriter(const Lesson& lesson) : lesson_(lesson) {}

  [[nodiscard]] std::string write(const DepthTrace& trace) const {
    const depth::Result<double>& result = trace.result;
    if (trace.steps.empty()) return "\ndepth\n" + line("stop", name_of(result.stop));
    std::string out = "\ndepth\n" + line("polygon", polygon(trace.initial));
    for (const depth::Step<double>& each : trace.steps) {
      if (each.phase == depth::Phase::nearest)
        out += fmt::format("\ndepth, iteration {}\n", each.iteration);
      out += step(each);
    }
    out += "\ndepth, result\n" + line("stop", name_of(result.stop));
    out += line("verdict", fmt::format("{}{}", name_of(result.verdict),
                                       result.settled ? ", settled in exact arithmetic" : ""));
    out += line("depth", numbers(result.depth));
    out += line("bounds", fmt::format("{} to {}", numbers(result.lower), numbers(result.upper)));
    out += line("move", fmt::format("{} by {}", lesson_.x().name, numbers(result.translation)));
    out += line("on " + lesson_.x().name, numbers(result.x));
    out += line("on " + lesson_.y().name, numbers(result.y));
    return out;
  }

 private:
  [[nodiscard]] std::string numbers(double value) const {
    return fields::number_text(lesson_.scalar, value);
  }
  [[nodiscard]] std::string numbers(const gjk::Vec<double, 2>& value) const {
    return fields::point_text(lesson_.scalar, value);
  }

  [[nodiscard]] std::string polygon(const depth::State<double>& state) const {
    std::vector<std::string> names;
    for (const depth::Edge<double>& each : edges_in_order(state.polygon))
      names.push_back(corner_name(lesson_, state, each.from));
    return fmt::format("{}", fmt::join(names, " "));
  }

  [[nodiscard]] std::string scan(const LessonShape& shape,
                                 const std::vector<gjk::ScanEntry<double>>& entries,
                                 int best) const {
    return fields::scan_text(lesson_.scalar, shape.name, shape.vertex_names, entries, best);
  }

  [[nodiscard]] std::string stop_test(const depth::StopTest<double>& test) const {
    if (!test.tried) return fmt::format("{}: not tried", name_of(test.reason));
    return fmt::format("{}: {} (left {}, right {})", name_of(test.reason),
                       test.holds ? "yes" : "no", numbers(test.left), numbers(test.right));
  }

  [[nodiscard]] std::string step(const depth::Step<double>& step) const {
    const depth::State<double>& after = step.after;
    std::string out;
    switch (step.phase) {
      case depth::Phase::nearest:
        return line("nearest", fmt::format("{} {}, distance^2 = {}, n = {}",
                                           corner_name(lesson_, after, after.edge.from),
                                           corner_name(lesson_, after, after.edge.to),
                                           numbers(after.edge.distance_sq), numbers(after.n)));
      case depth::Phase::support:
        out += line("scan", scan(lesson_.y(), step.record.scan_y, after.support.pair.y));
        out += line("", scan(lesson_.x(), step.record.scan_x, after.support.pair.x));
        return out +
               line("support", fmt::format("{} = {}",
                                           pair_name(lesson_.x().vertex_names,
                                                     lesson_.y().vertex_names, after.support.pair),
                                           numbers(after.support.w)));
      case depth::Phase::stop:
        for (const depth::StopTest<double>& test : step.record.stop_tests)
          out += line("stop?", stop_test(test));
        return out + line("bounds", fmt::format("{} to {}", numbers(step.bounds.lower),
                                                numbers(step.bounds.upper)));
      case depth::Phase::expand:
        return line("expand", fmt::format("polygon {}", polygon(after)));
    }
    return out;
  }

  const Lesson& lesson_;
};

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
  [[nodiscard]] std::string text(const Lesson& lesson, const PositionedRun&) const override {
    return TextWriter(lesson).write(trace_);
  }

 private:
  DepthTrace trace_;
};

std::shared_ptr<const AlgorithmTrace> run_depth(const Lesson& lesson, const PositionedRun& run,
                                                const AlgorithmTrace*) {
  return with_query(lesson, placements_of(run), [&]<class S>(const gjk::Query<S, 2>& query) {
    return std::make_shared<const Told>(
        widened(depth::trace<S>(query, started_as(run, lesson.options))));
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
                                .follows_gjk = true};

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

GJKSCOPE_DEPTH_INSTANCE(, Eigen::half)
GJKSCOPE_DEPTH_INSTANCE(, float)
GJKSCOPE_DEPTH_INSTANCE(, double)
GJKSCOPE_DEPTH_INSTANCE(, gjkscope::Rational)
