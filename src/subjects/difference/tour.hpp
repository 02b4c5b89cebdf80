#pragma once
// The parts of a step that frames of the tour `pairs` show.

#include <optional>
#include <vector>

#include "lesson/vocabulary.hpp"
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

/// A difference is asked for before it is drawn: of the second vertex of X and the third of Y.
inline constexpr AskInfo kAskPlace{"place", "the place of a difference, among some"};
inline constexpr gjk::VertexPair kAskedDifference{1, 2};
/// Differences with places to choose from, in the order of their numbers.
[[nodiscard]] std::vector<gjk::VertexPair> places_to_choose(const LessonRun& run);

}  // namespace gjkscope
