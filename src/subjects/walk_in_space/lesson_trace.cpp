#include "subjects/walk_in_space/lesson_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "gjk/gjk.hpp"
#include "run/fields.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using v_clip::Reason;

constexpr std::array<std::string_view, 2> kPhases = {"closest", "regions"};
constexpr std::array<std::string_view, 2> kAnswers = {"distance", "pairs"};
constexpr std::array<PlaceholderInfo, 1> kValues = {
    {{"pairs", "pairs of features that the walk has looked at by now"}}};
constexpr std::array<std::string_view, 13> kReasons = {
    "holds",      "edge-end",    "face-side",     "clip-side",   "clip-end",
    "clip-empty", "two-faces",   "vertex-border", "edge-border", "behind-face",
    "meet",       "penetration", "inside"};

/// A body's features in the order of SpaceWalk::features: faces, edges, vertices.
struct Numbering {
  const v_clip::Body& body;
  [[nodiscard]] int number(v_clip::Feature of) const {
    if (of.kind == v_clip::Kind::face) return of.index;
    if (of.kind == v_clip::Kind::edge) return of.index + static_cast<int>(body.faces.size());
    const auto at = std::lower_bound(body.vertices.begin(), body.vertices.end(), of.index);
    return static_cast<int>(body.faces.size() + body.edges.size()) +
           static_cast<int>(at - body.vertices.begin());
  }
  [[nodiscard]] v_clip::Feature feature(int number) const {
    const int faces = static_cast<int>(body.faces.size());
    const int edges = static_cast<int>(body.edges.size());
    if (number < faces) return {v_clip::Kind::face, number};
    if (number < faces + edges) return {v_clip::Kind::edge, number - faces};
    return {v_clip::Kind::vertex, body.vertices[number - faces - edges]};
  }
};

/// The feature with the same vertices as one of another position; else the first vertex.
int found(const std::vector<cells::Feature>& features, const std::vector<int>& vertices) {
  const auto is_it = [&](const cells::Feature& each) {
    return std::is_permutation(each.vertices.begin(), each.vertices.end(), vertices.begin(),
                               vertices.end());
  };
  auto at = std::find_if(features.begin(), features.end(), is_it);
  if (at == features.end())
    at = std::find_if(features.begin(), features.end(),
                      [](const auto& each) { return each.kind() == cells::Kind::vertex; });
  return static_cast<int>(at - features.begin());
}

/// The border of the step's region that its point lies beyond, or on: one that `is_it` holds for.
template <class IsIt>
int border_of(const SpaceWalk& walk, const SpaceWalk::Step& step, const IsIt& is_it) {
  const std::vector<cells::Border>& borders = walk.feature(step).borders;
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const double depth = borders[i].depth(step.points[1 - step.body]);
    if (!is_it(borders[i].beyond) || depth >= least) continue;
    least = depth;
    found = static_cast<int>(i);
  }
  return found;
}

/// The steps of a walk: one for each pair that is left, two for a pair that is proved.
void tell(SpaceWalk& walk, const v_clip::Trace& trace, const std::array<Numbering, 2>& by) {
  SpaceWalk::Step at;
  for (const v_clip::Step& step : trace.steps) {
    const v_clip::State& state = step.after;
    const bool is_over = state.stop != v_clip::Stop::running;
    if (step.phase == v_clip::Phase::swap) continue;
    if (step.phase == v_clip::Phase::closest || state.stop == v_clip::Stop::overlap)
      at.points = {step.points.x, step.points.y};
    at.number = state.swaps + 1;
    at.at = at.next = {by[0].number(state.x), by[1].number(state.y)};
    at.is_region = step.phase == v_clip::Phase::regions;
    at.reason = state.next.reason;
    if (state.stop == v_clip::Stop::closest) {
      for (at.body = 0; at.body < 2; ++at.body) walk.all.push_back(at);
    } else if (is_over) {
      at.body = state.x.kind == v_clip::Kind::face ? 0 : 1;
      walk.all.push_back(at);
    } else if (at.reason != Reason::none) {
      at.next = {by[0].number(state.next.x), by[1].number(state.next.y)};
      at.body = at.next[0] != at.at[0] ? 0 : 1;
      const std::vector<cells::Feature>& features = walk.features[at.body];
      const bool is_behind = at.reason == Reason::behind_face;
      at.border = border_of(walk, at, [&](int beyond) {
        if (is_behind || beyond < 0) return is_behind && beyond < 0;
        if (at.is_region) return beyond == by[at.body].number(step.record.tests.back().beyond);
        // The boundary between both, or a side of a face that the next vertex ends.
        const std::vector<int>& side = features[beyond].vertices;
        const std::vector<int>& next = features[at.next[at.body]].vertices;
        return side.size() < features[at.at[at.body]].vertices.size() &&
               std::all_of(next.begin(), next.end(), [&](int vertex) {
                 return std::find(side.begin(), side.end(), vertex) != side.end();
               });
      });
      walk.all.push_back(at);
      at.border = -1;
    }
  }
}

