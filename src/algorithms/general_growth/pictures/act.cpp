#include <fmt/format.h>

#include <array>

#include "algorithms/general_growth/pictures/shown.hpp"
#include "picture/registry.hpp"

namespace gjkscope::costs {
namespace {

std::string position(const LessonRun& run, int index) {
  const Shown shown(run, run.frames[static_cast<std::size_t>(index)]);
  const std::string what = shown.is_size() ? fmt::format("n = {}", grouped(shown.sample().segments))
                           : shown.is_claim() ? "what Larsen says"
                           : shown.over == 0  ? "start"
                                              : "outcome";
  return fmt::format("{} · {} of {}", what, index + 1, run.frames.size());
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (shown.over == 0) return {.group = "start", .label = "S"};
  if (shown.is_size()) return {.group = "segments n", .label = grouped(shown.sample().segments)};
  if (shown.is_claim())
    return {.group = "what Larsen says", .label = std::to_string(shown.over - shown.sizes())};
  return {.group = "outcome", .label = "all n", .event = true};
}

const StagedAct kAct{
    .act = {.name = "general-growth",
            .meaning = "number of segments in [growth], then what Larsen says of the methods",
            .needs = {.table = "growth",
                      .takes_path = false,
                      .why_no_until = "frames show all sizes"},
            .add_frames = add_algorithm_frames,
            .algorithm = &kGeneralGrowthAlgorithm},
    .position = position,
    .tick = tick,
    .words = words,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("Pairs visited as outlines grow"); },
};

constexpr std::array kActs = {&kAct};
constexpr std::array kBlocks = {&kCosts};

}  // namespace
}  // namespace gjkscope::costs

namespace gjkscope::algorithms {

const ShownAlgorithm general_growth{costs::kActs, costs::kBlocks, {}};

}  // namespace gjkscope::algorithms
