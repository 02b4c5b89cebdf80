#pragma once
// The closest points of two outlines at a position, by all pairs of segments, as the algorithm of a
// lesson (Larsen 1998, "Distance for General Models").

#include "lesson/algorithm.hpp"
#include "outlines/brute.hpp"
#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/outline_trace.hpp"
#include "run/run.hpp"

namespace gjkscope {

extern const Algorithm kAllPairsAlgorithm;

/// The trace of one position.
class AllPairsTrace final : public OutlineTrace {
 public:
  AllPairsTrace(std::optional<Refusal> refused, OutlinesOfRun outlines);

  [[nodiscard]] int steps() const override { return refusal ? 0 : 1; }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;

  OutlinesOfRun models;
  models::Answer closest;

 protected:
  [[nodiscard]] fields::Json step_json(const Lesson& lesson, int step) const override;
  [[nodiscard]] fields::Json result_json(const Lesson& lesson) const override;
};

/// Only for runs of a tour that shows this algorithm.
[[nodiscard]] inline const AllPairsTrace& all_pairs_trace(const LessonRun& run, int index) {
  return static_cast<const AllPairsTrace&>(*run.algorithm_traces[index]);
}

namespace jumps {
extern const Tour kTour;
extern const Block kMoves;
}  // namespace jumps

}  // namespace gjkscope
