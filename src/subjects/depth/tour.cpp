#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "run/questions.hpp"
#include "subjects/depth/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::depths {

using depth::Phase;

Shown::Shown(const LessonRun& run, const Frame& frame)
    : ShownPart(*depth_trace(run, frame.run), run, frame) {}

bool Shown::is_nearest(const depth::Edge<double>& edge) const {
  return knows_nearest() && edge.from == state.edge.from && edge.to == state.edge.to;
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
    return run.pair_name(state.polygon.corners[corner].point.pair);
  };
  return edge.from == edge.to ? name(edge.from)
                              : fmt::format("{} to {}", name(edge.from), name(edge.to));
}

std::string edge_name(const LessonRun& run, const depth::State<double>& state,
                      const depth::Edge<double>& edge) {
  return edge.from == edge.to ? fmt::format("the point {}", ends(run, state, edge))
                              : fmt::format("the edge from {}", ends(run, state, edge));
}

ShownInSpace::ShownInSpace(const LessonRun& run, const Frame& frame)
    : ShownPart(*depth_trace_in_space(run, frame.run), run, frame) {}

std::array<Eigen::Vector3d, 3> ShownInSpace::corners(int of) const {
  return {polytope().at(face(of), 0), polytope().at(face(of), 1), polytope().at(face(of), 2)};
}

Eigen::Vector3d ShownInSpace::middle(int of) const {
  const auto [a, b, c] = corners(of);
  return (a + b + c) / 3.0;
}

std::vector<int> ShownInSpace::faces() const {
  std::vector<int> out;
  for (int i = 0; i < static_cast<int>(polytope().faces.size()); ++i) {
    if (!face(i).is_outgrown) out.push_back(i);
  }
  return out;
}

bool ShownInSpace::is_visible(int of) const {
  if (!is(Phase::stop) || has_stopped()) return false;
  const std::vector<int>& seen = std::next(step)->record.outgrown;
  return std::find(seen.begin(), seen.end(), of) != seen.end();
}

bool ShownInSpace::is_new(int of) const {
  if (!is(Phase::expand)) return false;
  const std::vector<int>& added = step->record.added;
  return std::find(added.begin(), added.end(), of) != added.end();
}

Eigen::Vector3d ShownInSpace::foot() const {
  return state.n * (state.n.dot(polytope().at(face(state.face), 0)) / state.n.squaredNorm());
}

namespace {

constexpr std::array kAsks = {kAskEdge, kAskFace, kAskVisible, kAskBeyond, asks::kSupport};

/// One value alone is the least, as far as a reader can see.
bool are_distinct(const std::vector<double>& values) {
  constexpr double kSeen = 1e-3;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double limit = *least + kSeen * (*most - *least);
  return *least < *most && std::count_if(values.begin(), values.end(),
                                         [&](double each) { return each <= limit; }) == 1;
}

std::vector<double> distances(const Shown& shown) {
  std::vector<double> out;
  for (const depth::Edge<double>& edge : shown.step->record.edges)
    out.push_back(std::sqrt(edge.distance_sq));
  return out;
}
std::vector<double> distances(const ShownInSpace& shown) {
  std::vector<double> out;
  for (const int face : shown.step->record.faces)
    out.push_back(std::sqrt(std::max(0.0, shown.face(face).distance_sq)));
  return out;
}

bool has_one_support_point(const auto& record) {
  for (const auto* scan : {&record.scan_x, &record.scan_y}) {
    std::vector<double> values;
    for (const gjk::ScanEntry<double>& entry : *scan) values.push_back(-entry.value);
    if (!are_distinct(values)) return false;
  }
  return true;
}

/// The number of faces that the step after a stop test drops; 0 where there is none.
std::size_t dropped_after(const Shown&) { return 0; }
std::size_t dropped_after(const ShownInSpace& shown) {
  return shown.has_stopped() ? 0 : std::next(shown.step)->record.outgrown.size();
}

template <class S>
bool answers(const S& shown, const LessonQuestion& question) {
  if (shown.step == nullptr || shown.is_answer) return false;
  if (question.at && *question.at != shown.step->iteration) return false;
  if (question.ask == asks::kSupport.name)
    return shown.is(Phase::support) && has_one_support_point(shown.step->record);
  if (question.ask == kAskBeyond.name) return shown.is(Phase::support);
  if (question.ask == kAskVisible.name) return shown.is(Phase::stop) && dropped_after(shown) == 2;
  return question.ask == (std::is_same_v<S, Shown> ? kAskEdge : kAskFace).name &&
         shown.is(Phase::nearest) && are_distinct(distances(shown));
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const bool found = is_in_space(run) ? answers(ShownInSpace(run, frame), question)
                                      : answers(Shown(run, frame), question);
  return found ? frame.step : -1;
}

/// Along a path the answer says why the search stops.
void frames(LessonRun& run, int index) {
  const std::size_t before = run.frames.size();
  add_algorithm_frames(run, index);
  if (run.runs.size() > 1 && run.frames.size() > before + 2) run.frames.erase(run.frames.end() - 2);
}

std::string phase_of(const LessonRun& run, const Frame& frame) {
  const StepInfo at = run.info(frame);
  if (at.phase != name_of(Phase::nearest)) return std::string(at.phase);
  return is_in_space(run) ? "nearest face" : "nearest edge";
}

bool is_at_answer(const LessonRun& run, const Frame& frame) {
  return frame.step >= run.algorithm_trace(frame).steps();
}

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  if (frame.step < 0) return "start";
  if (is_at_answer(run, frame))
    return fmt::format("answer · {} of {}", index + 1, run.frames.size());
  const std::string phase = phase_of(run, frame);
  if (run.runs.size() > 1) return fmt::format("{} · {}", position_on_path(run, index), phase);
  const int iteration = run.info(frame).iteration;
  if (asks_later(run, index)) return fmt::format("iteration {} · {}", iteration, phase);
  return fmt::format("iteration {} of {} · {}", iteration, depth_result(run, frame.run)->iterations,
                     phase);
}

