#include <fmt/format.h>

#include <array>

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/regions/region_orders.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

void orders_frames(LessonRun& run, int index) {
  using enum OrderStage;
  if (run.runs[index].trace.steps.empty()) return;
  for (const OrderStage stage :
       {numbers, vertices_first_short, edges_first_short, edges_first_whole})
    run.frames.push_back({.run = index, .step = 0, .part = static_cast<int>(stage)});
}

void orders_knows(const Frame& frame, KnownFacts& facts) {
  if (frame.part > static_cast<int>(OrderStage::numbers)) return;
  facts.closest_point = false;
  facts.tests_reached = -1;
}

Tick orders_tick(const LessonRun& run, const Frame& frame) {
  constexpr std::array<std::string_view, 4> kLabels = {"numbers", "vertices first", "edges first",
                                                       "whole tests"};
  return {.group = fmt::format("position {}", frame.run + 1),
          .label = std::string(kLabels[static_cast<std::size_t>(*order_stage(run, frame))])};
}

constexpr AskInfo kAskTaken{"taken", "the region that short tests take, edges first",
                            "at position"};
constexpr std::array kOrdersAsks = {asks::kClosest, kAskTaken};

int orders_answer(const LessonRun& run, const Frame&, const Frame& frame,
                  const LessonQuestion& question) {
  const OrderStage stage = question.ask == kAskTaken.name ? OrderStage::edges_first_short
                                                          : OrderStage::vertices_first_short;
  return is_at(frame, question) && order_stage(run, frame) == stage ? frame.step : -1;
}

void orders_question(const Story& story, FrameText& text) {
  captions::question(story, text);
  if (text.question->ask != kAskTaken.name) return;
  const RegionOrders::Value& chains = story.effects.get<RegionOrders>(story.frame);
  for (const gjk::Face edge : {0b011, 0b110, 0b101})
    text.question->choices.push_back(story.words.face(edge));
  text.question->choices.emplace_back("none of them");
  text.question->answer = text.question->choices.back();
  const std::size_t chain = static_cast<std::size_t>(OrderStage::edges_first_short) - 1;
  if (gjk::vertex_count(chains[chain].region) == 2)
    text.question->answer = story.words.face(chains[chain].region);
  text.caption =
      "Question: now edges first, by the sign of one area each. Which edge do these tests take?";
}

}  // namespace

const Tour kOrders{
    .name = "orders",
    .meaning =
        "order in which the region tests of a triangle are asked: the numbers, then "
        "three chains of tests",
    .needs = {.start = 3, .why_no_until = "frames go through the first region tests"},
    .add_frames = orders_frames,
    .asks = kOrdersAsks,
    .answering_step = orders_answer,
    .algorithm = &kGjkAlgorithm,
    .knows = orders_knows,
    .position = position_in_lesson,
    .tick = orders_tick,
    .words = captions::orders,
    .stage = layers::stage_step,
    .question = orders_question,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<OrderStage> order_stage(const LessonRun& run, const Frame& frame) {
  return part_of<OrderStage>(tours::kOrders, run, frame);
}

}  // namespace gjkscope
