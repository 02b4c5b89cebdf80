#pragma once
// Voronoi regions of features on the bodies of a lesson. In a point query: those of Y by kind, then
// the one that holds Q. Of two bodies: two pairs of points, and whether each point lies in the
// region of the other's feature (Larsen 1998, "Local Verification").

#include <array>

#include "lesson/algorithm.hpp"
#include "outlines/polyhedron.hpp"
#include "run/run.hpp"
#include "subjects/feature_regions/features.hpp"

namespace gjkscope {

extern const Algorithm kFeatureRegionsAlgorithm;

class RegionsTrace final : public AlgorithmTrace {
 public:
  enum class Phase : std::uint8_t { one, kind, all, query, region, plane, slab, pair };
  struct Step {
    Phase phase = Phase::all;
    int pair = 0;           ///< Index of the pair; in a point query it is Q and its closest point.
    std::size_t body = 1;   ///< The one that has the feature.
    cells::Kind kind = {};  ///< For `one` and `kind`.
    int feature = -1;       ///< For `one`.
  };
  /// A point of X and one of Y, each on a feature.
  struct Pair {
    std::array<Eigen::Vector3d, 2> points;
    std::array<int, 2> features = {-1, -1};
    [[nodiscard]] double distance() const { return length(points[1] - points[0]); }
  };
  [[nodiscard]] int steps() const override { return static_cast<int>(all.size()); }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const override;
  [[nodiscard]] int count(cells::Kind kind) const;
  /// "face KLM", of two bodies "face KLM of Y"; without a feature the name of the body.
  [[nodiscard]] std::string name(const Lesson& lesson, std::size_t body, int feature) const;
  /// The feature that a step is about; -1: the query point lies in the body.
  [[nodiscard]] int feature(const Step& step) const {
    const Pair& pair = pairs[step.pair];
    return step.feature < 0 ? pair.features[step.body] : step.feature;
  }
  [[nodiscard]] const std::vector<cells::Border>& borders(const Step& step) const {
    return features[step.body][feature(step)].borders;
  }
  /// The point that its region is asked about.
  [[nodiscard]] const Eigen::Vector3d& point(const Step& step) const {
    return pairs[step.pair].points[1 - step.body];
  }

  /// The border that this point lies farthest beyond, or least inside of.
  [[nodiscard]] const cells::Border& border(const Step& step) const {
    return features[step.body][feature(step)].tightest(point(step));
  }

  std::array<std::vector<cells::Feature>, 2> features;  ///< Those of X and Y.
  std::vector<Pair> pairs;
  /// Body and vertex of those that reach into the slab of the first pair, from either side.
  std::vector<std::pair<std::size_t, int>> reaches;
  std::vector<Step> all;  ///< None where a body is flat, or two bodies overlap.
};

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const RegionsTrace& regions_trace(const AlgorithmTrace& trace) {
  return static_cast<const RegionsTrace&>(trace);
}

}  // namespace gjkscope
