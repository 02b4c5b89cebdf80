
#include "base/decimal.hpp"
#include "picture/block.hpp"
#include "subjects/general_growth/shown.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope::costs {
namespace {

using Times = std::vector<double> GrowthTimes::*;

constexpr double kTimeColumn = 84.0;  // width in pixels

/// The times, from where a question about them is answered.
const GrowthTimes* times_of(const Shown& shown, const Lesson& lesson) {
  const bool is_known = !lesson.asks(kAskMethod.name) || shown.over > shown.sizes();
  return shown.trace.times && is_known ? &*shown.trace.times : nullptr;
}

/// Pairs, and the time where the lesson has it.
void method(PanelBuilder& panel, const Shown& shown, std::string name, std::string pairs,
            Times times) {
  panel.write("body", panel.left, std::move(name), type::kBody);
  const GrowthTimes* all = times_of(shown, panel.run.lesson);
  const double right = panel.right - (all != nullptr ? kTimeColumn : 0.0);
  panel.write("code.current", right, std::move(pairs), type::kCode, Align::right);
  if (all != nullptr && shown.size() < (all->*times).size())
    panel.write("code.current", panel.right, time_text((all->*times)[shown.size()]), type::kCode,
                Align::right);
  panel.y += rows::kRow;
}

void costs(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const general_growth::Sample& sample = shown.sample();
  const bool has_times = times_of(shown, panel.run.lesson) != nullptr;
  panel.write("heading", panel.left, "n = " + grouped(sample.segments), type::kHeading);
  panel.write("heading", panel.right - (has_times ? kTimeColumn : 0.0), "pairs", type::kHeading,
              Align::right);
  if (has_times) panel.write("heading", panel.right, "time", type::kHeading, Align::right);
  panel.y += rows::kRow + 2.0;
  const auto row = [&](std::string name, double pairs, Times times) {
    method(panel, shown, std::move(name), pairs < 0.0 ? "not cut" : grouped(pairs), times);
  };
  row("all segments", sample.pairs(), &GrowthTimes::pairs);
  row("convex pieces", sample.pieces, &GrowthTimes::pieces);
  row("trees of boxes", sample.boxes, &GrowthTimes::boxes);
  row("trees of circles", sample.circles, &GrowthTimes::circles);
  row("boxes, from the last pair", sample.remembered, &GrowthTimes::remembered);
  // Not where the answer is read off it.
  const bool is_asking =
      panel.frame.question >= 0 && panel.run.asked(panel.frame).ask == kAskAgrees.name;
  if (!is_asking) row("boxes, only collide?", sample.collide, &GrowthTimes::collide);
  if (has_times) method(panel, shown, "building trees of boxes", "", &GrowthTimes::build);
}

}  // namespace

const Block kCosts{.name = "costs",
                   .meaning =
                       "pairs that each method visits at the frame's number of segments, and "
                       "how long it takes",
                   .write = costs,
                   .tour = "general-growth"};

}  // namespace gjkscope::costs