std::shared_ptr<const AlgorithmTrace> run_space_walk(const Lesson& lesson, const PositionedRun& run,
                                                     const AlgorithmTrace* before) {
  auto walk = std::make_shared<SpaceWalk>();
  if (!why_not_drawn(run).empty()) return walk;
  for (const std::size_t body : {0, 1}) {
    const std::vector<Eigen::Vector3d>& world = run.bodies[body].world;
    walk->features[body] = cells::features_of(exact_hull(world), world);
    if (walk->features[body].empty()) return walk;
  }
  const v_clip::Body x = v_clip::body_of(run.x().world);
  const v_clip::Body y = v_clip::body_of(run.y().world);
  const std::array<Numbering, 2> by = {{{x}, {y}}};
  const gjk::VertexPair first = lesson.options.start.pairs[0];
  std::array<std::vector<int>, 2> from = {{{first.x}, {first.y}}};
  if (lesson.warm_start && before != nullptr && before->steps() > 0) {
    const SpaceWalk& last = space_walk_trace(*before);
    for (const std::size_t body : {0, 1})
      from[body] = last.features[body][last.all.back().at[body]].vertices;
  }
  const v_clip::Query query{x, y};
  const v_clip::State start = v_clip::start(query, by[0].feature(found(walk->features[0], from[0])),
                                            by[1].feature(found(walk->features[1], from[1])));
  tell(*walk, v_clip::trace(query, start), by);
  if (lesson.path_of_shapes) {
    gjk::Options options;
    options.start = lesson.options.start;
    walk->cold =
        gjk::distance<double>(gjk::Query<double, 3>{{x.points}, {y.points}}, options).iterations;
  }
  return walk;
}

}  // namespace

StepInfo SpaceWalk::info(int step) const {
  const Step& at = all[step];
  return {at.number, kPhases[at.is_region ? 1 : 0], at.moves() || step + 1 == steps()};
}

double SpaceWalk::answer(std::string_view name) const {
  if (all.empty()) return std::numeric_limits<double>::quiet_NaN();
  return name == "pairs" ? pairs() : overlaps() ? 0.0 : all.back().distance();
}

Json SpaceWalk::json(const Lesson& lesson, const PositionedRun&) const {
  Json out = {{"steps", Json::array()}};
  for (int i = 0; i < steps(); ++i) {
    const Step& at = all[i];
    Json step = {{"phase", info(i).phase},
                 {"iteration", at.number},
                 {"x", name(lesson, 0, at.at[0])},
                 {"y", name(lesson, 1, at.at[1])},
                 {"distance", fields::number(at.distance())},
                 {"of", lesson.bodies[at.body].name},
                 {"reason", kReasons[static_cast<std::size_t>(at.reason)]}};
    if (at.moves()) {
      step["border"] = name(lesson, at.body, border(at).beyond);
      step["beyond"] = fields::number(beyond(at));
      step["next_x"] = name(lesson, 0, at.next[0]);
      step["next_y"] = name(lesson, 1, at.next[1]);
    }
    out["steps"].push_back(std::move(step));
  }
  if (all.empty()) return out;
  out["pairs"] = pairs();
  out["distance"] = fields::number(answer("distance"));
  out["overlap"] = overlaps();
  out["closest_x"] = fields::point(all.back().points[0]);
  out["closest_y"] = fields::point(all.back().points[1]);
  if (lesson.path_of_shapes) out["gjk_cold"] = cold;
  return out;
}

std::string SpaceWalk::name(const Lesson& lesson, std::size_t body, int feature) const {
  const LessonShape& shape = lesson.bodies[body];
  if (feature < 0) return shape.name;
  return fmt::format("{} of {}", cells::name_of(features[body][feature], shape), shape.name);
}

const Algorithm kWalkInSpaceAlgorithm{.name = "lin-canny-in-space",
                                      .phases = kPhases,
                                      .answers = kAnswers,
                                      .values = kValues,
                                      .run = run_space_walk};

}  // namespace gjkscope
