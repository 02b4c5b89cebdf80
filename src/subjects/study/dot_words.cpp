#include "subjects/study/dot_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/words.hpp"
#include "subjects/study/subject.hpp"

namespace gjkscope {
namespace {

/// The plainest of the fastest that suit.
template <class Suits>
const StudyDot* fastest(const std::vector<StudyDot>& family, Suits suits) {
  double least = INFINITY;
  for (const StudyDot& dot : family) {
    if (dot.error && suits(dot)) least = std::min(least, dot.ns);
  }
  const auto found = std::find_if(family.begin(), family.end(), [&](const StudyDot& dot) {
    return dot.error && suits(dot) && dot.ns <= kSameTime * least;
  });
  return found == family.end() ? nullptr : &*found;
}

}  // namespace

std::string error_words(const StudyDot& dot) {
  return dot.error ? power_text(*dot.error, 2) : "none";
}

std::vector<StudyDot> introduced(const LessonStudy& study, int count) {
  std::vector<StudyDot> out;
  for (int i = 0; i < count; ++i) out.push_back(study.dot(study.marks[i].configuration));
  return out;
}

std::string about(const LessonStudy& study, const StudyDot& dot) {
  for (const StudyMark& mark : study.marks) {
    if (mark.configuration == dot.configuration && !mark.about.empty()) return mark.about;
  }
  if (dot.axis == "tolerance") return "stops when its bounds are so close";
  if (dot.axis == "cap") return "stops after so many iterations";
  if (dot.axis == "start") return "starts from other vertices";
  if (dot.axis == "stop rule") return "leaves out a stop test";
  if (dot.axis == "direction and regions") return "another rule for directions or regions";
  if (dot.proof == "none") return "no bounds, no proof";
  return dot.proof == "bounds" ? "bounds, but no exact arithmetic" : "every answer proved";
}

std::vector<StudyDot> front_among(std::vector<StudyDot> dots) {
  std::vector<Cost> costs;
  for (const StudyDot& dot : dots) costs.push_back({dot.ns, dot.error.value_or(INFINITY)});
  const std::vector<bool> front = front_of(costs);
  for (std::size_t i = 0; i < dots.size(); ++i) dots[i].on_front = front[i];
  return front_of(dots);
}

std::optional<StudyDot> beaten_by(const StudyDot& dot, const std::vector<StudyDot>& others) {
  std::optional<StudyDot> out;
  for (const StudyDot& other : others) {
    if (!other.error || (out && out->ns <= other.ns)) continue;
    const bool beats = other.ns <= kSameTime * dot.ns &&
                       (!dot.error || *other.error <= kSameError * *dot.error) &&
                       other.configuration != dot.configuration;
    if (beats) out = other;
  }
  return out;
}

std::vector<Choice> choices(const std::vector<StudyDot>& family) {
  constexpr int kMostDigits = 34;
  struct Range {
    int first;
    int last;
    const StudyDot* dot;
  };
  std::vector<Range> ranges;
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    const double limit = 0.5 * std::pow(10.0, -digits);
    const StudyDot* dot =
        fastest(family, [&](const StudyDot& each) { return *each.error <= limit; });
    if (!dot) break;
    if (!ranges.empty() && ranges.back().dot == dot) {
      ranges.back().last = digits;
    } else {
      ranges.push_back({digits, digits, dot});
    }
  }
  std::vector<Choice> out;
  for (const Range& range : ranges) {
    out.push_back({range.first == range.last
                       ? fmt::format("{} right digits", range.last)
                       : fmt::format("{} to {} right digits", range.first, range.last),
                   *range.dot});
  }
  const StudyDot* proved = fastest(family, [](const StudyDot& dot) {
    return dot.proof == "exact" && dot.wrong + dot.undecided == 0;
  });
  if (proved) out.push_back({"a proved \"overlap or not\"", *proved});
  return out;
}

}  // namespace gjkscope
