#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "effects/rounded_pair.hpp"
#include "picture/captions/story.hpp"
#include "picture/study_words.hpp"

namespace gjkscope::captions {
namespace {

using fmt::format;

/// "7 digits", "no digit": those of an answer that are right.
std::string right_digits(double error) {
  const int digits = error > 0.0 ? static_cast<int>(std::floor(-std::log10(error))) : 16;
  return digits <= 0 ? "no digit" : digits == 1 ? "1 digit" : format("{} digits", digits);
}

/// "0.0000003"
std::string small_number(double value) {
  const int decimals = value > 0.0 ? static_cast<int>(std::ceil(-std::log10(value))) : 1;
  return fixed(value, std::clamp(decimals, 0, 16));
}

std::string of_pairs(const StudyDot& dot) {
  std::string out;
  if (dot.wrong > 0)
    out = format("It gets \"overlap or not\" wrong for {} of {} pairs. ", dot.wrong, dot.pairs);
  if (dot.undecided > 0)
    out +=
        format("It cannot tell \"overlap or not\" for {} of {} pairs. ", dot.undecided, dot.pairs);
  return out;
}

/// "1.9 times as long as", "as long as", "0.75 of the time of"
std::string compared(double ns, double with) {
  const double ratio = ns / with;
  if (ratio > 1.0 / kSameTime && ratio < kSameTime) return "about as long as";
  if (ratio < 1.0) return format("{:.0f} % of the time of", 100.0 * ratio);
  return format("{:.{}f} times as long as", ratio, ratio < 10.0 ? 1 : 0);
}

// The pair.

void shapes(const Story& story, const RoundedPair::Value& pair, FrameText& text) {
  const Lesson& lesson = story.run.lesson;
  text.caption = pair.tilt ? format(
                                 "{} and {}: the edges that face each other are parallel but for "
                                 "{} degrees.",
                                 lesson.x.name, lesson.y.name,
                                 small_number(*pair.tilt * 180.0 / std::numbers::pi))
                           : format("{} and {}.", lesson.x.name, lesson.y.name);
  text.detail = "From afar they seem to touch.";
}

void gap(const RoundedPair::Value& pair, FrameText& text) {
  if (pair.distance() == 0.0) {
    text.caption = "The shapes have a point in common: their distance is 0.";
    return;
  }
  text.caption = format(
      "{} times larger, there is a gap. The distance is the shortest way across "
      "it: {}.",
      grouped(pair.magnification()), power_text(pair.distance(), 3));
  const double other = pair.ends[1].exact.length;
  if (other > pair.distance()) {
    text.detail = format(
        "At the other end the gap is {}, only {} more: which end is closer "
        "depends on the last digits of the vertices.",
        power_text(other, 3), power_text(other - pair.distance(), 2));
  }
}

void in_float(const RoundedPair::Value& pair, FrameText& text) {
  const double at = pair.ends[0].exact.vertex.y();
  const double answer = pair.in_float.trace.result.distance;
  text.caption = format(
      "The same pair in float: 24 binary digits. Near {:.2g} one float is {} from "
      "the next (dots), so vertices move to the nearest dot.",
      at, power_text(spacing_of_floats(at), 2));
  text.detail = format(
      "GJK in float answers {}{}: the right answer for the moved shapes (dotted), "
      "but not for the given ones.",
      power_text(answer, 3),
      pair.ends[0].exact.vertex == pair.ends[1].exact.vertex ? "" : ", and at the other end");
}

void in_double(const RoundedPair::Value& pair, FrameText& text) {
  const double error = error_of(pair.in_double.trace.result.distance, pair.distance());
  text.caption =
      "The same pair in double: 53 binary digits. The dots are 500 million times closer "
      "together, too close to draw: no vertex moves.";
  text.detail =
      format("GJK in double answers {}: {}.", power_text(pair.in_double.trace.result.distance, 3),
             error == 0.0 ? "every digit that a double can hold is right"
                          : right_digits(error) + " are right");
}

void error(const RoundedPair::Value& pair, FrameText& text) {
  const double answer = pair.in_float.trace.result.distance;
  const double of_float = error_of(answer, pair.distance());
  const double of_double = error_of(pair.in_double.trace.result.distance, pair.distance());
  text.caption =
      "The error of an answer: how far it is off, as a share of the distance or of the "
      "answer, whichever is larger.";
  text.detail =
      format("In float: |{} − {}| / {} = {}: {} is right. In double: {}.", power_text(answer, 3),
             power_text(pair.distance(), 3), power_text(std::max(answer, pair.distance()), 3),
             power_text(of_float, 2), right_digits(of_float), power_text(of_double, 2));
}

// The plot.

void error_axis(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> marks = introduced(study, 2);
  text.caption = format(
      "One pair says little. Now {} pairs like it: each mark is a way to run GJK, "
      "at the largest error seen on them.",
      marks.front().pairs);
  text.detail =
      "Each line of the axis is a power of ten: at 10⁻⁸ eight digits are right, at 1 not "
      "one. " +
      of_pairs(marks.front());
}

void time_axis(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> marks = introduced(study, 2);
  text.caption = format(
      "The second axis: how long one query takes, measured on one thread of an {}. "
      "Left is faster, down is more accurate.",
      study.processor);
  if (marks.size() < 2) return;
  text.detail = format("{} takes {}, {} {}, {} {}.", marks[0].configuration, time_text(marks[0].ns),
                       marks[1].configuration, time_text(marks[1].ns),
                       compared(marks[1].ns, marks[0].ns), marks[0].configuration);
}

/// The last mark beside the second, the loop in double, or the one that it goes on from.
void mark(const LessonStudy& study, const StudyFrame& frame, FrameText& text) {
  const std::vector<StudyDot> marks = introduced(study, frame.marks);
  const StudyMark& shown = study.marks[marks.size() - 1];
  const StudyDot& dot = marks.back();
  const StudyDot& before = marks[marks.size() - 2];
  text.caption =
      format("{}: {} a query, {} {}. {}.", dot.configuration, time_text(dot.ns),
             compared(dot.ns, before.ns), before.configuration,
             dot.error ? format("Largest error seen of {} pairs: {}", dot.pairs, error_words(dot))
                       : "To some pair it has no answer");
  text.detail = of_pairs(dot) + shown.note;
}

void front(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> marks = introduced(study, static_cast<int>(study.marks.size()));
  const std::vector<StudyDot> best = front_among(marks);
  std::vector<std::string> names;
  for (const StudyDot& dot : best) names.push_back(dot.configuration);
  text.caption =
      "Which would you take? A mark is beaten if another one is faster and at least as "
      "accurate. The line joins those that are not beaten: the front.";
  text.detail = format("On the front: {}. Whoever takes another mark pays more than needed.",
                       fmt::join(names, "; "));
}

void all(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> family = of_family(study.dots, study.family);
  const std::vector<StudyDot> best = front_of(family);
  const auto others = family.size() - study.marks.size();
  text.caption = format(
      "The study measured {} more ways (pale dots): other tolerances, caps, "
      "directions, region tests, starts, and the half format.",
      others);
  text.detail = format(
      "The front of all {}: {} ways. Every other way is beaten by one of these, or "
      "takes the same time and is no plainer.",
      family.size(), best.size());
}

void choice(const LessonStudy& study, FrameText& text) {
  const std::vector<Choice> found = choices(of_family(study.dots, study.family));
  text.caption = "What to take: the fastest way on the front that gives the digits that you need.";
  if (found.empty()) return;
  text.detail = format(
      "For {}: {}, {}. These are pairs that are hard for rounding; ordinary ones "
      "are faster and more accurate.",
      found.back().need, found.back().dot.configuration, time_text(found.back().dot.ns));
}

// Questions.

constexpr std::array<double, 6> kRatios = {1.0, 3.0, 10.0, 30.0, 100.0, 300.0};

std::string ratio_words(double ratio) {
  return ratio == 1.0 ? "as long" : format("{} times", ratio);
}

}  // namespace

void study_question(const Story& story, FrameText& text) {
  const LessonStudy& study = *story.run.lesson.study;
  const StudyFrame before = story.run.study(story.frame);
  FrameQuestion& asked = *text.question;
  if (asked.ask == "overlap") {
    const RoundedPair::Value& pair = story.effects.get<RoundedPair>(story.frame);
    asked.choices = {"yes", "no"};
    asked.answer = pair.distance() > 0.0 ? "no" : "yes";
    text.caption =
        format("Question: do {} and {} touch?", story.run.lesson.x.name, story.run.lesson.y.name);
    text.detail = "What would you want to see before you answer?";
    return;
  }
  const std::vector<StudyDot> marks = introduced(study, before.marks + 1);
  const StudyDot& dot = marks.back();
  const StudyDot& with = marks[marks.size() - 2];
  for (const double ratio : kRatios) asked.choices.push_back(ratio_words(ratio));
  const double ratio = std::log(dot.ns / with.ns);
  const auto nearest = std::min_element(kRatios.begin(), kRatios.end(), [&](double a, double b) {
    return std::abs(std::log(a) - ratio) < std::abs(std::log(b) - ratio);
  });
  asked.answer = ratio_words(*nearest);
  const std::string& about = study.marks[marks.size() - 1].about;
  text.caption =
      format("Question: next comes {}{}. About how many times as long as {} does it take?",
             dot.configuration, about.empty() ? "" : format(" ({})", about), with.configuration);
  text.detail = format("{}", fmt::join(asked.choices, "  ·  "));
}

void study(const Story& story, FrameText& text) {
  const LessonStudy& study = *story.run.lesson.study;
  const StudyFrame frame = story.run.study(story.frame);
  const auto pair = [&]() -> const RoundedPair::Value& {
    return story.effects.get<RoundedPair>(story.frame);
  };
  switch (frame.stage) {
    case StudyStage::shapes:
      return shapes(story, pair(), text);
    case StudyStage::gap:
      return gap(pair(), text);
    case StudyStage::in_float:
      return in_float(pair(), text);
    case StudyStage::in_double:
      return in_double(pair(), text);
    case StudyStage::error:
      return error(pair(), text);
    case StudyStage::error_axis:
      return error_axis(study, text);
    case StudyStage::time_axis:
      return time_axis(study, text);
    case StudyStage::mark:
      return mark(study, frame, text);
    case StudyStage::front:
      return front(study, text);
    case StudyStage::all:
      return all(study, text);
    case StudyStage::choice:
      return choice(study, text);
  }
}

}  // namespace gjkscope::captions
