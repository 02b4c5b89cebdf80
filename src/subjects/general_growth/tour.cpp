#include <fmt/format.h>

#include <array>

#include "subjects/general_growth/shown.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::costs {
namespace {

std::string position(const LessonRun& run, int index) {
  const Shown shown(run, run.frames[index]);
  const std::string what = shown.is(GrowthPhase::size)
                               ? fmt::format("n = {}", grouped(shown.sample().segments))
                           : shown.is(GrowthPhase::time)  ? "times"
                           : shown.is(GrowthPhase::claim) ? "what Larsen says"
                           : shown.over == 0              ? "start"
                                                          : "outcome";
  return fmt::format("{} · {} of {}", what, index + 1, run.frames.size());
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (shown.over == 0) return {.group = "start", .label = "start"};
  if (shown.is(GrowthPhase::size))
    return {.group = "segments n", .label = grouped(shown.sample().segments)};
  if (shown.is(GrowthPhase::time)) return {.group = "times", .label = "all n"};
  if (shown.is(GrowthPhase::claim))
    return {.group = "what Larsen says", .label = std::to_string(shown.claim_number())};
  return {.group = "outcome", .label = "all n", .event = true};
}

constexpr std::array kAsks = {kAskVisits, kAskMethod, kAskAgrees};

/// The claim about coherence (not exploited in 1998) is not asked about: nothing that was measured
/// bears on it.
int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (question.ask == kAskMethod.name)
    return shown.is(GrowthPhase::time) && !question.at ? shown.over - 1 : -1;
  const auto is_asked = [&](int number) { return question.at.value_or(number) == number; };
  const bool answers = question.ask == kAskVisits.name
                           ? shown.is(GrowthPhase::size) && shown.over > 1 && is_asked(shown.over)
                           : shown.is(GrowthPhase::claim) && shown.claim() < Claim::coherence &&
                                 is_asked(shown.claim_number());
  return answers ? shown.over - 1 : -1;
}

const Tour kTour{
    .name = "general-growth",
    .meaning =
        "number of segments in [growth], then their times, then what Larsen says of "
        "the methods",
    .needs = {.settings = &LessonGrowth::kKind,
              .path = PathUse::refused,
              .why_no_until = "frames show all sizes"},
    .add_frames = add_algorithm_frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kGeneralGrowthAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("As outlines grow"); },
};

}  // namespace
}  // namespace gjkscope::costs

namespace gjkscope {

const SubjectParts subjects::general_growth{
    .tours = {&costs::kTour},
    .blocks = {&costs::kCosts},
};

}  // namespace gjkscope
