#pragma once
// The walk on features in space (outlines/v_clip.hpp) as the algorithm of a lesson: one step for
// each pair of features that it looks at, and for the last pair one for each of its two regions.

#include <array>

#include "lesson/algorithm.hpp"
#include "outlines/polyhedron.hpp"
#include "outlines/v_clip.hpp"
#include "run/run.hpp"
#include "subjects/feature_regions/features.hpp"

namespace gjkscope {

extern const Algorithm kWalkInSpaceAlgorithm;

class SpaceWalk final : public AlgorithmTrace {
 public:
  using Pair = std::array<int, 2>;  ///< Indices of `features`.
  /// One pair, and the decision about it.
  struct Step {
    int number = 1;  ///< Counts pairs.
    Pair at = {};
    Pair next = {};  ///< The same where a region holds the other's point, and where bodies overlap.
    std::array<Eigen::Vector3d, 2> points;  ///< The closest points of the pair.
    v_clip::Reason reason = v_clip::Reason::none;
    bool is_region = false;  ///< A test of regions, not the closest points alone.
    std::size_t body = 0;    ///< The one whose feature the decision is about.
    int border = -1;         ///< The border of its region that the other's point is beyond, or on.
    [[nodiscard]] bool moves() const { return next != at; }
    [[nodiscard]] double distance() const { return length(points[1] - points[0]); }
  };

  [[nodiscard]] int steps() const override { return static_cast<int>(all.size()); }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const override;
  [[nodiscard]] bool overlaps() const { return all.back().reason >= v_clip::Reason::meet; }
  [[nodiscard]] int pairs() const { return all.back().number; }
  /// "face KLM of Y"; of the body itself its name.
  [[nodiscard]] std::string name(const Lesson& lesson, std::size_t body, int feature) const;
  [[nodiscard]] const cells::Feature& feature(const Step& step) const {
    return features[step.body][step.at[step.body]];
  }
  [[nodiscard]] const cells::Border& border(const Step& step) const {
    return feature(step).borders[step.border];
  }
  /// How far the other's point lies beyond this border.
  [[nodiscard]] double beyond(const Step& step) const {
    return -border(step).depth(step.points[1 - step.body]);
  }

  std::array<std::vector<cells::Feature>, 2> features;  ///< Those of X and Y.
  std::vector<Step> all;                                ///< None where a body is flat.
  int cold = 0;  ///< Iterations of GJK from the lesson's start; along a path.
};

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const SpaceWalk& space_walk_trace(const AlgorithmTrace& trace) {
  return static_cast<const SpaceWalk&>(trace);
}

}  // namespace gjkscope
