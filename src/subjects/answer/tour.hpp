#pragma once
// The parts of a step that frames of the tour `witness` show.

#include <optional>

#include "run/run.hpp"

namespace gjkscope {

/// Parts of one answer: P and its weights, the same weights on the vertices of Y, on those of X,
/// and the distance between what they give.
enum class WitnessPart { p, on_y, on_x, distance };
[[nodiscard]] std::optional<WitnessPart> witness_part(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
