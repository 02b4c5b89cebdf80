#pragma once
// The proof by slabs, on the shapes of a lesson.

#include "run/outline_trace.hpp"
#include "subjects/slab_proof/descent.hpp"

namespace gjkscope {

/// Two convex polygons. Their vertices in the first pair of `query.start` are where it begins.
extern const Algorithm kSlabProofAlgorithm;

class SlabTrace final : public OutlineTrace {
 public:
  SlabTrace(std::optional<Refusal> refused, slab_proof::Descent descended);

  [[nodiscard]] int steps() const override { return static_cast<int>(descent.steps.size()); }
  [[nodiscard]] StepInfo info(int index) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] std::string_view stop() const override;

  slab_proof::Descent descent;  ///< Without steps when the shapes overlap.

 protected:
  [[nodiscard]] fields::Json step_json(const Lesson& lesson, int index) const override;
  [[nodiscard]] fields::Json result_json(const Lesson& lesson) const override;
};

/// "vertex B of X"
[[nodiscard]] std::string vertex_name(const Lesson& lesson, const slab_proof::Reach& reach);

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const SlabTrace& slab_trace(const AlgorithmTrace& trace) {
  return static_cast<const SlabTrace&>(trace);
}

}  // namespace gjkscope
