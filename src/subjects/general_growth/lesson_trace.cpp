#include "subjects/general_growth/lesson_trace.hpp"

#include <fmt/format.h>

#include <array>
#include <mutex>
#include <nlohmann/json.hpp>
#include <utility>

#include "run/fields.hpp"

namespace gjkscope {
namespace {

using fields::Json;

constexpr std::array<std::string_view, 3> kPhases = {"size", "time", "claim"};
constexpr std::array<std::string_view, 2> kAnswers = {"visits", "pairs"};
constexpr std::array<PlaceholderInfo, 1> kValues = {
    {{"n", "segments of each outline that the frame is about"}}};

/// Measured once for all runs with the same [growth]: a lesson is run anew for each change of it.
std::shared_ptr<const AlgorithmTrace> run_growth(const Lesson& lesson, const PositionedRun&,
                                                 const AlgorithmTrace*) {
  static std::mutex mutex;
  static std::pair<LessonGrowth, std::shared_ptr<const AlgorithmTrace>> last;
  const std::lock_guard lock(mutex);
  const LessonGrowth& growth = *lesson.settings.as<LessonGrowth>();
  if (last.second == nullptr || !(last.first == growth))
    last = {growth, std::make_shared<const GeneralGrowthTrace>(growth)};
  return last.second;
}

}  // namespace

GeneralGrowthTrace::GeneralGrowthTrace(const LessonGrowth& growth) : times(growth.times) {
  for (const int n : growth.vertices)
    samples.push_back(general_growth::measure(n, growth.runs, growth.seed));
}

GrowthPhase GeneralGrowthTrace::phase(int step) const {
  if (step < sizes()) return GrowthPhase::size;
  return times && step == sizes() ? GrowthPhase::time : GrowthPhase::claim;
}

StepInfo GeneralGrowthTrace::info(int step) const {
  const GrowthPhase at = phase(step);
  return {step + 1, kPhases[static_cast<std::size_t>(at)], at != GrowthPhase::size};
}

bool GeneralGrowthTrace::agrees(Claim claim) const {
  const general_growth::Sample& last = samples.back();
  switch (claim) {
    case Claim::brute_force:
      return times ? times->boxes.back() < times->pairs.back() : last.boxes < last.pairs();
    case Claim::wider_search:
      return last.boxes > last.collide;
    case Claim::coherence:
      break;
  }
  return false;
}

double GeneralGrowthTrace::answer(std::string_view name) const {
  return name == "pairs" ? samples.back().pairs() : samples.back().boxes;
}

Json GeneralGrowthTrace::json(const Lesson&, const PositionedRun&) const {
  Json out = {{"sizes", Json::array()}};
  for (const general_growth::Sample& sample : samples) {
    Json size = {{"segments", sample.segments}, {"runs", sample.runs},
                 {"pairs", sample.pairs()},     {"boxes", sample.boxes},
                 {"circles", sample.circles},   {"remembered", sample.remembered},
                 {"collide", sample.collide}};
    if (sample.pieces >= 0.0) size["pieces"] = sample.pieces;
    out["sizes"].push_back(std::move(size));
  }
  return out;
}

const Algorithm kGeneralGrowthAlgorithm{.name = "general-growth",
                                        .phases = kPhases,
                                        .answers = kAnswers,
                                        .values = kValues,
                                        .run = run_growth,
                                        .takes_outlines = true};

}  // namespace gjkscope
