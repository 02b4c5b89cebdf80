#pragma once
// How long methods for general models take, on the outlines that lessons of the tour
// `general-growth` count visits of.

#include <functional>
#include <string>
#include <vector>

#include "lesson/lesson.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope {

/// Times for the first pair of outlines of each size.
struct ModelTimes {
  std::string lesson;
  std::vector<int> sizes;
  GrowthTimes times;  ///< Medians, of processor time.
};

/// One entry; none for a lesson of another tour, or if `go_on` said no. Comparing all pairs
/// of large outlines would take minutes: only a share of X's segments is compared, and the time is
/// multiplied.
[[nodiscard]] std::vector<ModelTimes> model_times(
    const Lesson& lesson, int turns, const std::function<bool()>& go_on = [] { return true; });

/// For a terminal.
[[nodiscard]] std::string model_times_table(const std::vector<ModelTimes>& all);
/// The tables [growth.times] for the files of the lessons, each after a comment that names its
/// lesson.
[[nodiscard]] std::string model_times_toml(const std::vector<ModelTimes>& all);

}  // namespace gjkscope
