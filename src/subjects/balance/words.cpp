#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "picture/story.hpp"
#include "subjects/balance/balance.hpp"
#include "subjects/balance/subject.hpp"
#include "subjects/balance/table.hpp"

namespace gjkscope::captions {

void balance(const Story& story, FrameText& text) {
  const Balance::Value& value = story.effects.get<Balance>(story.frame);
  if (value.moments.empty()) return;
  const int moment = *beam_moment(story.run, story.frame);
  const Beam& beam = value.moments[moment];
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
  const std::string more = fmt::format("{} against {}", number(std::max(turning[0], turning[1])),
                                       number(std::min(turning[0], turning[1])));
  // Q jumps from one position to the next.
  const std::string moved =
      story.frame.run > 0 && moment == 0 ? story.q + " has moved. " : std::string();
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
            : fmt::format("{} is down by {}°", tilt > 0.0 ? a : b, fixed(std::abs(tilt), 1));
  const double share = beam.seconds / story.run.lesson.settings.as<LessonTime>()->seconds;
  if (beam.seconds == 0.0) {
    text.caption = missing
                       ? fmt::format(
                             "{}The weights are u = {} and v = {}. No mass is negative: {} stays "
                             "empty, {} gets {}.",
                             moved, number(u), number(v), nobody, end, number(masses[1 - empty]))
                       : fmt::format("{}The masses at {} and {} are the weights u = {} and v = {}.",
                                     moved, a, b, number(u), number(v));
    text.detail = equal ? "The beam hangs from its middle. Equal masses: it stays level."
                        : fmt::format(
                              "The beam hangs from its middle. {}'s moment is larger, {}: {} will "
                              "sink.",
                              heavier, more, heavier);
  } else if (share <= kSupportStarts) {
    if (equal) {
      text.caption = fmt::format("Equal masses balance in the middle: {} at {}, {} at {}.",
                                 product(0), a, product(1), b);
      text.detail = "G = uA + vB is the middle, so the support need not move.";
    } else {
      text.caption = fmt::format("{}'s moment is larger, {}: {}{}.", heavier, more, tilts,
                                 beam.on_ground ? ", on the ground" : " so far");
      text.detail =
          beam.on_ground
              ? fmt::format("Next, the support slides towards {}, to G = uA + vB.", heavier)
              : "It sinks until the ground stops it.";
    }
  } else if (missing && arms[1 - empty] < 0.0) {
    const std::string reason = fmt::format(
        "The only mass, at {}, is now on {}'s side of the support (arm {}): {} will sink instead.",
        end, nobody, number(arms[1 - empty]), nobody);
    if (share < kSupportArrives) {
      text.caption = fmt::format(
          "The support has passed {}: the moment now turns the beam the other way.", end);
      text.detail = reason;
      return;
    }
    text.caption = fmt::format(
        "G lies beyond {}. To balance there, {} would need the mass {}. No mass is negative: the "
        "beam {}.",
        end, nobody, number(std::min(u, v)),
        beam.on_ground ? fmt::format("has tipped over to {}", nobody)
                       : fmt::format("tips over to {}", nobody));
    text.detail = beam.on_ground ? fmt::format(
                                       "The farthest point where masses can balance is {0}, and "
                                       "{0} is the closest point: "
                                       "P = {0}.",
                                       end)
                                 : reason;
  } else if (share < kSupportArrives) {
    text.caption =
        equal ? fmt::format("The support is where it must be, and {}.", tilts)
              : fmt::format("The support slides towards {0}: {0}'s arm gets shorter, {1}'s longer.",
                            heavier, lighter);
    text.detail = fmt::format("The moments are now {} at {} and {} at {}; {}.", product(0), a,
                              product(1), b, tilts);
  } else if (rests) {
    text.caption = fmt::format(
        "{}With the support at G = uA + vB the moments are equal, {} = {}: "
        "the beam {}.",
        moved, product(0), product(1), equal ? "stays level" : "is level again");
    text.detail =
        fmt::format("G is the balance point: v = {} of the way from {} to {}.", number(v), a, b);
  } else {
    text.caption =
        fmt::format("Now {}'s moment is larger, {}: the beam swings back to level.", winner, more);
    text.detail =
        fmt::format("The support is on G = uA + vB; {}. At level the moments are equal.", tilts);
  }
}

}  // namespace gjkscope::captions
