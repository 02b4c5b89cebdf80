#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lesson/names.hpp"
#include "subjects/scalars/every_scalar.hpp"
#include "subjects/scalars/subject.hpp"

namespace gjkscope::blocks {
namespace {

using Answer = EveryScalar::Answer;
using namespace rows;

/// As many digits as tell the numbers of a scalar apart.
int digits_of(ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::half:
      return 5;
    case ScalarKind::single:
      return 9;
    default:
      return 17;
  }
}

/// The power of ten that lengths are written in units of; 0 where none is needed.
int unit_of(double length) {
  if (!(length > 0.0)) return 0;
  const int exponent = static_cast<int>(std::floor(std::log10(length)));
  return exponent < -4 || exponent > 6 ? exponent : 0;
}

int decimals_of(double value, ScalarKind scalar) {
  const int before = value > 0.0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  constexpr int kMost = 17;
  return std::clamp(digits_of(scalar) - before, 0, kMost);
}

/// The length that a run knows in the frame's iteration, and at the end the one that it answers.
double length_at(const Answer& answer, int iteration, bool ended) {
  const WideTrace& trace = answer.run.trace;
  if (ended) return trace.result.distance;
  double length = trace.initial.p.norm();
  for (const WideStep& step : trace.steps) {
    if (step.iteration <= iteration) length = step.after.p.norm();
  }
  return length;
}

/// Compares a scalar's support point with that of the exact run.
std::string relation(const PanelBuilder& panel, const Answer& answer, const Answer& exact,
                     int iteration, bool ended) {
  if (ended) {
    const int last = answer.run.trace.result.iterations;
    if (&answer == &exact) return fmt::format("ends in iteration {}", last);
    if (answer.parting == 0) return "the same steps as exact";
    return fmt::format("parts from exact in iteration {}", answer.parting);
  }
  const WideStep* mine = support_step(answer.run, iteration);
  const WideStep* right = support_step(exact.run, iteration);
  const auto name = [&](const WideStep* step) {
    return step != nullptr ? panel.run.pair_name(step->after.support.pair) : std::string("none");
  };
  if (&answer == &exact) return "support point " + name(mine);
  if (answer.parting != 0 && answer.parting < iteration)
    return fmt::format("parted in iteration {}", answer.parting);
  if (mine == nullptr && right == nullptr) return "the same steps so far";
  if (name(mine) != name(right)) return fmt::format("parts: {}, not {}", name(mine), name(right));
  return answer.parting == iteration ? "parts: only one of both goes on"
                                     : "support point " + name(mine);
}

/// A number, its digits that differ from the right ones underlined and bold; true if some do.
bool number(PanelBuilder& panel, double value, double right, ScalarKind scalar) {
  const int decimals = decimals_of(std::max(value, right), scalar);
  const std::string text = value == 0.0 ? "0" : fixed(value, decimals);
  const std::string wanted = right == 0.0 ? "0" : fixed(right, decimals);
  const bool one_is_zero = (value == 0.0) != (right == 0.0);
  const auto parts =
      one_is_zero ? std::pair(text.cbegin(), wanted.cbegin())
                  : std::mismatch(text.cbegin(), text.cend(), wanted.cbegin(), wanted.cend());
  const std::string same(text.cbegin(), parts.first);
  const std::string other(parts.first, text.cend());
  // The columns start at one place, so that digits stand below each other.
  const double at = panel.left + 68.0;
  panel.write("code.current", at, same, type::kCode);
  if (other.empty()) return false;
  const double from = at + panel.fonts.width(type::kCode, same);
  const double to = from + panel.fonts.width(type::kCodeBold, other);
  panel.write("fail", from, other, type::kCodeBold);
  panel.add("wrong", Polyline{{{from, panel.y + 4.0}, {to, panel.y + 4.0}}});
  return true;
}

void scalars(PanelBuilder& panel) {
  const EveryScalar::Value& answers = panel.effects.get<EveryScalar>(panel.frame);
  const Answer& exact = answers.back();
  const int iteration = panel.run.info(panel.frame).iteration;
  const bool ended = panel.knows.has_ended;
  const bool started = panel.run.gjk_step(panel.frame) >= 0;
  // Lengths are written in a unit that suits the right one, or the first that is not 0.
  double length = 0.0;
  if (started) {
    length = length_at(exact, iteration, ended);
    for (const Answer& each : answers) {
      if (length == 0.0 && each.refused.empty()) length = length_at(each, iteration, ended);
    }
  }
  const int unit = unit_of(length);
  const double scale = std::pow(10.0, -unit);
  std::string title = ended ? "What each scalar answers"
                            : fmt::format("Distance of P in iteration {}", std::max(iteration, 1));
  if (unit != 0) title += ", in units of 10" + raised(unit);
  panel.heading(title);
  panel.y += 4.0;
  bool some_differ = false;
  bool some_part = false;
  for (const Answer& each : answers) {
    const bool own = each.scalar == panel.run.lesson.scalar;
    if (own) {
      panel.add("highlight.pass", Box{{{panel.left - 8.0, panel.y - 17.0},
                                       {panel.right + 8.0, panel.y + kTightRow + 7.0}},
                                      5.0});
    }
    panel.write("strong", panel.left, std::string(name_of(each.scalar)), type::kStrong);
    if (!each.refused.empty()) {
      panel.write("fail", panel.left + 68.0, "no answer", type::kCodeBold);
      panel.y += kTightRow;
      panel.write("body.muted", panel.left + 68.0, "a vertex is out of range", type::kBody);
    } else if (started) {
      some_differ |= number(panel, scale * length_at(each, iteration, ended),
                            scale * length_at(exact, iteration, ended), each.scalar);
      some_part |= each.parting != 0 && each.parting <= iteration;
      panel.y += kTightRow;
      panel.write("body.muted", panel.left + 68.0, relation(panel, each, exact, iteration, ended),
                  type::kBody);
    } else {
      panel.write("code", panel.left + 68.0, "–", type::kCode);
      panel.y += kTightRow;
    }
    panel.y += kRow + 8.0;
  }
  const auto note = [&](bool applies, const std::string& text) {
    if (applies) panel.write("body.muted", panel.left, text, type::kBody);
    panel.y += kTightRow;  // what stands below keeps its place
  };
  note(some_differ,
       ended ? "Underlined digits are wrong." : "Underlined digits are not those of exact.");
  note(some_part, "Runs that differ at a tie may still agree.");
}

}  // namespace

const Block kScalars{.name = "scalars",
                     .meaning =
                         "the same query in all four scalars: distance, wrong digits, where "
                         "each parts from exact",
                     .write = scalars};

}  // namespace gjkscope::blocks
