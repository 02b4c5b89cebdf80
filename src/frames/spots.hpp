#pragma once
// The places at which a reader points for the choices of a question.

#include "picture/frame_text.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// The spots of choices that name vertices or edges: "K", "vertex K of Y", "edge KL of Y", "K−A",
/// "K−A to L−A". Nothing for all others.
[[nodiscard]] std::vector<std::optional<Spot>> spots_of(const LessonRun& run, const Frame& frame,
                                                        const std::vector<std::string>& choices);

/// The question can be answered in the drawing: by a vertex, an edge, a region, a place
/// or a mark.
[[nodiscard]] bool is_answered_in_drawing(const FrameQuestion& question);

}  // namespace gjkscope
