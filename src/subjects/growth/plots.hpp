#pragma once
// Plots of the measurements of growth.hpp against the vertices of the polygons.

#include <array>
#include <string_view>

#include "lesson/vocabulary.hpp"
#include "picture/plot.hpp"
#include "run/graph.hpp"
#include "subjects/growth/choices.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope {

inline constexpr AskInfo kAskIterations{
    "iterations", "how many times the iterations of the last size a size takes", "about size"};
inline constexpr AskInfo kAskScanned{
    "scanned", "how many times the vertices that scans of the last size look at a size takes",
    "about size"};
inline constexpr AskInfo kAskOutline{
    "outline", "how many times the edges of Z of the last size a size has", "about size"};
inline constexpr AskInfo kAskSlowest{"slowest", "iterations of a polygon that is built to be slow"};
inline constexpr AskInfo kAskDots{"dot-products", "how many dot products find a support point"};

/// The ways in which `counted` may grow, to a size from the one before.
[[nodiscard]] std::array<GrowthChoice, 3> growth_choices(const LessonGrowth& growth, int size,
                                                         std::string_view counted);
/// Iterations of the slowest polygons, beside those of the slowest random runs of that size.
struct Slowest {
  const Growth::Sample& random;
  const SlowGrowth::Run& built;
};
[[nodiscard]] Slowest slowest(EffectGraph& effects, const Frame& frame);
[[nodiscard]] std::array<GrowthChoice, 3> slow_choices(const Slowest& slowest);

/// Iterations on average and in the worst run, beside what Larsen reports.
[[nodiscard]] Plot iterations_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

/// Points of Z and those computed; vertices that support calls look at, and that scans would.
[[nodiscard]] Plot points_plot(const LessonRun& run, EffectGraph& effects, const Frame& frame);

}  // namespace gjkscope
