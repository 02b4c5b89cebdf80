#pragma once
// The parts of a step that frames of the act `pairs` show.

#include <optional>

#include "run/run.hpp"

namespace gjkscope {

/// How a Minkowski difference is built: the first difference, a copy of Y for each vertex of X, −X,
/// and −X at each vertex of Y; the hull, where its edges come from; any difference, the shortest.
enum class BuildPart { start, pair, copy, mirror, slide, hull, edges, any, shortest };
struct BuildFrame {
  BuildPart part = BuildPart::start;
  int made = 0;  ///< Differences made: those of the first vertex of X come first.
};
[[nodiscard]] std::optional<BuildFrame> build_frame(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
