#pragma once
// [time]: the moments of a simulation.

#include <cstddef>
#include <vector>

#include "lesson/tour_settings.hpp"

namespace gjkscope {

/// Moments of a simulation that lasts `seconds`: `frames` at equal steps, from first to last, or,
/// with `frames` 0, those listed for each position of X.
struct LessonTime {
  double seconds = 1.0;
  int frames = 2;
  std::vector<std::vector<double>> moments = {};  ///< In seconds, ascending.
  /// The moments at a position, in seconds.
  [[nodiscard]] std::vector<double> at(int position) const {
    if (frames == 0) return moments[position];
    std::vector<double> out;
    for (int i = 0; i < frames; ++i) out.push_back(seconds * i / (frames - 1));
    return out;
  }
  static const SettingsKind kKind;
  friend bool operator==(const LessonTime&, const LessonTime&) = default;
};

}  // namespace gjkscope
