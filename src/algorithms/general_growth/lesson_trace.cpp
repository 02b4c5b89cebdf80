#include "algorithms/general_growth/lesson_trace.hpp"

#include <fmt/format.h>

#include <array>
#include <mutex>
#include <utility>

#include "trace/fields.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using general_growth::Sample;

constexpr std::array<std::string_view, 2> kPhases = {"size", "claim"};
constexpr std::array<std::string_view, 2> kAnswers = {"visits", "pairs"};
constexpr std::array<PlaceholderInfo, 1> kValues = {
    {{"n", "segments of each outline that the frame is about"}}};

/// Measured once for all runs with the same [growth]: a lesson is run anew for each change of it.
std::shared_ptr<const AlgorithmTrace> run_growth(const Lesson& lesson, const RunIn<2>&,
                                                 const AlgorithmTrace*) {
  static std::mutex mutex;
  static std::pair<LessonGrowth, std::shared_ptr<const AlgorithmTrace>> last;
  const std::lock_guard lock(mutex);
  if (last.second == nullptr || !(last.first == *lesson.growth))
    last = {*lesson.growth, std::make_shared<const GeneralGrowthTrace>(*lesson.growth)};
  return last.second;
}

}  // namespace

GeneralGrowthTrace::GeneralGrowthTrace(const LessonGrowth& growth) {
  for (const int n : growth.vertices)
    samples.push_back(general_growth::measure(n, growth.runs, growth.seed));
}

StepInfo GeneralGrowthTrace::info(int step) const {
  const bool is_claim = step >= static_cast<int>(samples.size());
  return {step + 1, kPhases[is_claim ? 1 : 0], is_claim};
}

double GeneralGrowthTrace::answer(std::string_view name) const {
  return name == "pairs" ? samples.back().pairs() : samples.back().boxes;
}

Json GeneralGrowthTrace::json(const Lesson&, const RunIn<2>&) const {
  Json out = {{"sizes", Json::array()}};
  for (const Sample& sample : samples) {
    Json size = {{"segments", sample.segments}, {"runs", sample.runs},
                 {"pairs", sample.pairs()},     {"boxes", sample.boxes},
                 {"circles", sample.circles},   {"remembered", sample.remembered},
                 {"collide", sample.collide}};
    if (sample.pieces >= 0.0) size["pieces"] = sample.pieces;
    out["sizes"].push_back(std::move(size));
  }
  return out;
}

std::string GeneralGrowthTrace::text(const Lesson&, const RunIn<2>&) const {
  std::string out = "\ngeneral-growth\n";
  for (const Sample& sample : samples) {
    std::string counts =
        fmt::format("boxes {:.1f}, circles {:.1f}, remembered {:.1f}, collide {:.1f}", sample.boxes,
                    sample.circles, sample.remembered, sample.collide);
    if (sample.pieces >= 0.0) counts += fmt::format(", pieces {:.1f}", sample.pieces);
    out += fields::line(fmt::format("n {}", sample.segments), counts);
  }
  return out;
}

const Algorithm kGeneralGrowthAlgorithm{.name = "general-growth",
                                        .phases = kPhases,
                                        .answers = kAnswers,
                                        .values = kValues,
                                        .run = run_growth};

}  // namespace gjkscope
