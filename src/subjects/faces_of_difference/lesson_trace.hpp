#pragma once
// The faces of Y − X by what they come from, on the polyhedra of a lesson: one face of each kind,
// then all of that kind, then all there are.

#include <array>

#include "lesson/algorithm.hpp"
#include "run/run.hpp"
#include "subjects/faces_of_difference/faces.hpp"

namespace gjkscope {

extern const Algorithm kFacesOfDifferenceAlgorithm;

class FacesTrace final : public AlgorithmTrace {
 public:
  enum class Phase : std::uint8_t { one, kind, all };
  struct Step {
    Phase phase = Phase::all;
    sums_in_space::Kind kind = sums_in_space::Kind::of_y;
    int face = -1;  ///< The one that is shown.
  };

  [[nodiscard]] int steps() const override { return static_cast<int>(all.size()); }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const override;
  [[nodiscard]] int count(sums_in_space::Kind kind) const;

  std::array<Polyhedron, 2> hulls;  ///< Those of X and Y.
  std::vector<sums_in_space::Face> faces;
  std::vector<Step> all;   ///< None where a shape is flat.
  int support_points = 0;  ///< That GJK asked for.
};

/// "face KLM of Y", "edge AB of X", "vertex K of Y"
[[nodiscard]] std::string part_name(const LessonShape& shape, const std::vector<int>& vertices);

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const FacesTrace& faces_trace(const AlgorithmTrace& trace) {
  return static_cast<const FacesTrace&>(trace);
}

}  // namespace gjkscope
