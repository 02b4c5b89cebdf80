#include "subjects/minkowski_sum/lesson_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

namespace gjkscope {
namespace {

using fields::Json;
using minkowski_sum::Corner;
using minkowski_sum::Merge;
using minkowski_sum::OriginSide;
using minkowski_sum::Phase;
using minkowski_sum::Source;
using minkowski_sum::Step;

constexpr std::array<std::string_view, 3> kPhases = {"lowest", "edge", "inside"};
constexpr std::array<std::string_view, 2> kAnswers = {"corners", "overlap"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"edges of y", "edges of Y that the difference has by now"},
     {"edges of x", "edges of −X that the difference has by now"}}};
constexpr std::array<std::string_view, 3> kPlaces = {"outside", "on-edge", "inside"};

std::string edge_of(const LessonShape& shape, const models::Ring& ring, int from) {
  const auto name = [&](int i) { return shape.vertex_names[ring.index[i]]; };
  return name(from) + name(ring.next(from));
}

std::shared_ptr<const AlgorithmTrace> run_sum(const Lesson& lesson, const PositionedRun& run,
                                              const AlgorithmTrace*) {
  const OutlinesOfRun outlines = outlines_of(lesson, run);
  const std::optional<Refusal> refusal = refusal_of(outlines, models::Needs::convex);
  if (refusal) return std::make_shared<const SumTrace>(refusal, Merge{});
  return std::make_shared<const SumTrace>(
      std::nullopt, minkowski_sum::merge(models::ring_of(outlines.x.outlines[0]),
                                         models::ring_of(outlines.y.outlines[0])));
}

}  // namespace

std::string corner_name(const Lesson& lesson, const Merge& merge, const Corner& corner) {
  const auto at = [](const std::vector<int>& index, int i) { return index[i]; };
  return pair_name(lesson.x().vertex_names, lesson.y().vertex_names,
                   {at(merge.x.index, corner.x), at(merge.y.index, corner.y)});
}

std::string edge_name(const Lesson& lesson, const Merge& merge, const Corner& from, Source source) {
  const std::string of_y =
      fmt::format("{} of {}", edge_of(lesson.y(), merge.y, from.y), lesson.y().name);
  const std::string of_x =
      fmt::format("{} of −{}", edge_of(lesson.x(), merge.x, from.x), lesson.x().name);
  if (source == Source::both) return fmt::format("edges {} and {}", of_y, of_x);
  return "edge " + (source == Source::y ? of_y : of_x);
}

SumTrace::SumTrace(std::optional<Refusal> refused, Merge merged)
    : OutlineTrace(refused), merge(std::move(merged)) {}

StepInfo SumTrace::info(int step) const {
  const Phase phase = merge.steps[step].phase;
  return {std::max(step, 1), kPhases[static_cast<std::size_t>(phase)], phase == Phase::inside};
}

double SumTrace::answer(std::string_view name) const {
  if (refusal) return std::numeric_limits<double>::quiet_NaN();
  if (name == "overlap") return merge.origin == OriginSide::outside ? 0.0 : 1.0;
  return static_cast<double>(merge.corners.size());
}

Json SumTrace::step_json(const Lesson& lesson, int index) const {
  const Step& step = merge.steps[index];
  if (step.phase == Phase::inside)
    return {{"origin", kPlaces[static_cast<std::size_t>(merge.origin)]}};
  Json out;
  if (step.phase == Phase::edge)
    out["from"] = edge_name(lesson, merge, step.before.at, step.source);
  out["corner"] = corner_name(lesson, merge, step.after.at);
  out["point"] = fields::point(merge.at(step.after.at));
  return out;
}

Json SumTrace::result_json(const Lesson& lesson) const {
  Json corners = Json::array();
  for (const Corner& corner : merge.corners) corners.push_back(corner_name(lesson, merge, corner));
  return {{"corners", corners},
          {"sums", merge.corners.size()},
          {"all_sums", merge.x.size() * merge.y.size()},
          {"origin", kPlaces[static_cast<std::size_t>(merge.origin)]},
          {"overlap", merge.origin != OriginSide::outside}};
}

const Algorithm kMinkowskiSumAlgorithm{.name = "minkowski-sum",
                                       .phases = kPhases,
                                       .answers = kAnswers,
                                       .values = kValues,
                                       .run = run_sum,
                                       .takes_outlines = true};

}  // namespace gjkscope
