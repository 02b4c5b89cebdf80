#pragma once
// Walks to all support points of a run of GJK, on the polyhedra of a lesson. Each starts where the
// last one on its shape ended.

#include "lesson/algorithm.hpp"
#include "run/run.hpp"
#include "subjects/hill_climbing/climb.hpp"

namespace gjkscope {

extern const Algorithm kHillClimbingAlgorithm;

/// One walk, to the support point of X or Y that GJK asks for.
struct Climb {
  int iteration = 0;  ///< GJK's.
  bool of_x = false;
  climbing::Walk walk;
  int scanned = 0;  ///< The vertex that GJK's scan takes.
};

class ClimbTrace final : public AlgorithmTrace {
 public:
  struct Step {
    int climb = 0;
    int look = 0;
  };

  [[nodiscard]] int steps() const override { return static_cast<int>(all.size()); }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const override;

  [[nodiscard]] const Climb& climb(int step) const { return climbs[all[step].climb]; }
  [[nodiscard]] const climbing::Look& look(int step) const {
    return climb(step).walk.looks[all[step].look];
  }
  /// Dot products of walks before `step`.
  [[nodiscard]] int walked(int step) const;

  std::vector<Climb> climbs;
  std::vector<Step> all;                           ///< Walk by walk, and vertex by vertex.
  std::array<climbing::Neighbours, 2> neighbours;  ///< Those of X and Y.
  int scanned = 0;                                 ///< Dot products of the scans.
};

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const ClimbTrace& climbs_trace(const AlgorithmTrace& trace) {
  return static_cast<const ClimbTrace&>(trace);
}

}  // namespace gjkscope
