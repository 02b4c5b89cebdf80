#include "effects/balance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "picture/captions/story.hpp"

namespace gjkscope::captions {

using fmt::format;

void balance(const Story& story, FrameText& text) {
  const Balance::Value& value = story.effects.get<Balance>(story.frame);
  if (value.moments.empty()) return;
  const Beam& beam = value.moments[story.frame.detail];
  const std::string a = story.words.vertex(0);
  const std::string b = story.words.vertex(1);
  const auto& [u, v] = value.weights;
  const auto number = [&](double weight) { return story.numbers.weight(weight); };
  const bool heavier_a = value.masses[0] > value.masses[1];
  const std::string heavier = heavier_a ? a : b;
  const std::string lighter = heavier_a ? b : a;
  const bool equal = value.masses[0] == value.masses[1];
  const bool missing = u < 0.0 || v < 0.0;
  const double tilt = beam.angle * 180.0 / std::numbers::pi;
  constexpr double kLevel = 0.05;  // degrees: prints as 0.0
  constexpr double kAtRest = 0.5;  // not to be seen
  const bool level = std::abs(tilt) < kLevel;
  const std::string degrees = fixed(std::abs(tilt), 1) + "°";
  const std::string tilts =
      level ? "the beam is level" : format("{} is down by {}", tilt > 0.0 ? a : b, degrees);
  const double share = beam.seconds / story.run.lesson.time->seconds;
  const std::string turning =
      format("{} × {} at {} against {} × {} at {}", number(value.masses[0]), number(beam.support),
             a, number(value.masses[1]), number(1.0 - beam.support), b);
  if (beam.seconds == 0.0) {
    text.caption =
        format("u and v become masses at {} and {}: {} and {}.", a, b, number(u), number(v));
    if (missing) {
      text.caption += format(" There is no negative mass, so {} stays empty.", u < 0.0 ? a : b);
    }
    text.detail =
        equal
            ? "The beam hangs by its middle. Equal masses: it will stay level."
            : format("The beam hangs by its middle. {} is heavier: its end will go down.", heavier);
  } else if (share <= kSupportStarts) {
    text.caption = equal ? format("Equal masses balance in the middle: {}.", turning)
                         : format("{} is heavier, and {}: {}.", heavier, tilts, turning);
    text.detail = equal ? "G = uA + vB is the middle, so that the support need not move."
                        : format("Next, the support slides towards {}, to G = uA + vB.", heavier);
  } else if (share < kSupportArrives) {
    text.caption =
        equal ? format("The support is where it must be, and {}.", tilts)
              : format("The support slides towards {}: its arm gets shorter, that of {} longer.",
                       heavier, lighter);
    text.detail = format("Now: {}.", turning);
  } else if (missing) {
    const std::string empty = u < 0.0 ? a : b;
    const std::string end = u < 0.0 ? b : a;
    text.caption = format(
        "G lies beyond {}: to balance there, {} would need the mass {}. It has none: the beam "
        "tips.",
        end, empty, number(std::min(u, v)));
    text.detail = format(
        "Masses that are not negative balance at {0} at the farthest, and that is the closest "
        "point: P = {0}.",
        end);
  } else {
    const std::string moments = format("{} × {} = {} × {}", number(value.masses[0]), number(v),
                                       number(value.masses[1]), number(u));
    const std::string state = level                      ? tilts
                              : std::abs(tilt) < kAtRest ? format(
                                                               "the beam comes to rest, level "
                                                               "but for {}",
                                                               degrees)
                                                         : "the beam swings, " + tilts;
    text.caption = format("On G = uA + vB both sides turn alike, {}: {}.", moments, state);
    text.detail = format("G is the balance point of the masses: {} of the way from {} to {}.",
                         number(v), a, b);
  }
}

}  // namespace gjkscope::captions
