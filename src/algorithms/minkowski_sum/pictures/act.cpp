#include <array>

#include "algorithms/minkowski_sum/pictures/shown.hpp"
#include "picture/registry.hpp"

namespace gjkscope::sums {
namespace {

constexpr std::array kAsks = {kAskEdge};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (question.ask != kAskEdge.name || !shown.is(minkowski_sum::Phase::edge)) return -1;
  if (question.at && *question.at != run.info(frame).iteration) return -1;
  return *frame.steps_over - 1;
}

const StagedAct kAct{
    .act = {.name = "minkowski-sum",
            .meaning =
                "edge of the Minkowski difference of two convex polygons, then whether O is inside",
            .needs = {.why_no_until = "frames show how the outline closes"},
            .add_frames = add_algorithm_frames,
            .follows_run = true,
            .asks = kAsks,
            .answering_step = answering_step,
            .algorithm = &kMinkowskiSumAlgorithm},
    .position = position_in_algorithm,
    .tick = tick_of_algorithm,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
};

constexpr std::array kLegend = {LegendEntry{"from.x", "edge of −X"},
                                LegendEntry{"from.y", "edge of Y"}};
constexpr std::array kActs = {&kAct};
constexpr std::array kBlocks = {&kMerge};
constexpr std::array kListings = {&kListing};

}  // namespace
}  // namespace gjkscope::sums

namespace gjkscope::algorithms {

const ShownAlgorithm minkowski_sum{sums::kActs, sums::kBlocks, sums::kListings, sums::kLegend};

}  // namespace gjkscope::algorithms
