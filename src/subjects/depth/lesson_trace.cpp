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

/// Writes a run in the plane or in space.
template <class Trace>
class JsonWriter {
 public:
  JsonWriter(const Lesson& lesson, const PositionedRun& run, const Trace& trace)
      : lesson_(lesson), run_(run), trace_(trace) {}

  [[nodiscard]] Json write() const {
    Json out;
    out["initial"] = state(trace_.initial);
    out["steps"] = Json::array();
    for (const auto& each : trace_.steps) out["steps"].push_back(step(each));
    const auto& result = trace_.result;
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
  template <int D>
  [[nodiscard]] Json vertex(const gjk::SupportPoint<double, D>& value) const {
    return fields::vertex(in_space(value),
                          pair_name(lesson_.x().vertex_names, lesson_.y().vertex_names, value.pair),
                          run_);
  }

  static Json edge(const depth::Edge<double>& value) {
    return {{"corners", {value.from, value.to}}, {"distance_sq", number(value.distance_sq)}};
  }

  void add_shape(Json& out, const depth::State<double>& value) const {
    for (const depth::Corner<double>& corner : value.polygon.corners)
      out["corners"].push_back(vertex(corner.point));
    out["polygon"] = Json::array();
    if (value.polygon.count > 0) {
      for (const depth::Edge<double>& each : edges_in_order(value.polygon))
        out["polygon"].push_back(each.from);
    }
    out["edge"] = edge(value.edge);
  }
  void add_shape(Json& out, const depth::space::State<double>& value) const {
    for (const WideVertex& corner : value.polytope.corners)
      out["corners"].push_back(vertex(corner));
    out["faces"] = Json::array();
    for (std::size_t i = 0; i < value.polytope.faces.size(); ++i) {
      const depth::space::Face<double>& face = value.polytope.faces[i];
      out["faces"].push_back({{"name", face_name(trace_, static_cast<int>(i))},
                              {"corners", face.corners},
                              {"distance_sq", number(face.distance_sq)},
                              {"is_outgrown", face.is_outgrown}});
    }
    out["face"] = value.face;
  }

  [[nodiscard]] Json state(const auto& value) const {
    Json out;
    out["next_phase"] =
        value.stop == depth::StopReason::running ? Json(name_of(value.phase)) : Json();
    out["iteration"] = value.iteration;
    out["corners"] = Json::array();
    add_shape(out, value);
    out["n"] = point(value.n);
    out["stop"] = name_of(value.stop);
    return out;
  }

  static void add_nearest(Json& out, const depth::Record<double>& record) {
    out["edges"] = Json::array();
    for (const depth::Edge<double>& each : record.edges) out["edges"].push_back(edge(each));
  }
  static void add_nearest(Json& out, const depth::space::Record<double>& record) {
    out["measured"] = record.faces;
  }
  static void add_expansion(Json& out, const depth::Record<double>& record) {
    out["outgrown"] = record.outgrown;
  }
  static void add_expansion(Json& out, const depth::space::Record<double>& record) {
    out["outgrown"] = record.outgrown;
    out["added"] = record.added;
  }

  [[nodiscard]] Json step(const auto& step) const {
    Json out;
    out["phase"] = name_of(step.phase);
    out["iteration"] = step.iteration;
    const auto& record = step.record;
    switch (step.phase) {
      case depth::Phase::nearest:
        add_nearest(out, record);
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
        add_expansion(out, record);
        break;
    }
    out["after"] = state(step.after);
    out["lower"] = number(step.bounds.lower);
    out["upper"] = number(step.bounds.upper);
    return out;
  }

  const Lesson& lesson_;
  const PositionedRun& run_;
  const Trace& trace_;
};

std::string text(const Json& document, const Json& trace) {
  const fields::Values values(document);
  const auto words = [](const Json& name) { return name.get<std::string>(); };
  const auto corner = [&](const Json& state, const Json& index) {
    return words(state["corners"][index.get<std::size_t>()]["name"]);
  };
  const auto corners = [&](const Json& state, const Json& of) {
    std::vector<std::string> names;
    for (const Json& index : of) names.push_back(corner(state, index));
    return fmt::format("{}", fmt::join(names, " "));
  };
  const auto faces = [&](const Json& state, const Json& of) {
    std::vector<std::string> names;
    for (const Json& index : of)
      names.push_back(words(state["faces"][index.get<std::size_t>()]["name"]));
    return fmt::format("{}", fmt::join(names, " "));
  };
  const Json& result = trace["result"];
  if (trace["steps"].empty()) return "\ndepth\n" + line("stop", words(result["stop"]));
  const bool in_space = trace["initial"].contains("faces");
  std::string out = "\ndepth\n";
  if (!in_space) out += line("polygon", corners(trace["initial"], trace["initial"]["polygon"]));
  for (std::size_t i = 0; in_space && i < trace["initial"]["faces"].size(); ++i) {
    const Json& face = trace["initial"]["faces"][i];
    if (!face["is_outgrown"].get<bool>())
      out += line(words(face["name"]), corners(trace["initial"], face["corners"]));
  }
  for (const Json& step : trace["steps"]) {
    const Json& after = step["after"];
    const std::string phase = words(step["phase"]);
    if (phase == "nearest") {
      const Json& nearest =
          in_space ? after["faces"][after["face"].get<std::size_t>()] : after["edge"];
      out += fmt::format("\ndepth, iteration {}\n", step["iteration"].get<int>());
      out += line("nearest",
                  fmt::format("{}{}, distance^2 = {}, n = {}",
                              in_space ? words(nearest["name"]) + ": " : "",
                              corners(after, nearest["corners"]),
                              values.number(nearest["distance_sq"]), values.point(after["n"])));
    } else if (phase == "support") {
      const Json& support = step["support"];
      out += line("scan", values.scan(values.y, step["scan_y"], support["pair"][1]));
      out += line("", values.scan(values.x, step["scan_x"], support["pair"][0]));
      out += line("support", words(support["name"]) + " = " + values.point(support["w"]));
    } else if (phase == "stop") {
      for (const Json& test : step["stop_tests"]) out += line("stop?", values.stop_test(test));
      out += line("bounds", values.bounds(step));
    } else if (in_space) {
      out += line("outgrown", faces(after, step["outgrown"]));
      for (const Json& index : step["added"]) {
        const Json& face = after["faces"][index.get<std::size_t>()];
        out += line(words(face["name"]), corners(after, face["corners"]));
      }
    } else {
      out += line("expand", "polygon " + corners(after, after["polygon"]));
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

/// The result in space.
DepthResult wide(const depth::Result<double>& result) {
  DepthResult out;
  out.error = result.error;
  out.stop = result.stop;
  out.verdict = result.verdict;
  out.settled = result.settled;
  out.depth = result.depth;
  out.lower = result.lower;
  out.upper = result.upper;
  out.direction = in_space(result.direction);
  out.translation = in_space(result.translation);
  out.x = in_space(result.x);
  out.y = in_space(result.y);
  out.iterations = result.iterations;
  return out;
}
const DepthResult& wide(const DepthResult& result) { return result; }

/// A corner has been dropped, or more faces than the nearest.
bool is_event(const depth::Record<double>& record) { return !record.outgrown.empty(); }
bool is_event(const depth::space::Record<double>& record) { return record.outgrown.size() > 1; }

class LessonTrace : public AlgorithmTrace {
 public:
  explicit LessonTrace(const DepthResult& result) : result_(result) {}
  [[nodiscard]] const DepthResult& result() const { return result_; }
  [[nodiscard]] double answer(std::string_view) const override { return result_.depth; }

 private:
  DepthResult result_;
};

template <class Trace>
class LessonTraceOf final : public LessonTrace {
 public:
  explicit LessonTraceOf(Trace trace) : LessonTrace(wide(trace.result)), trace_(std::move(trace)) {}

  [[nodiscard]] const Trace& trace() const { return trace_; }
  [[nodiscard]] int steps() const override { return static_cast<int>(trace_.steps.size()); }
  [[nodiscard]] StepInfo info(int step) const override {
    const auto& shown = trace_.steps[step];
    return {shown.iteration, name_of(shown.phase),
            shown.after.stop != depth::StopReason::running || is_event(shown.record)};
  }
  [[nodiscard]] Json json(const Lesson& lesson, const PositionedRun& run) const override {
    return JsonWriter<Trace>(lesson, run, trace_).write();
  }

 private:
  Trace trace_;
};

template <class S, int D, class Trace>
std::shared_ptr<const AlgorithmTrace> traced(const Lesson& lesson, const PositionedRun& run) {
  return with_query_in<S, D>(lesson, placements_of(run), [&](const gjk::Query<S, D>& query) {
    const gjk::Options options = started_as(run, lesson.options);
    if constexpr (D == 3) {
      return std::make_shared<const LessonTraceOf<Trace>>(
          widened_depth<S, D, Trace>(depth::space::trace<S>(query, options)));
    } else {
      return std::make_shared<const LessonTraceOf<Trace>>(
          widened_depth<S, D, Trace>(depth::trace<S>(query, options)));
    }
  });
}

std::shared_ptr<const AlgorithmTrace> run_depth(const Lesson& lesson, const PositionedRun& run,
                                                const AlgorithmTrace*) {
  return with_scalar(lesson.scalar, [&]<class S>(std::type_identity<S>) {
    return lesson.dimension == 3 ? traced<S, 3, DepthTraceInSpace>(lesson, run)
                                 : traced<S, 2, DepthTrace>(lesson, run);
  });
}

const LessonTrace* trace_at(const LessonRun& run, int index) {
  if (run.tour->algorithm != &kDepthAlgorithm) return nullptr;
  return static_cast<const LessonTrace*>(run.algorithm_traces[index].get());
}

template <class S, int D>
DepthResult result_of(const PositionedRun& run, const gjk::Options& options) {
  const std::vector<gjk::Vec<S, D>> x = narrowed_all<S, D>(run.x().world);
  const std::vector<gjk::Vec<S, D>> y = narrowed_all<S, D>(run.y().world);
  return wide(DepthWidener<S, D>(0)(depth::penetration<S>(gjk::Query<S, D>{{x}, {y}}, options)));
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
  const auto* found = dynamic_cast<const LessonTraceOf<DepthTrace>*>(trace_at(run, index));
  return found == nullptr ? nullptr : &found->trace();
}

const DepthTraceInSpace* depth_trace_in_space(const LessonRun& run, int index) {
  const auto* found = dynamic_cast<const LessonTraceOf<DepthTraceInSpace>*>(trace_at(run, index));
  return found == nullptr ? nullptr : &found->trace();
}

const DepthResult* depth_result(const LessonRun& run, int index) {
  const LessonTrace* found = trace_at(run, index);
  return found == nullptr ? nullptr : &found->result();
}

DepthResult depth_of(const PositionedRun& run, const gjk::Options& options, ScalarKind scalar) {
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    return run.trace.dimension == 3 ? result_of<S, 3>(run, options) : result_of<S, 2>(run, options);
  });
}

std::string face_name(const DepthTraceInSpace& trace, int face) {
  const std::vector<depth::space::Face<double>>& first = trace.initial.polytope.faces;
  const auto last = static_cast<std::size_t>(face);
  if (last < first.size() && first[last].is_outgrown) return {};
  int number = face + 1;
  for (std::size_t i = 0; i < std::min(last, first.size()); ++i)
    number -= first[i].is_outgrown ? 1 : 0;
  return fmt::format("f{}", number);
}

}  // namespace gjkscope
