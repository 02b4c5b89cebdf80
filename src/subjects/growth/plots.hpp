#pragma once
// Plots of the measurements of growth.hpp against the vertices of the polygons.

#include "picture/plot.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// Iterations and support calls, beside what Larsen reports.
[[nodiscard]] Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

/// Points of Z and those computed; vertices that support calls look at, and that scans would.
[[nodiscard]] Plot points_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

}  // namespace gjkscope
