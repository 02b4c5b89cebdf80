#pragma once
// What is measured as polygons grow (growth.hpp), plotted against their vertices.

#include "picture/plot.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Iterations and support calls, beside what Larsen reports.
[[nodiscard]] Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

/// Points of Z and those computed; vertices that support calls look at, and that scans would.
[[nodiscard]] Plot points_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

}  // namespace gjkscope
