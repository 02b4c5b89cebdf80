#include <fmt/format.h>

#include <array>

#include "run/facts.hpp"
#include "subjects/regions/act.hpp"
#include "subjects/regions/region_orders.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::acts {
namespace {

void orders_frames(LessonRun& run, int index) {
  using enum OrderStage;
  if (run.runs[static_cast<std::size_t>(index)].trace.steps.empty()) return;
  for (const OrderStage stage :
       {numbers, vertices_first_short, edges_first_short, edges_first_whole})
    run.frames.push_back({.run = index, .step = 0, .part = static_cast<int>(stage)});
}

void orders_knows(const Frame& frame, KnownFacts& facts) {
  facts.closest_point = facts.closest_point && frame.part > static_cast<int>(OrderStage::numbers);
}

Tick orders_tick(const LessonRun& run, const Frame& frame) {
  constexpr std::array<std::string_view, 4> kLabels = {"numbers", "vertices first", "edges first",
                                                       "whole tests"};
  return {.group = fmt::format("position {}", frame.run + 1),
          .label = std::string(kLabels[static_cast<std::size_t>(*order_stage(run, frame))])};
}

}  // namespace

const Act kOrders{
    .name = "orders",
    .meaning =
        "order in which the region tests of a triangle are asked: the numbers, then "
        "three chains of tests",
    .needs = {.start = 3, .why_no_until = "frames go through the first region tests"},
    .add_frames = orders_frames,
    .algorithm = &kGjkAlgorithm,
    .knows = orders_knows,
    .position = position_in_lesson,
    .tick = orders_tick,
    .words = captions::orders,
    .stage = layers::stage_step,
};

}  // namespace gjkscope::acts

namespace gjkscope {

std::optional<OrderStage> order_stage(const LessonRun& run, const Frame& frame) {
  return part_of<OrderStage>(acts::kOrders, run, frame);
}

}  // namespace gjkscope
