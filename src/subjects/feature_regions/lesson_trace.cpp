#include "subjects/feature_regions/lesson_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gjk/vector.hpp"
#include "run/fields.hpp"

namespace gjkscope {
namespace {

using cells::Feature;
using cells::Kind;
using Eigen::Vector3d;
using fields::Json;
using Phase = RegionsTrace::Phase;

constexpr std::array<std::string_view, 8> kPhases = {"one",    "kind",  "all",  "query",
                                                     "region", "plane", "slab", "pair"};
constexpr std::array<std::string_view, 2> kAnswers = {"regions", "in-slab"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"regions", "Voronoi regions outside of Y"},
     {"in slab", "vertices that reach into the slab of the first pair"}}};

/// The feature of a kind whose region a picture shows best: beside the body, a little in front.
int shown_of_kind(const std::vector<Feature>& features, Kind kind, const Lesson& lesson) {
  const Vector3d best =
      axes_of(lesson.views[0].eye.value_or(Eye{})).transpose() * Vector3d(1.0, 0.6, 0.3);
  const auto shown = [&](const Feature& feature) {
    return feature.kind() == kind ? gjk::dot(best, feature.outwards) : -2.0;
  };
  return static_cast<int>(
      std::max_element(features.begin(), features.end(),
                       [&](const Feature& a, const Feature& b) { return shown(a) < shown(b); }) -
      features.begin());
}

/// In the first run regions by kind, then in each the one that holds Q.
void tell_regions(RegionsTrace& trace, const Lesson& lesson, bool is_first) {
  for (int i = 0; is_first && i < cells::kKinds; ++i) {
    const Kind kind = static_cast<Kind>(i);
    trace.all.push_back({Phase::one, 0, 1, kind, shown_of_kind(trace.features[1], kind, lesson)});
    trace.all.push_back({Phase::kind, 0, 1, kind});
  }
  if (is_first) trace.all.push_back({Phase::all});
  trace.all.push_back({Phase::query});
}

/// The first pair, from the vertices that the run starts with, unless both regions hold; then the
/// closest points.
void tell_pairs(RegionsTrace& trace, const Lesson& lesson, const PositionedRun& run) {
  RegionsTrace::Pair first;
  const gjk::VertexPair start = lesson.options.start.pairs[0];
  for (const std::size_t body : {0, 1}) {
    const std::vector<Feature>& features = trace.features[body];
    auto at = std::find_if(features.begin(), features.end(), [&](const Feature& feature) {
      return feature.vertices == std::vector<int>{body == 0 ? start.x : start.y};
    });
    if (at == features.end()) at = features.end() - 1;
    first.features[body] = static_cast<int>(at - features.begin());
    first.points[body] = run.bodies[body].world[at->vertices[0]];
  }
  trace.pairs.insert(trace.pairs.begin(), first);
  const Vector3d difference = unit(first.points[1] - first.points[0]);
  for (const std::size_t body : {0, 1}) {
    for (const Feature& feature : trace.features[body]) {
      if (feature.kind() != Kind::vertex) continue;
      const Vector3d& vertex = run.bodies[body].world[feature.vertices[0]];
      const double depth = gjk::dot(difference, Vector3d(vertex - first.points[body]));
      // More than rounding.
      if ((body == 0 ? depth : -depth) > 0x1p-46 * (vertex.norm() + first.points[body].norm()))
        trace.reaches.emplace_back(body, feature.vertices[0]);
    }
  }
  const auto is_refuted = [&](const RegionsTrace::Step& step) {
    return trace.border(step).depth(trace.point(step)) < 0.0;
  };
  if (!trace.reaches.empty()) {
    trace.all.push_back({Phase::region});
    if (!is_refuted(trace.all.back())) trace.all.push_back({Phase::region, 0, 0});
    trace.all.push_back({Phase::slab});
  }
  for (const std::size_t body : {1, 0}) {
    trace.all.push_back({Phase::region, 1, body});
    trace.all.push_back({Phase::plane, 1, body});
  }
  trace.all.push_back({Phase::slab, 1});
  if (!trace.reaches.empty()) trace.all.push_back({Phase::pair, 1});
}

