#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lesson/study_times.hpp"
#include "picture/captions/story.hpp"

namespace gjkscope::captions {
namespace {

using fmt::format;

/// "1.4e-09" as "1.4·10⁻⁹".
std::string with_powers(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return number;
  return format("{}·10{}", number.substr(0, e), raised(std::stoi(number.substr(e + 1))));
}

std::string error_of(const StudyDot& dot) {
  return dot.error ? with_powers(error_text(*dot.error)) : "none";
}

/// Significant digits, zeros at the end, too.
std::string to_digits(double value, int digits) {
  return value == 0.0 ? "0" : with_powers(format("{:#.{}g}", value, digits));
}

/// The fewest digits that tell two values apart, and one more.
int digits_to_tell_apart(double a, double b) {
  constexpr int kAll = 17;
  int digits = 3;
  while (digits < kAll && to_digits(a, digits) == to_digits(b, digits)) ++digits;
  return std::min(digits + 1, kAll);
}

void configuration(const LessonStudy& shown, const StudyDot& dot, FrameText& text) {
  text.caption = format("{}: {} a query", dot.configuration, time_text(dot.ns));
  const StudyDot* base = default_of(shown.dots, shown.family);
  if (base == &dot) {
    text.caption += ", the default that times are compared with. ";
  } else if (base) {
    text.caption +=
        format(", {:.2f} times as long as {}, the default. ", dot.ratio, base->configuration);
  } else {
    text.caption += ". ";
  }
  text.caption += dot.error ? format("The error is at most {} of the scale", error_of(dot))
                            : std::string("To some pair it has no answer");
  text.caption += dot.on_front ? ": nothing is both faster and more accurate." : ".";
  if (dot.answer && *dot.answer != dot.distance) {
    const int digits = digits_to_tell_apart(dot.distance, *dot.answer);
    text.detail = format("Worst of {} pairs: the distance is {}, the answer {}.", dot.pairs,
                         to_digits(dot.distance, digits), to_digits(*dot.answer, digits));
  } else if (dot.answer) {
    text.detail = format(
        "Worst of {} pairs: the distance is {}, and the answer is as close as a double can be.",
        dot.pairs, to_digits(dot.distance, 17));
  } else {
    text.detail =
        format("On {} pairs; the one shown has the distance {:.4g}.", dot.pairs, dot.distance);
  }
  if (dot.wrong > 0)
    text.detail += format(" Whether shapes overlap it says wrongly of {} {}.", dot.wrong,
                          dot.wrong == 1 ? "pair" : "pairs");
  if (dot.undecided > 0)
    text.detail += format(" Of {} {} it leaves open whether they overlap.", dot.undecided,
                          dot.undecided == 1 ? "pair" : "pairs");
}

void outcome(const std::vector<StudyDot>& family, FrameText& text) {
  const std::vector<StudyDot> front = front_of(family);
  text.caption = format(
      "Of {} ways to answer, {} are on the Pareto front: for each of the others one is as fast and "
      "more accurate, or as accurate and faster.",
      family.size(), front.size());
  if (front.empty()) return;
  text.detail =
      format("From {} ({}, error {}) to {} ({}, error {}).", front.front().configuration,
             time_text(front.front().ns), error_of(front.front()), front.back().configuration,
             time_text(front.back().ns), error_of(front.back()));
}

}  // namespace

void study(const Story& story, FrameText& text) {
  const LessonStudy& shown = *story.run.lesson.study;
  const auto index = static_cast<std::size_t>(story.frame.detail);
  if (index < shown.configurations.size())
    return configuration(shown, shown.dot(shown.configurations[index]), text);
  outcome(of_family(shown.dots, shown.family), text);
}

}  // namespace gjkscope::captions
