#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "subjects/run/subject.hpp"

namespace gjkscope::blocks {
namespace {

using gjk::StopReason;
using namespace rows;

std::string name_of_test(const PanelBuilder& panel, StopReason reason) {
  switch (reason) {
    case StopReason::origin_inside:
      return query_name(panel.run) + " inside S";
    case StopReason::not_nearer:
      return "P no closer";
    case StopReason::zero_direction:
      return "d = 0";
    case StopReason::repeated_support:
      return "V in S";
    case StopReason::no_progress:
      return "V no farther than S";
    case StopReason::within_tolerance:
      return "bounds close enough";
    default:
      return "iteration cap";
  }
}

/// The values that a test compared.
std::string compared(const PanelBuilder& panel, const gjk::StopTest<double>& test) {
  const auto number = [&](double value) { return value == 0.0 ? "0" : panel.numbers(value); };
  switch (test.reason) {
    case StopReason::origin_inside:
      if (test.holds) return "all weights > 0";
      return fmt::format("{:.0f} {}, needs 3", test.left, test.left == 1.0 ? "vertex" : "vertices");
    case StopReason::zero_direction:
      return "|d| = " + number(panel.state.d.norm());
    case StopReason::repeated_support:
      return fmt::format("{} {}", panel.run.pair_name(panel.state.support.pair),
                         test.holds ? "is in S" : "is new");
    case StopReason::no_progress:
      return fmt::format(
          "{} is {} farther", panel.run.pair_name(panel.state.support.pair),
          test.holds ? "no" : number((test.left - test.right) / panel.state.d.norm()));
    case StopReason::within_tolerance:
      return fmt::format("{} {} {}", number(test.left), test.holds ? "≤" : ">", number(test.right));
    default:
      return fmt::format("{:.0f} of {:.0f}", test.right, test.left);
  }
}

/// True for tests that the lesson switched off.
bool left_out(const gjk::Options& options, StopReason reason) {
  return (reason == StopReason::repeated_support && !options.stop_on_repeated_support) ||
         (reason == StopReason::not_nearer && !options.stop_on_no_progress) ||
         (reason == StopReason::no_progress && !options.stop_on_no_progress) ||
         (reason == StopReason::within_tolerance && !(options.tolerance > 0.0));
}

void row(PanelBuilder& panel, TestMark mark, const std::string& name, const std::string& values) {
  const bool tried = mark != TestMark::untried;
  const bool holds = mark == TestMark::holds;
  if (holds) panel.highlight("highlight.pass");
  test_mark(panel, mark);
  panel.write(tried ? "body" : "untried", panel.left + 24.0, name,
              holds ? type::kStrong : type::kBody);
  if (tried) {
    panel.write(holds ? "code.current" : "code", panel.right, values,
                holds ? type::kCodeBold : type::kCode, Align::right);
  }
  panel.y += kRow + 2.0;
}

/// The stop phase that this frame's iteration comes to, or came to; -1 before the first iteration.
int stop_step(const PanelBuilder& panel) {
  const int now = panel.run.gjk_step(panel.frame);
  if (now < 0) return -1;
  const auto& steps = panel.run.run(panel.frame).trace.steps;
  for (int i = now; i < static_cast<int>(steps.size()); ++i) {
    if (steps[i].phase == gjk::Phase::stop) return i;
    if (steps[i].phase == gjk::Phase::add) return i - 1;
  }
  return -1;
}

/// True for tests that the run has passed by this phase: a run that goes on to a direction does not
/// contain O and came nearer; a run that goes on to a scan has a direction.
bool decided(const PanelBuilder& panel, StopReason reason) {
  const bool before_direction =
      reason == StopReason::origin_inside || reason == StopReason::not_nearer;
  switch (*panel.knows.phase) {
    case gjk::Phase::closest:
    case gjk::Phase::drop:
      return false;
    case gjk::Phase::direction:
      return before_direction;
    case gjk::Phase::support:
      return before_direction || reason == StopReason::zero_direction;
    case gjk::Phase::stop:
    case gjk::Phase::add:
      return true;
  }
  return false;
}

/// Whether P came nearer than in the iteration before, which is asked before there is a direction.
void nearer(PanelBuilder& panel, bool is_decided, const gjk::StopTest<double>* test) {
  const std::string name = name_of_test(panel, StopReason::not_nearer);
  const auto& steps = panel.run.run(panel.frame).trace.steps;
  std::vector<double> lengths;  // of this iteration and the one before
  for (int i = panel.run.gjk_step(panel.frame); i >= 0 && lengths.size() < 2; --i)
    if (steps[i].phase == gjk::Phase::closest) lengths.push_back(std::sqrt(steps[i].after.p_sq));
  if (!is_decided || panel.state.stop == StopReason::origin_inside)
    return row(panel, TestMark::untried, name, "");
  if (lengths.size() < 2) return row(panel, TestMark::fails, name, "no P before");
  const auto number = [&](double value) { return value == 0.0 ? "0" : panel.numbers(value); };
  const std::string length =
      panel.run.point_query() ? fmt::format("|{} − P|", query_name(panel.run)) : "|P|";
  if (test && test->tried && test->holds) {
    return row(panel, TestMark::holds, name,
               fmt::format("{} = {}, as before", length, number(lengths[0])));
  }
  row(panel, TestMark::fails, name, fmt::format("{} < {}", number(lengths[0]), number(lengths[1])));
}

void stop_tests(PanelBuilder& panel) {
  panel.heading("Stop tests (V: support point)");
  const auto& steps = panel.run.run(panel.frame).trace.steps;
  const int stop = stop_step(panel);
  const auto tried = [&](StopReason reason) -> const gjk::StopTest<double>* {
    if (stop < 0) return nullptr;
    const auto& tests = steps[stop].record.stop_tests;
    const auto test = std::find_if(tests.begin(), tests.end(),
                                   [&](const auto& other) { return other.reason == reason; });
    return test == tests.end() || !test->tried ? nullptr : &*test;
  };
  constexpr std::array<StopReason, 7> kOrder = {
      StopReason::origin_inside,    StopReason::not_nearer,  StopReason::zero_direction,
      StopReason::repeated_support, StopReason::no_progress, StopReason::within_tolerance,
      StopReason::iteration_cap};
  for (const StopReason reason : kOrder) {
    if (left_out(panel.run.lesson.options, reason)) continue;
    const bool is_decided = stop >= 0 && decided(panel, reason);
    const gjk::StopTest<double>* test = is_decided ? tried(reason) : nullptr;
    if (reason == StopReason::not_nearer) {
      nearer(panel, is_decided, test);
      continue;
    }
    const TestMark mark = !test         ? TestMark::untried
                          : test->holds ? TestMark::holds
                                        : TestMark::fails;
    row(panel, mark, name_of_test(panel, reason), test ? compared(panel, *test) : "");
  }
}

}  // namespace

const Block kStopTests{
    .name = "stop-tests",
    .meaning = "the stop tests in order, with what they compare and their verdicts",
    .write = stop_tests};

}  // namespace gjkscope::blocks
