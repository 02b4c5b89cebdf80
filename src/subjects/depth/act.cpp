#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "subjects/depth/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::depths {

Shown::Shown(const LessonRun& run, const Frame& frame)
    : trace(*depth_trace(run, frame.run)),
      step(last_step_over(trace.steps, frame)),
      state(step == nullptr ? trace.initial : step->after),
      is_answer(frame.step >= static_cast<int>(trace.steps.size())) {}

bool Shown::is_nearest(const depth::Edge<double>& edge) const {
  return knows_edge() && edge.from == state.edge.from && edge.to == state.edge.to;
}

std::optional<double> Shown::distance(const depth::Edge<double>& edge) const {
  const std::vector<depth::Edge<double>>* measured = nullptr;
  for (const depth::Step<double>& each : trace.steps) {
    if (each.phase == depth::Phase::nearest) measured = &each.record.edges;
    if (&each == step) break;
  }
  if (step == nullptr || measured == nullptr) return std::nullopt;
  const auto found = std::find_if(measured->begin(), measured->end(), [&](const auto& other) {
    return other.from == edge.from && other.to == edge.to;
  });
  if (found == measured->end()) return std::nullopt;
  return std::sqrt(found->distance_sq);
}

std::string ends(const LessonRun& run, const depth::State<double>& state,
                 const depth::Edge<double>& edge) {
  const auto name = [&](int corner) {
    return run.pair_name(state.polygon.corners[static_cast<std::size_t>(corner)].point.pair);
  };
  return edge.from == edge.to ? name(edge.from)
                              : fmt::format("{} to {}", name(edge.from), name(edge.to));
}

std::string edge_name(const LessonRun& run, const depth::State<double>& state,
                      const depth::Edge<double>& edge) {
  return edge.from == edge.to ? fmt::format("the point {}", ends(run, state, edge))
                              : fmt::format("the edge from {}", ends(run, state, edge));
}

namespace {

constexpr std::array kAsks = {kAskEdge};

/// As far as a reader can see, another edge is as near to O as the one that is taken.
bool is_tie(const Shown& shown) {
  constexpr double kSeen = 1e-3;
  const double nearest = shown.distance(shown.state.edge).value_or(0.0);
  const auto& edges = shown.step->record.edges;
  return std::count_if(edges.begin(), edges.end(), [&](const depth::Edge<double>& edge) {
           return shown.distance(edge).value_or(HUGE_VAL) <= (1.0 + kSeen) * nearest;
         }) > 1;
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (question.ask != kAskEdge.name || !shown.is(depth::Phase::nearest)) return -1;
  if (question.at && *question.at != shown.step->iteration) return -1;
  return shown.step->record.edges.size() > 1 && !is_tie(shown) ? frame.step : -1;
}

constexpr std::array<std::string_view, depth::kPhaseCount> kWords = {"nearest edge", "support",
                                                                     "stop", "expand"};

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[static_cast<std::size_t>(index)];
  const Shown shown(run, frame);
  if (shown.step == nullptr) return "start";
  if (shown.is_answer) return fmt::format("answer · {} of {}", index + 1, run.frames.size());
  const std::string_view phase = kWords[static_cast<std::size_t>(shown.step->phase)];
  if (asks_later(run, index)) return fmt::format("iteration {} · {}", shown.step->iteration, phase);
  return fmt::format("iteration {} of {} · {}", shown.step->iteration,
                     shown.trace.result.iterations, phase);
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  const StepInfo at = run.info(frame);
  if (shown.step == nullptr)
    return {.group = group_of_position(run, frame, "GJK's end"), .label = "start"};
  if (shown.is_answer) return {.group = "answer", .label = "t", .event = true};
  return {.group = fmt::format("iteration {}", at.iteration),
          .label = std::string(kWords[static_cast<std::size_t>(shown.step->phase)]),
          .event = at.is_event};
}

/// X, moved by t.
void reach(const LessonRun& run, int index, ViewKind view, Eigen::AlignedBox2d& seen) {
  const depth::Result<double>& result = depth_trace(run, index)->result;
  if (view != ViewKind::world || !result.translation.allFinite()) return;
  for (const Eigen::Vector2d& vertex :
       in_plane(run.runs[static_cast<std::size_t>(index)].x().world))
    seen.extend(vertex + result.translation);
}

const Act kAct{
    .name = "depth",
    .meaning =
        "phase of the polygon that expands where GJK has found the shapes to "
        "overlap; then the shortest way out",
    .needs = {.why_no_until = "frames show how the run ends"},
    .add_frames = add_algorithm_frames,
    .follows_run = true,
    .asks = depths::kAsks,
    .answering_step = depths::answering_step,
    .algorithm = &kDepthAlgorithm,
    .position = depths::position,
    .tick = depths::tick,
    .words = depths::words,
    .stage = depths::stage,
    .reach = depths::reach,
    .question = depths::question,
    .values = depths::values,
};

}  // namespace
}  // namespace gjkscope::depths

namespace gjkscope {

const SubjectParts subjects::depth{
    .acts = {&depths::kAct},
    .blocks = {&depths::kEdges, &depths::kBounds},
    .listings = {&depths::kListing},
    .effects = {&effect_infos::kPenetrationDepth},
    .legend = {{"polygon.vertex", "corner of the polygon"},
               {"support.plane", "support line, normal to n"},
               {"depth.inside", "as far from O as the edge"},
               {"depth.moved", "X, moved by t"}},
};

}  // namespace gjkscope
