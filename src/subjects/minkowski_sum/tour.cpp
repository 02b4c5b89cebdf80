#include <array>

#include "subjects/minkowski_sum/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::sums {
namespace {

constexpr std::array kAsks = {kAskLowest, kAskEdge};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (question.ask == kAskLowest.name)
    return shown.is(minkowski_sum::Phase::lowest) ? frame.step : -1;
  if (question.ask != kAskEdge.name || !shown.is(minkowski_sum::Phase::edge)) return -1;
  if (question.at && *question.at != run.info(frame).iteration) return -1;
  const minkowski_sum::State& before = shown.step->before;
  // With no edge left in one shape there is nothing to choose.
  if (before.edges_of_y == shown.merge.y.size() || before.edges_of_x == shown.merge.x.size())
    return -1;
  return frame.step;
}

const Tour kTour{
    .name = "minkowski-sum",
    .meaning = "edge of the Minkowski difference of two convex polygons, then whether O is inside",
    .needs = {.why_no_until = "frames show how the outline closes"},
    .add_frames = add_algorithm_frames,
    .follows_run = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kMinkowskiSumAlgorithm,
    .position = position_in_algorithm,
    .tick = tick_of_algorithm,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
};

}  // namespace
}  // namespace gjkscope::sums

namespace gjkscope {

const SubjectParts subjects::minkowski_sum{
    .tours = {&sums::kTour},
    .blocks = {&sums::kMerge},
    .listings = {&sums::kListing},
    .legend = {{"from.x", "edge of −X"}, {"from.y", "edge of Y"}},
};

}  // namespace gjkscope
