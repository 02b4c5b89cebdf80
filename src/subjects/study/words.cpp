#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "picture/story.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/study/dot_words.hpp"
#include "subjects/study/rounded_pair.hpp"
#include "subjects/study/subject.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"

namespace gjkscope::captions {
namespace {

/// "7 digits", "no digit": those of an answer that are right.
std::string right_digits(double error) {
  const int digits = error > 0.0 ? static_cast<int>(std::floor(-std::log10(error))) : 16;
  return digits <= 0 ? "no digit" : digits == 1 ? "1 digit" : fmt::format("{} digits", digits);
}

/// "0.0000003"
std::string small_number(double value) {
  const int decimals = value > 0.0 ? static_cast<int>(std::ceil(-std::log10(value))) : 1;
  return fixed(value, std::clamp(decimals, 0, 16));
}

/// The pairs for which `who` is wrong, or cannot tell.
std::string of_pairs(const std::string& who, const StudyDot& dot) {
  std::string out;
  if (dot.wrong > 0)
    out = fmt::format("{} gets \"overlap or not\" wrong for {} of {} pairs. ", who, dot.wrong,
                      dot.pairs);
  if (dot.undecided > 0)
    out += fmt::format("{} cannot tell \"overlap or not\" for {} of {} pairs. ", who, dot.undecided,
                       dot.pairs);
  return out;
}

/// The dot that the mark number `mark`, from 1, is compared with.
const StudyDot& compared_with(const LessonStudy& study, int mark) {
  const auto index = static_cast<std::size_t>(mark - 1);
  const std::string& beside = study.marks[index].beside;
  return study.dot(beside.empty() ? study.marks[index - 1].configuration : beside);
}

/// "1.9 times as long as", "as long as", "0.75 of the time of"
std::string compared(double ns, double with) {
  const double ratio = ns / with;
  if (ratio > 1.0 / kSameTime && ratio < kSameTime) return "about as long as";
  if (ratio < 1.0) return fmt::format("{:.0f} % of the time of", 100.0 * ratio);
  return fmt::format("{:.{}f} times as long as", ratio, ratio < 10.0 ? 1 : 0);
}

// The pair.

void shapes(const Story& story, const RoundedPair::Value& pair, FrameText& text) {
  const Lesson& lesson = story.run.lesson;
  text.caption = fmt::format("Two shapes, {} and {}.", lesson.x().name, lesson.y().name);
  if (!pair.facing.empty()) {
    text.caption += fmt::format(" The edges that face each other are {} degrees from parallel.",
                                small_number(pair.tilt * 180.0 / std::numbers::pi));
  }
  text.detail = "From afar the shapes seem to touch along these edges.";
}

void gap(const RoundedPair::Value& pair, FrameText& text) {
  if (pair.distance() == 0.0) {
    text.caption = "The shapes have a point in common: their distance is 0.";
    return;
  }
  text.caption = fmt::format(
      "Enlarged {} times, a gap appears. The distance is the shortest way across it: {}.",
      grouped(pair.magnification()), power_text(pair.distance(), 3));
  const double other = pair.ends[1].exact.length;
  if (other > pair.distance()) {
    text.detail = fmt::format(
        "At the other end the gap is {}, hardly more: the last digits of the vertices decide which "
        "end is closer.",
        power_text(other, 3));
  }
}

void in_float(const RoundedPair::Value& pair, FrameText& text) {
  const double at = pair.ends[0].exact.vertex.y();
  text.caption = fmt::format(
      "A float has 24 binary digits. Near {:.2g} the next float is {} away, so each vertex moves "
      "to "
      "the nearest dot.",
      at, power_text(spacing_of_floats(at), 2));
  text.detail = fmt::format(
      "GJK in float answers {}{}. That is the distance of the moved shapes (dotted); GJK knows no "
      "others.",
      power_text(pair.in_float.trace.result.distance, 3),
      pair.ends[0].exact.vertex == pair.ends[1].exact.vertex ? "" : ", at the other end");
}

void in_double(const RoundedPair::Value& pair, FrameText& text) {
  const double error = error_of(pair.in_double.trace.result.distance, pair.distance());
  text.caption =
      "A double has 53 binary digits. Its dots are 500 million times closer together, too close to "
      "draw: no vertex moves.";
  text.detail = fmt::format("GJK in double answers {}: {}.",
                            power_text(pair.in_double.trace.result.distance, 3),
                            error == 0.0 ? "every digit that a double can hold is right"
                                         : right_digits(error) + " are right");
}

void error(const RoundedPair::Value& pair, FrameText& text) {
  const double answer = pair.in_float.trace.result.distance;
  const double of_float = error_of(answer, pair.distance());
  const double of_double = error_of(pair.in_double.trace.result.distance, pair.distance());
  text.caption =
      "The error of an answer is how far it is off, divided by the distance or the answer, "
      "whichever "
      "is larger.";
  text.detail = fmt::format(
      "In float: |{} − {}| / {} = {}. {} is right. In double: {}.", power_text(answer, 3),
      power_text(pair.distance(), 3), power_text(std::max(answer, pair.distance()), 3),
      power_text(of_float, 2), capitalized(right_digits(of_float)), power_text(of_double, 2));
}

// The plot.

void error_axis(const LessonStudy& study, FrameText& text) {
  const StudyDot first = introduced(study, 1).front();
  text.caption = fmt::format(
      "Now {} pairs like this one. Each mark is a way to run GJK, drawn at its largest error: "
      "lower "
      "is more accurate.",
      first.pairs);
  const std::string wrong = of_pairs(first.configuration, first);
  text.detail = "At 10⁻⁸ eight digits are right, at 1 none is. " + capitalized(wrong);
}

void time_axis(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> marks = introduced(study, 2);
  text.caption = fmt::format(
      "The second axis is the time for one pair, on one thread of an {}. Farther left is faster.",
      study.processor());
  std::vector<std::string> times;
  for (const StudyDot& dot : marks)
    times.push_back(fmt::format("{} takes {}", dot.configuration, time_text(dot.ns)));
  text.detail = fmt::format("{}", fmt::join(times, ", "));
  const auto most =
      std::max_element(marks.begin(), marks.end(),
                       [](const StudyDot& a, const StudyDot& b) { return a.settled < b.settled; });
  if (most->settled > 0) {
    text.detail += fmt::format(". Exact arithmetic must decide {} of {} pairs that {} leaves open",
                               most->settled, most->pairs, most->configuration);
  }
  text.detail += ".";
}

void mark(const LessonStudy& study, const StudyFrame& frame, FrameText& text) {
  const StudyMark& shown = study.marks[frame.marks - 1];
  const StudyDot& dot = study.dot(shown.configuration);
  const StudyDot& beside = compared_with(study, frame.marks);
  text.caption = fmt::format(
      "{}: {} for a pair, {} {}. {}.", dot.configuration, time_text(dot.ns),
      compared(dot.ns, beside.ns), beside.configuration,
      dot.error ? "Largest error: " + error_words(dot) : "For some pair it has no answer");
  text.detail = of_pairs("It", dot) + shown.note;
}

void front(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> best =
      front_among(introduced(study, static_cast<int>(study.marks.size())));
  std::vector<std::string> names;
  for (const StudyDot& dot : best) names.push_back(dot.configuration);
  text.caption =
      "Which would you take? A mark is beaten if another is as fast, within 10 %, and as accurate.";
  text.detail = fmt::format(
      "The dotted line joins the marks that none beats, the front: {}. A smaller error costs time.",
      fmt::join(names, "; "));
}

void all(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> family = of_family(study.dots(), study.family);
  const std::vector<StudyDot> best = front_of(family);
  text.caption = fmt::format(
      "All {} ways that were measured; {} are new: other tolerances, caps, rules and starts.",
      family.size(), family.size() - study.marks.size());
  text.detail = fmt::format(
      "{} of them are the front: they beat all others that get a digit right. Times within 10 % "
      "count as equal, and so do errors within a factor of 2.",
      best.size());
}

void choice(const LessonStudy& study, FrameText& text) {
  const std::vector<StudyDot> family = of_family(study.dots(), study.family);
  text.caption =
      "Take the fastest way with the digits that you need, and a proved one if a wrong answer "
      "would "
      "do harm.";
  // The rule of three: 0 of n leaves room for 3 / n, with 95 % confidence.
  text.detail = fmt::format(
      "Without a proof nothing tells that an answer is wrong: an error that none of {} pairs "
      "showed "
      "may still happen to one pair in {}.",
      family.front().pairs, family.front().pairs / 3);
}

// Questions.

constexpr std::array<double, 6> kRatios = {1.0, 3.0, 10.0, 50.0, 200.0, 1000.0};

std::string ratio_words(double ratio) {
  return ratio == 1.0 ? "as long" : fmt::format("about {} times", ratio);
}

}  // namespace

void study_question(const Story& story, FrameText& text) {
  const LessonStudy& study = *story.run.lesson.settings.as<LessonStudy>();
  const StudyFrame before = *study_frame(story.run, story.frame);
  const std::string& ask = story.run.asked(story.frame).ask;
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  if (ask == "overlap") {
    const RoundedPair::Value& pair = story.effects.get<RoundedPair>(story.frame);
    asked.choices = {"yes", "no"};
    asked.answer = pair.distance() > 0.0 ? "no" : "yes";
    text.caption = fmt::format("Question: do {} and {} have a point in common?",
                               story.run.lesson.x().name, story.run.lesson.y().name);
    text.detail = "yes  ·  no";
    return;
  }
  const StudyMark& next = study.marks[before.marks];
  const StudyDot& dot = study.dot(next.configuration);
  const StudyDot& with = compared_with(study, before.marks + 1);
  for (const double ratio : kRatios) asked.choices.push_back(ratio_words(ratio));
  const double ratio = std::log(dot.ns / with.ns);
  const auto nearest = std::min_element(kRatios.begin(), kRatios.end(), [&](double a, double b) {
    return std::abs(std::log(a) - ratio) < std::abs(std::log(b) - ratio);
  });
  asked.answer = ratio_words(*nearest);
  text.caption = fmt::format(
      "Question: next comes {}{}. How long does it take, compared with {}?", dot.configuration,
      next.about.empty() ? "" : fmt::format(" ({})", next.about), with.configuration);
}

void study(const Story& story, FrameText& text) {
  const LessonStudy& study = *story.run.lesson.settings.as<LessonStudy>();
  const StudyFrame frame = *study_frame(story.run, story.frame);
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