Tick tick(const LessonRun& run, const Frame& frame) {
  if (frame.step < 0)
    return {.group = group_of_position(run, frame, "GJK's end"), .label = "start"};
  if (is_at_answer(run, frame))
    return {.group = group_of_position(run, frame, "answer"), .label = "t", .event = true};
  const StepInfo at = run.info(frame);
  return {.group = group_of_position(run, frame, fmt::format("iteration {}", at.iteration)),
          .label = phase_of(run, frame),
          .event = at.is_event};
}

/// X, moved by t.
void reach(const LessonRun& run, int index, ViewKind view, Eigen::AlignedBox2d& seen) {
  const DepthResult& result = *depth_result(run, index);
  if (view != ViewKind::world || !result.translation.allFinite()) return;
  for (const Eigen::Vector3d& vertex : run.runs[index].x().world)
    seen.extend(in_plane(vertex + result.translation));
}

const Tour kTour{
    .name = "depth",
    .meaning =
        "phase of the polygon, in space the polytope, that expands where GJK has found the shapes "
        "to overlap; then the shortest way out",
    .needs = {.shown_of = ShownOf::both, .why_no_until = "frames show how the run ends"},
    .add_frames = depths::frames,
    .follows_run = true,
    .asks = depths::kAsks,
    .answering_step = depths::answering_step,
    .algorithm = &kDepthAlgorithm,
    .position = depths::position,
    .tick = depths::tick,
    .words = depths::words,
    .stage =
        [](SceneBuilder& scene) {
          is_in_space(scene.run) ? depths::stage_in_space(scene) : depths::stage(scene);
        },
    .reach = depths::reach,
    .question = depths::question,
    .values = depths::values,
};

}  // namespace
}  // namespace gjkscope::depths

namespace gjkscope {

const SubjectParts subjects::depth{
    .tours = {&depths::kTour},
    .blocks = {&depths::kEdges, &depths::kFaces, &depths::kBounds},
    .listings = {&depths::kListing},
    .effects = {&effect_infos::kPenetrationDepth},
    .legend = {{"polygon.vertex", "corner of the polygon"},
               {"polytope.vertex", "corner of the polytope"},
               {"support.plane", "support line, normal to n"},
               {"depth.plane", "support plane, normal to n"},
               {"depth.face", "face nearest to O"},
               {"depth.foot", "foot of the perpendicular from O"},
               {"depth.visible", "face visible from V"},
               {"depth.new", "new face"},
               {"depth.horizon", "horizon"},
               {"depth.inside", "as far from O as the edge"},
               {"depth.moved", "X, moved by t"}},
};

}  // namespace gjkscope
