#pragma once
// Edge by edge to the Minkowski difference, on the shapes of a lesson.

#include "run/outline_trace.hpp"
#include "subjects/minkowski_sum/merge.hpp"

namespace gjkscope {

/// Two convex polygons.
extern const Algorithm kMinkowskiSumAlgorithm;

class SumTrace final : public OutlineTrace {
 public:
  SumTrace(std::optional<Refusal> refused, minkowski_sum::Merge merged);

  [[nodiscard]] int steps() const override { return static_cast<int>(merge.steps.size()); }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;

  minkowski_sum::Merge merge;

 protected:
  [[nodiscard]] fields::Json step_json(const Lesson& lesson, int index) const override;
  [[nodiscard]] fields::Json result_json(const Lesson& lesson) const override;
};

/// "K−A"
[[nodiscard]] std::string corner_name(const Lesson& lesson, const minkowski_sum::Merge& merge,
                                      const minkowski_sum::Corner& corner);
/// "edge KL of Y", "edge AB of −X", "edges KL of Y and AB of −X": what leads on from a corner.
[[nodiscard]] std::string edge_name(const Lesson& lesson, const minkowski_sum::Merge& merge,
                                    const minkowski_sum::Corner& from,
                                    minkowski_sum::Source source);

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const SumTrace& sum_trace(const AlgorithmTrace& trace) {
  return static_cast<const SumTrace&>(trace);
}

}  // namespace gjkscope
