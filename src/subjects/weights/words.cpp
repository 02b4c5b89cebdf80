#include <fmt/format.h>

#include "picture/story.hpp"
#include "subjects/weights/projection.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::captions {

void line(const Story& story, FrameText& text) {
  const UnitVector::Value& built = story.effects.get<UnitVector>(story.frame);
  const Projection::Value& g = story.effects.get<Projection>(story.frame);
  if (!built || !g) return;
  const std::string a = story.words.vertex(0);
  const std::string b = story.words.vertex(1);
  const double u = built->of_g.to_b / built->length;
  const double v = built->of_g.from_a / built->length;
  const auto weight = [&](double value) { return story.numbers.weight(value); };
  // A multiple of what rounding leaves of G - Q.
  const bool on_line = g->norm() < 1e-9 * built->length;
  if (!on_line) {
    text.caption = fmt::format(
        "{0} gives the same without G: {0} − G is perpendicular to n, so dot({1} − {0}, n) = "
        "dot({1} − G, n) = {2}.",
        story.q, b, story.numbers(built->of_g.to_b));
    text.detail =
        fmt::format("Thus from {} itself: u = {} / {} = {} and v = {} / {} = {}.", story.q,
                    story.numbers(built->of_q.to_b), story.numbers(built->length), weight(u),
                    story.numbers(built->of_q.from_a), story.numbers(built->length), weight(v));
    return;
  }
  if (u > 0.0 && v > 0.0) {
    text.caption = fmt::format(
        "G = uA + vB divides {0}{1}: from G to {1} it is u = {2} of the length, from {0} to G it "
        "is "
        "v = {3}.",
        a, b, weight(u), weight(v));
  } else if (v < 0.0 || u < 0.0) {
    const bool before = v < 0.0;
    text.caption = fmt::format(
        "G = u{} + v{} lies beyond {}: the arrow from {} to {} points against n, so {} = {} is "
        "negative, and {} = {} is more than 1.",
        a, b, before ? a : b, before ? a : "G", before ? "G" : b, before ? "v" : "u",
        weight(before ? v : u), before ? "u" : "v", weight(before ? u : v));
  } else {
    const bool at_b = v > 0.0;
    text.caption =
        fmt::format("G is {}: from {} to {} it is the whole length, so u = {} and v = {}.",
                    at_b ? b : a, at_b ? a : "G", at_b ? "G" : b, weight(u), weight(v));
  }
  text.detail = fmt::format("u = {} / {} and v = {} / {}; u + v = 1 on the whole line.",
                            story.numbers(built->of_g.to_b), story.numbers(built->length),
                            story.numbers(built->of_g.from_a), story.numbers(built->length));
}

}  // namespace gjkscope::captions
