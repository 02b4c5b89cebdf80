#pragma once
// Frames that answer a question and have its wrong choices to refute.

#include <string_view>
#include <vector>

#include "run/run.hpp"

namespace gjkscope {

/// The run of a point query, started at one vertex: how many iterations it takes, and P.
struct RunFromVertex {
  int vertex = 0;
  int iterations = 0;
  Eigen::Vector3d p;
};
[[nodiscard]] std::vector<RunFromVertex> runs_from_each_vertex(const LessonRun& run,
                                                               const PositionedRun& positioned);

/// A frame answers this question.
[[nodiscard]] bool tells_answer(const LessonRun& run, const Frame& frame, std::string_view ask);

/// A frame with little room for other words: FrameQuestion::refuted ends its detail.
[[nodiscard]] bool refutes(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
