#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "subjects/balance/balance.hpp"
#include "subjects/balance/subject.hpp"

namespace gjkscope::blocks {

using namespace rows;

namespace {

void balance(PanelBuilder& panel) {
  const Balance::Value& value = panel.effects.get<Balance>(panel.frame);
  if (value.moments.empty()) return;
  const Beam& beam = value.moments[*beam_moment(panel.run, panel.frame)];
  panel.heading(fmt::format("The beam at t = {} s", fixed(beam.seconds, 2)));
  const double mass_at = panel.left + 168.0;
  const double arm_at = panel.left + 268.0;
  panel.write("heading", mass_at, "mass", type::kHeading, Align::right);
  panel.write("heading", arm_at, "× arm", type::kHeading, Align::right);
  panel.write("heading", panel.right, "= moment", type::kHeading, Align::right);
  panel.y += kRow;
  const std::array<double, 2> arms = arms_of(beam);
  for (int i = 0; i < 2; ++i) {
    panel.write("strong", panel.left, "at " + panel.words.vertex(i), type::kStrong);
    panel.write("code", mass_at, fixed(value.masses[i], 3), type::kCode, Align::right);
    panel.write("code", arm_at, fixed(arms[i], 3), type::kCode, Align::right);
    panel.write("code.current", panel.right, fixed(value.masses[i] * arms[i], 3), type::kCodeBold,
                Align::right);
    panel.y += kRow;
  }
  panel.y += 4.0;
  panel.write("body.muted", panel.left, "arm: distance from the support, in beam lengths",
              type::kTick);
  panel.y += kRow;
  const double degrees = std::abs(beam.angle) * 180.0 / std::numbers::pi;
  constexpr double kLevel = 0.05;  // degrees: prints as 0.0
  panel.write("body", panel.left, "tilt", type::kBody);
  panel.write("code.current", panel.right,
              degrees < kLevel ? "level"
                               : fmt::format("{}°, {} down", fixed(degrees, 1),
                                             panel.words.vertex(beam.angle > 0.0 ? 0 : 1)),
              type::kCodeBold, Align::right);
  panel.y += kRow;
}

}  // namespace

const Block kBalance{
    .name = "balance",
    .meaning = "masses, support, turning moments and tilt of the beam at this time",
    .write = balance,
    .tour = "time"};

}  // namespace gjkscope::blocks
