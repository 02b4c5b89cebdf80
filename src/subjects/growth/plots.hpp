#pragma once
// Plots of the measurements of growth.hpp against the vertices of the polygons.

#include <array>
#include <string>

#include "lesson/vocabulary.hpp"
#include "picture/plot.hpp"
#include "run/graph.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope {

inline constexpr AskInfo kAskIterations{
    "iterations", "how many times the iterations of the last size a size takes", "about size"};

/// A place that a question about a size chooses from.
struct WayToGrow {
  std::string name;  ///< "as n"
  double ratio;      ///< To the size before.
};
[[nodiscard]] std::array<WayToGrow, 3> ways_to_grow(const LessonGrowth& growth, int size);

/// Iterations and support calls, beside what Larsen reports.
[[nodiscard]] Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

/// Points of Z and those computed; vertices that support calls look at, and that scans would.
[[nodiscard]] Plot points_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

}  // namespace gjkscope
