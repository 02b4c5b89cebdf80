#include "lesson/study_times.hpp"

#include <algorithm>
#include <cmath>

namespace gjkscope {

const StudyDot* default_of(const std::vector<StudyDot>& dots, std::string_view family) {
  const auto found = std::find_if(dots.begin(), dots.end(), [&](const StudyDot& dot) {
    return dot.family == family && dot.ratio == 1.0;
  });
  return found == dots.end() ? nullptr : &*found;
}

std::vector<StudyDot> timed_by_ratio(std::vector<StudyDot> dots) {
  for (const std::string& family : families_in(dots)) {
    const StudyDot* base = default_of(dots, family);
    if (!base) continue;
    const double ns = base->ns;
    for (StudyDot& dot : dots) {
      if (dot.family == family) dot.ns = ns * dot.ratio;
    }
  }
  const auto has_error = [](const StudyDot& dot) { return dot.error && std::isfinite(*dot.error); };
  for (StudyDot& dot : dots) {
    const auto beats = [&](const StudyDot& other) {
      return other.family == dot.family && has_error(other) && other.ns <= dot.ns &&
             *other.error <= *dot.error && (other.ns < dot.ns || *other.error < *dot.error);
    };
    dot.on_front = has_error(dot) && std::none_of(dots.begin(), dots.end(), beats);
  }
  return dots;
}

}  // namespace gjkscope
