#include "effects/balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "picture/captions/story.hpp"

namespace gjkscope::captions {

using fmt::format;

void balance(const Story& story, FrameText& text) {
  const Balance::Value& value = story.effects.get<Balance>(story.frame);
  if (value.moments.empty()) return;
  const Beam& beam = value.moments[*story.frame.moment];
  const std::string a = story.words.vertex(0);
  const std::string b = story.words.vertex(1);
  const auto& [u, v] = value.weights;
  const auto& masses = value.masses;
  const std::array<double, 2> arms = arms_of(beam);
  const auto number = [&](double weight) { return story.numbers.weight(weight); };
  const auto product = [&](int i) { return number(masses[i]) + " × " + number(arms[i]); };
  const std::array<double, 2> turning = {masses[0] * arms[0], masses[1] * arms[1]};
  const bool equal = masses[0] == masses[1];
  const std::string heavier = masses[0] > masses[1] ? a : b;
  const std::string lighter = masses[0] > masses[1] ? b : a;
  const std::string winner = turning[0] > turning[1] ? a : b;
  const std::string more = format("{} against {}", number(std::max(turning[0], turning[1])),
                                  number(std::min(turning[0], turning[1])));
  const bool missing = u < 0.0 || v < 0.0;
  const int empty = u < 0.0 ? 0 : 1;
  const std::string nobody = empty == 0 ? a : b;
  const std::string end = empty == 0 ? b : a;
  const double tilt = beam.angle * 180.0 / std::numbers::pi;
  constexpr double kLevel = 0.05;  // degrees: prints as 0.0
  constexpr double kSlow = 1.0;    // degrees a second
  const bool level = std::abs(tilt) < kLevel;
  const bool rests = level && std::abs(beam.rate) * 180.0 / std::numbers::pi < kSlow;
  const std::string tilts =
      level ? "the beam is level"
            : format("{} is down by {}°", tilt > 0.0 ? a : b, fixed(std::abs(tilt), 1));
  const double share = beam.seconds / story.run.lesson.time->seconds;
  if (beam.seconds == 0.0) {
    text.caption = missing ? format(
                                 "The weights are {} and {}. A mass cannot be negative: {} stays "
                                 "empty, {} gets {}.",
                                 number(u), number(v), nobody, end, number(masses[1 - empty]))
                           : format("u and v become masses at {} and {}: {} and {}.", a, b,
                                    number(u), number(v));
    text.detail = equal ? "The beam hangs by its middle. Equal masses: it will stay level."
                        : format(
                              "The beam hangs by its middle, where {} turns it more, {}: that "
                              "end will go down.",
                              heavier, more);
  } else if (share <= kSupportStarts) {
    if (equal) {
      text.caption = format("Equal masses balance in the middle: {} at {} against {} at {}.",
                            product(0), a, product(1), b);
      text.detail = "G = uA + vB is the middle, so that the support need not move.";
    } else {
      text.caption = format("{} is heavier, and turns the beam more, {}: {}{}.", heavier, more,
                            tilts, beam.on_ground ? ", on the ground" : " so far");
      text.detail = beam.on_ground
                        ? format("Next, the support slides towards {}, to G = uA + vB.", heavier)
                        : "It goes down until the ground stops it.";
    }
  } else if (missing && arms[1 - empty] < 0.0) {
    const std::string reason = format(
        "{} is on {}'s side of the support: its arm {} counts negative, and on the other side "
        "nothing pulls.",
        end, nobody, number(arms[1 - empty]));
    if (share < kSupportArrives) {
      text.caption = format("The support slides on, past {}: the beam tips.", end);
      text.detail = reason;
      return;
    }
    text.caption = format(
        "G lies beyond {}: to balance there, {} would need the mass {}. It has none: the beam {}.",
        end, nobody, number(std::min(u, v)), beam.on_ground ? "has tipped" : "tips");
    text.detail =
        beam.on_ground
            ? format(
                  "Masses that are not negative balance at {0} at the farthest, and that is the "
                  "closest point: P = {0}.",
                  end)
            : reason;
  } else if (share < kSupportArrives) {
    text.caption =
        equal ? format("The support is where it must be, and {}.", tilts)
              : format("The support slides towards {}: its arm gets shorter, that of {} longer.",
                       heavier, lighter);
    text.detail = format("Now {} at {} against {} at {}: {}.", product(0), a, product(1), b, tilts);
  } else if (rests) {
    text.caption = format("On G = uA + vB both sides turn alike, {} = {}: the beam {}.", product(0),
                          product(1), equal ? "stays level" : "is level again");
    text.detail = format("G is the balance point of the masses: {} of the way from {} to {}.",
                         number(v), a, b);
  } else {
    text.caption = format("{} turns the beam more now, {}: it swings back to level.", winner, more);
    text.detail =
        format("The support is on G = uA + vB; {}. Level, both sides will turn alike.", tilts);
  }
}

}  // namespace gjkscope::captions