std::shared_ptr<const AlgorithmTrace> find_regions(const Lesson& lesson, const PositionedRun& run,
                                                   const AlgorithmTrace* before) {
  auto trace = std::make_shared<RegionsTrace>();
  if (!why_not_drawn(run).empty()) return trace;
  const bool is_query = lesson.x().vertices.size() == 1;
  for (std::size_t body = is_query ? 1 : 0; body < 2; ++body) {
    const std::vector<Vector3d>& world = run.bodies[body].world;
    trace->features[body] = cells::features_of(exact_hull(world), world);
    if (trace->features[body].empty()) return trace;
  }
  const WideResult& result = run.trace.result;
  const bool is_apart = result.distance > 0.0;
  RegionsTrace::Pair& closest = trace->pairs.emplace_back();
  closest.points = {result.x, result.y};
  if (is_query) closest.points[0] = run.x().world[0];
  for (std::size_t body = is_query ? 1 : 0; body < 2 && is_apart; ++body)
    closest.features[body] = cells::holding(trace->features[body], closest.points[1 - body]);
  if (is_query) {
    tell_regions(*trace, lesson, before == nullptr);
  } else if (is_apart) {
    tell_pairs(*trace, lesson, run);
  }
  return trace;
}

}  // namespace

StepInfo RegionsTrace::info(int step) const {
  const Step& at = all[step];
  const bool has_kind = at.phase == Phase::one || at.phase == Phase::kind;
  const int number = has_kind                   ? static_cast<int>(at.kind) + 1
                     : at.phase == Phase::all   ? cells::kKinds + 1
                     : at.phase == Phase::query ? cells::kKinds + 2
                                                : at.pair + 1;
  return {number, kPhases[static_cast<std::size_t>(at.phase)], step + 1 == steps()};
}

int RegionsTrace::count(Kind kind) const {
  return static_cast<int>(
      std::count_if(features[1].begin(), features[1].end(),
                    [&](const Feature& feature) { return feature.kind() == kind; }));
}

double RegionsTrace::answer(std::string_view name) const {
  return static_cast<double>(name == "regions" ? features[1].size() : reaches.size());
}

Json RegionsTrace::json(const Lesson& lesson, const PositionedRun&) const {
  Json out = {{"steps", Json::array()}};
  for (int i = 0; i < steps(); ++i) {
    const Step& at = all[i];
    Json step = {{"phase", info(i).phase}, {"iteration", info(i).iteration}};
    if (at.phase == Phase::kind) step["count"] = count(at.kind);
    const bool has_point = at.phase == Phase::query || at.phase == Phase::region;
    if ((has_point || at.phase == Phase::one) && feature(at) >= 0) {
      step["feature"] = name(lesson, at.body, feature(at));
      step["borders"] = Json::array();
      for (const cells::Border& border : borders(at)) {
        Json plane = {{"beyond", name(lesson, at.body, border.beyond)}};
        if (has_point) plane["depth"] = fields::number(border.depth(point(at)));
        step["borders"].push_back(std::move(plane));
      }
    }
    if (at.phase == Phase::slab) step["width"] = fields::number(pairs[at.pair].distance());
    out["steps"].push_back(std::move(step));
  }
  for (const std::string_view each : kAnswers)
    out[std::string(each)] = static_cast<int>(answer(each));
  return out;
}

std::string RegionsTrace::name(const Lesson& lesson, std::size_t body, int feature) const {
  const LessonShape& shape = lesson.bodies[body];
  if (feature < 0) return shape.name;
  const std::string out = cells::name_of(features[body][feature], shape);
  return lesson.x().vertices.size() == 1 ? out : fmt::format("{} of {}", out, shape.name);
}

const Algorithm kFeatureRegionsAlgorithm{.name = "feature-regions",
                                         .phases = kPhases,
                                         .answers = kAnswers,
                                         .values = kValues,
                                         .run = find_regions};

}  // namespace gjkscope
