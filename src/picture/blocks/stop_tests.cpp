#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/blocks/blocks.hpp"

namespace gjkscope::blocks {
namespace {

using fmt::format;
using gjk::StopReason;
using namespace rows;

/// The tests as they stand beside the pseudocode, which calls the support point w.
std::string name_of_test(const PanelBuilder& panel, StopReason reason) {
  switch (reason) {
    case StopReason::origin_inside:
      return query_name(panel.run) + " inside S";
    case StopReason::zero_direction:
      return "d = 0";
    case StopReason::repeated_support:
      return "w in S";
    case StopReason::no_progress:
      return panel.phase() == gjk::Phase::stop && !panel.stop_follows_support()
                 ? "P no nearer"
                 : "w no farther than S";
    case StopReason::within_tolerance:
      return "bounds close enough";
    default:
      return "iteration cap";
  }
}

/// What a test compared.
std::string compared(const PanelBuilder& panel, const gjk::StopTest<double>& test) {
  const auto number = [&](double value) { return value == 0.0 ? "0" : panel.numbers(value); };
  switch (test.reason) {
    case StopReason::origin_inside:
      return format("{} of 3 vertices", panel.state.simplex.count);
    case StopReason::zero_direction:
      return "|d| = " + number(panel.state.d.norm());
    case StopReason::repeated_support:
      return format("{} {}", panel.run.pair_name(panel.state.support.pair),
                    test.holds ? "is there" : "is new");
    case StopReason::no_progress:
      if (!panel.stop_follows_support())
        return format("{} = {} as before",
                      panel.run.point_query() ? format("|{} − P|", query_name(panel.run)) : "|P|",
                      number(std::sqrt(test.right)));
      return format("{} by {}", panel.run.pair_name(panel.state.support.pair),
                    number(test.left - test.right));
    case StopReason::within_tolerance:
      return format("{} {} {}", number(test.left), test.holds ? "≤" : ">", number(test.right));
    default:
      return format("{} of {}", panel.state.iteration, panel.run.lesson.options.iteration_cap);
  }
}

/// True for tests that the lesson switched off.
bool left_out(const gjk::Options& options, StopReason reason) {
  return (reason == StopReason::repeated_support && !options.stop_on_repeated_support) ||
         (reason == StopReason::no_progress && !options.stop_on_no_progress) ||
         (reason == StopReason::within_tolerance && !(options.tolerance > 0.0));
}

}  // namespace

void stop_tests(PanelBuilder& panel) {
  panel.heading("Stop tests: the first that holds");
  static const std::vector<gjk::StopTest<double>> none;
  const bool decided = panel.phase() == gjk::Phase::stop;
  const auto& tests = decided ? panel.run.step(panel.frame).record.stop_tests : none;
  std::array<StopReason, 6> order = {StopReason::origin_inside,    StopReason::zero_direction,
                                     StopReason::repeated_support, StopReason::no_progress,
                                     StopReason::within_tolerance, StopReason::iteration_cap};
  // Whether P came nearer is asked before there is a direction.
  if (decided && !panel.stop_follows_support())
    order = {StopReason::origin_inside,    StopReason::no_progress,      StopReason::zero_direction,
             StopReason::repeated_support, StopReason::within_tolerance, StopReason::iteration_cap};
  for (const StopReason reason : order) {
    if (left_out(panel.run.lesson.options, reason)) continue;
    const auto test = std::find_if(tests.begin(), tests.end(),
                                   [&](const auto& other) { return other.reason == reason; });
    const bool tried = test != tests.end() && test->tried;
    const bool holds = tried && test->holds;
    if (holds) panel.highlight("highlight.pass");
    test_mark(panel, !tried ? TestMark::untried : holds ? TestMark::holds : TestMark::fails);
    panel.write(tried ? "body" : "untried", panel.left + 24.0, name_of_test(panel, reason),
                holds ? type::kStrong : TextStyle{Face::regular, 15});
    if (tried) {
      panel.write(holds ? "code.current" : "code", panel.right, compared(panel, *test),
                  holds ? type::kCodeBold : type::kCode, Align::right);
    }
    panel.y += kRow + 2.0;
  }
}

}  // namespace gjkscope::blocks
