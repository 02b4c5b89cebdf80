#include <fmt/format.h>

#include "picture/story.hpp"
#include "subjects/round_shapes/round_shapes.hpp"
#include "subjects/round_shapes/subject.hpp"

namespace gjkscope::captions {

void round_shapes(const Story& story, FrameText& text) {
  const RoundShapes::Value* round = RoundShapes::of(story.effects, story.run, story.frame);
  if (round == nullptr || !story.knows.distance) return;
  const double distance = story.trace.result.distance;
  const LessonShape& x = story.run.lesson.x();
  const LessonShape& y = story.run.lesson.y();
  const std::string radii =
      x.radius > 0.0 && y.radius > 0.0
          ? fmt::format("the radii {} + {}", story.numbers(x.radius), story.numbers(y.radius))
          : fmt::format("the radius {}", story.numbers(round->radii));
  if (!(distance > 0.0)) {
    text.detail += fmt::format(" The radii add {} to the overlap.", story.numbers(round->radii));
    return;
  }
  const std::string answer = fmt::format("GJK's distance {}", story.numbers(distance));
  switch (round->meeting) {
    case RoundShapes::Meeting::apart:
      text.detail = fmt::format("Less {}, {} leaves {} between the round shapes.", radii, answer,
                                story.numbers(round->distance));
      return;
    case RoundShapes::Meeting::touching:
      text.detail = fmt::format("{} is just {}: the round shapes touch.", answer, radii);
      return;
    case RoundShapes::Meeting::overlapping:
      text.detail = fmt::format("{} is less than {}: the round shapes overlap by {}.", answer,
                                radii, story.numbers(-round->distance));
  }
}

}  // namespace gjkscope::captions
