#include "subjects/hill_climbing/lesson_trace.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "outlines/polyhedron.hpp"
#include "run/fields.hpp"

namespace gjkscope {
namespace {

using climbing::Look;
using Eigen::Vector3d;
using fields::Json;

constexpr std::array<std::string_view, 2> kPhases = {"move", "stop"};
constexpr std::array<std::string_view, 2> kAnswers = {"walked", "scanned"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"walked", "dot products of the walks by now"},
     {"scanned", "dot products of scans for the same support points"}}};

/// The body that a walk is on: an index of PositionedRun::bodies.
std::size_t body_of(const Climb& climb) { return climb.of_x ? 0 : 1; }

std::shared_ptr<const AlgorithmTrace> run_walks(const Lesson& lesson, const PositionedRun& run,
                                                const AlgorithmTrace* before) {
  auto trace = std::make_shared<ClimbTrace>();
  if (!why_not_drawn(run).empty()) return trace;
  const gjk::VertexPair first = run.trace.initial.simplex.vertices[0].pair;
  std::array<int, 2> at = {first.x, first.y};
  for (std::size_t body = 0; body < 2; ++body)
    trace->neighbours[body] =
        neighbours_of(exact_hull(run.bodies[body].world), run.bodies[body].world.size());
  if (lesson.warm_start && before != nullptr) {
    for (const Climb& climb : climbs_trace(*before).climbs) at[body_of(climb)] = climb.walk.end();
  }
  for (const WideStep& step : run.trace.steps) {
    if (step.phase != gjk::Phase::support) continue;
    for (const std::size_t body : {1, 0}) {
      const std::vector<Vector3d>& points = run.bodies[body].world;
      if (points.size() == 1) continue;
      const climbing::Neighbours& neighbours = trace->neighbours[body];
      const Vector3d d = body == 1 ? step.after.d : Vector3d(-step.after.d);
      const gjk::VertexPair& found = step.after.support.pair;
      Climb climb{step.iteration, body == 0,
                  climbing::walk(points, neighbours, d, climbing::start_at(neighbours, at[body])),
                  body == 0 ? found.x : found.y};
      at[body] = climb.walk.end();
      for (std::size_t i = 0; i < climb.walk.looks.size(); ++i)
        trace->all.push_back({static_cast<int>(trace->climbs.size()), static_cast<int>(i)});
      trace->scanned += static_cast<int>(points.size());
      trace->climbs.push_back(std::move(climb));
    }
  }
  return trace;
}

}  // namespace

StepInfo ClimbTrace::info(int step) const {
  const bool stops = look(step).next < 0;
  return {climb(step).iteration, kPhases[stops ? 1 : 0], stops};
}

int ClimbTrace::walked(int step) const {
  int count = 0;
  for (int i = 0; i < step; ++i) {
    const bool is_first = all[i].look == 0;
    count += (is_first ? 1 : 0) + static_cast<int>(look(i).new_neighbours.size());
  }
  return count;
}

double ClimbTrace::answer(std::string_view name) const {
  return name == "walked" ? walked(steps()) : scanned;
}

Json ClimbTrace::json(const Lesson& lesson, const PositionedRun& run) const {
  Json out = {{"steps", Json::array()}};
  for (int i = 0; i < steps(); ++i) {
    const Climb& of = climb(i);
    const Look& at = look(i);
    const LessonShape& shape = lesson.bodies[body_of(of)];
    const std::vector<Vector3d>& points = run.bodies[body_of(of)].world;
    const auto name = [&](int vertex) { return shape.vertex_names[vertex]; };
    const auto product = [&](int vertex) {
      return Json{{"vertex", name(vertex)},
                  {"value", fields::number(gjk::dot<double, 3>(of.walk.d, points[vertex]))}};
    };
    Json step = {{"phase", info(i).phase}, {"iteration", of.iteration},
                 {"of", shape.name},       {"d", fields::point(of.walk.d)},
                 {"at", name(at.at)},      {"products", Json::array()}};
    if (all[i].look == 0) step["products"].push_back(product(at.at));
    for (const int vertex : at.new_neighbours) step["products"].push_back(product(vertex));
    if (at.next >= 0) step["next"] = name(at.next);
    out["steps"].push_back(std::move(step));
  }
  out["walked"] = walked(steps());
  out["scanned"] = scanned;
  return out;
}

const Algorithm kHillClimbingAlgorithm{.name = "hill-climbing",
                                       .phases = kPhases,
                                       .answers = kAnswers,
                                       .values = kValues,
                                       .run = run_walks};

}  // namespace gjkscope
