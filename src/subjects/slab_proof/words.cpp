#include <fmt/format.h>

#include "subjects/slab_proof/shown.hpp"

namespace gjkscope::slabs {
namespace {

using slab_proof::Phase;
using slab_proof::Reach;
using slab_proof::Stop;

void slab(const Story& story, const Shown& shown, FrameText& text) {
  const auto& reaches = shown.step->reaches;
  if (reaches.empty()) {
    text.caption = "No vertex lies in slab(x, y): it is empty.";
    text.detail = fmt::format(
        "Thus all of {} lies on one side of it and all of {} on the other: no two points can be "
        "closer than {}.",
        shown.lesson.x().name, shown.lesson.y().name, story.numbers(shown.state().distance()));
    return;
  }
  std::vector<std::string> names;
  for (const Reach& reach : reaches) names.push_back(shown.name(reach));
  text.caption = reaches.size() == 1
                     ? fmt::format("{} lies in slab(x, y).", capitalized(names[0]))
                     : fmt::format("{} vertices lie in slab(x, y). {} is the deepest.",
                                   reaches.size(), capitalized(names[0]));
  if (shown.step->after.stop == Stop::iteration_cap) {
    text.detail = fmt::format("The descent gives up after {} slabs.", slab_proof::kIterationCap);
    return;
  }
  text.detail =
      "Thus x and y are not the closest points. Next: a closer point on the segment to it.";
}

void closer(const Story& story, const Shown& shown, FrameText& text) {
  const Reach& c = shown.step->towards;
  const Body& body = c.of_x ? story.positioned.x() : story.positioned.y();
  const bool is_vertex =
      (c.of_x ? shown.step->after.x : shown.step->after.y) == in_plane(body.world[c.vertex]);
  const std::string_view moving = c.of_x ? "x" : "y";
  const std::string_view other = c.of_x ? "y" : "x";
  text.caption = fmt::format(
      "{} moves {}: the distance falls from {} to {}.", moving,
      is_vertex ? "to " + shown.name(c) : "along the segment to " + shown.name(c),
      story.numbers(shown.step->before.distance()), story.numbers(shown.step->after.distance()));
  text.detail = fmt::format(
      "The segment lies in {0}, which is convex. Its end c lies in the slab, so at {1} it makes "
      "less "
      "than 90° with the way to {2} and comes closer. Its point closest to {2} is the new {1}.",
      (c.of_x ? shown.lesson.x() : shown.lesson.y()).name, moving, other);
}

void angle_question(const Shown& shown, const slab_proof::Step& step, FrameText& text) {
  const Reach& c = step.towards;
  const std::string_view moving = c.of_x ? "x" : "y";
  const std::string_view other = c.of_x ? "y" : "x";
  FrameQuestion& asked = *text.question;
  asked.choices = {"less than 90°", "90°", "more than 90°"};
  asked.answer = asked.choices[0];
  asked.refuted = "At 90° c lies on a side.";
  text.caption = fmt::format(
      "Question: {} lies in the slab. How large is the angle at {} between the ways to it and to "
      "{}?",
      shown.name(c), moving, other);
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  if (shown.trace.refusal) {
    text.caption =
        fmt::format("The proof does not take {}.", words_of(*shown.trace.refusal, shown.lesson));
    text.detail = "It needs two convex polygons.";
  } else if (!shown.has_points()) {
    text.caption = fmt::format("{} and {} overlap: the distance is 0.", shown.lesson.x().name,
                               shown.lesson.y().name);
    text.detail = "There is no slab between a point and itself.";
  } else if (shown.step == nullptr) {
    text.caption = fmt::format("x is a point of {}, y a point of {}. Are they the closest two?",
                               shown.lesson.x().name, shown.lesson.y().name);
    text.detail =
        "Slab(x, y) is the strip between the parallel lines through x and y, normal to y − x.";
  } else if (shown.is_answer) {
    const bool is_proved = shown.state().stop == Stop::empty;
    text.caption = fmt::format("The distance is {}{}.", is_proved ? "" : "at most ",
                               story.numbers(shown.state().distance()));
    text.detail =
        is_proved ? "Closest points have an empty slab, and points with an empty slab are closest: "
                    "each proves the other."
                  : "The slab is not empty yet.";
  } else if (shown.step->phase == Phase::slab) {
    slab(story, shown, text);
  } else {
    closer(story, shown, text);
  }
}

void question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const slab_proof::Step& step = shown.trace.descent.steps[story.frame.answering_step];
  FrameQuestion& asked =
      text.question.emplace(FrameQuestion{story.run.asked(story.frame).ask, {}, {}});
  if (asked.ask == kAskAngle.name) return angle_question(shown, step, text);
  for (const Reach& reach : step.farthest) asked.choices.push_back(shown.name(reach));
  asked.choices.emplace_back("none: the slab is empty");
  asked.answer = step.reaches.empty() ? asked.choices.back() : shown.name(step.reaches.front());
  text.caption = "Question: which vertex lies deepest in slab(x, y)?";
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  if (!shown.has_points()) return;
  put("distance", story.numbers(shown.state().distance()));
  if (shown.is(Phase::slab)) put("in the slab", std::to_string(shown.step->reaches.size()));
}

}  // namespace gjkscope::slabs
