#include "subjects/slab_proof/lesson_trace.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "outlines/brute.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using slab_proof::Descent;
using slab_proof::Phase;
using slab_proof::Reach;
using slab_proof::Step;
using slab_proof::Stop;

constexpr std::array<std::string_view, 2> kPhases = {"slab", "closer"};
/// By their numbers, from the one after `running` on.
constexpr std::array<std::string_view, 3> kStops = {"empty-slab", "overlap", "iteration-cap"};
constexpr std::array<std::string_view, 2> kAnswers = {"distance", "slabs"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"distance", "distance of the points by now"},
     {"in the slab", "vertices that lie in the slab"}}};

std::shared_ptr<const AlgorithmTrace> run_slab(const Lesson& lesson, const PositionedRun& run,
                                               const AlgorithmTrace*) {
  const OutlinesOfRun outlines = outlines_of(lesson, run);
  const std::optional<Refusal> refusal = refusal_of(outlines, models::Needs::convex);
  Descent descent;
  if (!refusal && models::brute(outlines.x, outlines.y).answer.overlap) {
    descent.result.stop = Stop::overlap;
  } else if (!refusal) {
    const gjk::VertexPair start = lesson.options.start.pairs[0];
    descent =
        slab_proof::descend(in_plane(run.x().world), in_plane(run.y().world), start.x, start.y);
  }
  return std::make_shared<const SlabTrace>(refusal, std::move(descent));
}

}  // namespace

std::string vertex_name(const Lesson& lesson, const Reach& reach) {
  const LessonShape& shape = reach.of_x ? lesson.x() : lesson.y();
  return fmt::format("vertex {} of {}", shape.vertex_names[reach.vertex], shape.name);
}

SlabTrace::SlabTrace(std::optional<Refusal> refused, Descent descended)
    : OutlineTrace(refused), descent(std::move(descended)) {}

StepInfo SlabTrace::info(int index) const {
  const Step& step = descent.steps[index];
  return {step.before.iteration, kPhases[static_cast<std::size_t>(step.phase)],
          step.phase == Phase::closer || step.after.stop != Stop::running};
}

double SlabTrace::answer(std::string_view name) const {
  if (refusal) return std::numeric_limits<double>::quiet_NaN();
  if (descent.result.stop == Stop::overlap) return 0.0;
  return name == "slabs" ? descent.result.iteration : descent.result.distance();
}

std::string_view SlabTrace::stop() const {
  return refusal ? std::string_view() : kStops[static_cast<std::size_t>(descent.result.stop) - 1];
}

Json SlabTrace::step_json(const Lesson& lesson, int index) const {
  const Step& step = descent.steps[index];
  Json out = {{"x", fields::point(step.after.x)}, {"y", fields::point(step.after.y)}};
  if (step.phase == Phase::slab) {
    out["in_the_slab"] = Json::array();
    for (const Reach& reach : step.reaches)
      out["in_the_slab"].push_back(
          {{"at", vertex_name(lesson, reach)}, {"depth", fields::number(reach.depth)}});
  } else {
    out["towards"] = vertex_name(lesson, step.towards);
    out["distance"] = fields::number(step.after.distance());
  }
  return out;
}

Json SlabTrace::result_json(const Lesson&) const {
  const slab_proof::State& end = descent.result;
  Json out = {{"stop", stop()}};
  if (end.stop == Stop::overlap) return out;
  out["distance"] = fields::number(end.distance());
  out["closest_x"] = fields::point(end.x);
  out["closest_y"] = fields::point(end.y);
  return out;
}

const Algorithm kSlabProofAlgorithm{.name = "slab-proof",
                                    .phases = kPhases,
                                    .answers = kAnswers,
                                    .values = kValues,
                                    .run = run_slab,
                                    .takes_outlines = true,
                                    .stops = kStops};

}  // namespace gjkscope
